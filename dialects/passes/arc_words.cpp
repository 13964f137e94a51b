// One look at each block: what motion it is in, and which words of an arc it has.
#include "dialects/passes/arc_words.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "dialects/facts/flow_graph.h"
#include "dialects/facts/resolved.h"
#include "dialects/passes/refusal.h"

namespace dripfeed::passes {

namespace {

using ir::Address;
using ir::Function;
using ir::ModalGroup;
using ir::StatementKind;

bool is_center(const ir::Word& w) {
  return w.address == Address::i || w.address == Address::j || w.address == Address::k;
}
bool is_radius(const ir::Word& w) { return w.address == Address::r || w.address == Address::arc_radius; }

// AR, AP and RP, a point in between.
bool is_other_form(const ir::Word& w) {
  return w.address == Address::opening_angle || w.address == Address::polar_angle ||
         w.address == Address::polar_radius || (w.address >= Address::via_i && w.address <= Address::via_k);
}

bool is_arc(Function f) { return f == Function::arc_cw || f == Function::arc_ccw; }

class ArcWords {
 public:
  ArcWords(ir::Program& program, const ir::Control& from, const ir::Control& to)
      : program_(program), to_(to), takes_radius_(from.semantics.arc_radius_is_r), facts_(program, from) {}

  std::vector<text::Diagnostic> run() {
    for (std::uint32_t i = 0; i < program_.statements.size(); ++i) {
      if (facts::section_of(program_, i).first == i) arc_ = false;
      const ir::Statement& s = program_.statements[i];
      // A missing centre is an alarm there: only where it is certain.
      if (!takes_radius_) arc_ = is_in_arc(i);
      if (s.kind == StatementKind::block) block(s);
    }
    return std::move(diagnostics_);
  }

 private:
  [[nodiscard]] bool is_in_arc(std::uint32_t statement) const {
    const std::optional<facts::Setting> motion = facts_.certain(facts::Mode::motion, statement);
    return motion && is_arc(motion->function);
  }
  void block(const ir::Statement& s) {
    ir::Block& block = program_.blocks[s.payload];
    bool words_of_another = false;
    for (const ir::Code& c : program_.codes_of(block)) {
      if (c.group == ModalGroup::motion || c.group == ModalGroup::cycle) arc_ = is_arc(c.function);
      if (c.number != ir::ExpressionId::none && c.letter == 'G') arc_ = false;
      const bool in_its_motion = c.function == Function::exact_stop_once || c.function == Function::no_effect;
      words_of_another |= (c.group == ModalGroup::non_modal && !in_its_motion) || c.group == ModalGroup::frame ||
                          c.function == Function::not_modelled;
    }
    if (!arc_ || words_of_another) return;
    const auto words = program_.words_of(block);
    const bool center = std::ranges::any_of(words, is_center);
    const bool radius = std::ranges::any_of(words, is_radius);
    if (center && radius && takes_radius_ && block.rest_level == 0) return take_radius(block);
    if (center || radius || std::ranges::any_of(words, is_other_form) ||
        std::ranges::none_of(words, ir::is_axis, &ir::Word::address))
      return;
    diagnostics_.push_back(passes::diagnose(passes::of_shape("an arc without a centre or radius"), s.span, to_.title));
  }

  void take_radius(ir::Block& block) {
    std::vector<ir::Word> kept;
    std::ranges::copy_if(program_.words_of(block), std::back_inserter(kept),
                         [](const ir::Word& w) { return !is_center(w); });
    // In place: fewer words than before.
    std::ranges::copy(kept, program_.words.begin() + block.first_word);
    block.word_count = static_cast<std::uint32_t>(kept.size());
  }

  ir::Program& program_;
  const ir::Control& to_;
  bool takes_radius_;  // where there is a centre, too
  facts::Resolved facts_;
  bool arc_ = false;
  std::vector<text::Diagnostic> diagnostics_;
};

}  // namespace

std::vector<text::Diagnostic> translate_arcs(ir::Program& program, const ir::Control& from, const ir::Control& to) {
  if (from.dialect == to.dialect) return {};
  return ArcWords(program, from, to).run();
}

}  // namespace dripfeed::passes
