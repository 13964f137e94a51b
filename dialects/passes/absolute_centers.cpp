// Places are followed in the order of the text and forgotten where paths meet, where coordinates change and where
// something else may have moved.
#include "dialects/passes/absolute_centers.h"

#include <algorithm>
#include <array>
#include <optional>

#include "dialects/passes/refusal.h"

namespace dripfeed::passes {

namespace {

using ir::Address;
using ir::ExpressionId;
using ir::Function;
using ir::ModalGroup;
using ir::Operator;
using ir::StatementKind;

constexpr std::uint32_t kEndOfBlock = 5001;  // of the first axis
constexpr std::size_t kAxes = 3;

// X and I: 0, Y and J: 1, Z and K: 2.
std::optional<std::size_t> axis_of(Address a) {
  if (a < Address::x || a > Address::z) return std::nullopt;
  return static_cast<std::size_t>(a) - static_cast<std::size_t>(Address::x);
}
std::optional<std::size_t> center_of(const ir::Word& w) {
  if (w.address < Address::i || w.address > Address::k || w.mode != ir::WordMode::absolute) return std::nullopt;
  return static_cast<std::size_t>(w.address) - static_cast<std::size_t>(Address::i);
}

class Centers {
 public:
  Centers(ir::Program& program, const ir::Control& from, const ir::Control& to)
      : program_(program), to_(to), mill_(from.kind == ir::MachineKind::mill && to.kind == ir::MachineKind::mill) {
    for (const ir::Code& c : program.codes) {
      turned_ |= c.function == Function::rotate || c.function == Function::scale || c.function == Function::mirror ||
                 c.function == Function::transformation;
      increments_ |= c.function == Function::incremental;
    }
  }

  std::vector<text::Diagnostic> run() {
    for (const ir::Statement& s : program_.statements) {
      if (s.is_label || s.kind > StatementKind::assign) forget();
      if (s.kind == StatementKind::block) block(s);
    }
    return std::move(diagnostics_);
  }

 private:
  void forget() { known_.fill(std::nullopt); }

  void block(const ir::Statement& s) {
    const ir::Block block = program_.blocks[s.payload];
    bool other_words = false;
    for (const ir::Code& c : program_.codes_of(block)) {
      absolute_ |= c.function == Function::absolute;
      const bool elsewhere = c.group == ModalGroup::frame || c.group == ModalGroup::work_offset ||
                             c.group == ModalGroup::unit || c.function == Function::machine_coordinates ||
                             c.function == Function::reference_return || c.function == Function::tool_change ||
                             c.function == Function::machine_function || c.function == Function::not_modelled;
      if (elsewhere) forget();
      other_words |= c.group == ModalGroup::frame || c.group == ModalGroup::non_modal;
    }
    for (std::uint32_t k = block.first_word; k < block.first_word + block.word_count; ++k)
      if (const auto axis = center_of(program_.words[k])) center(s, program_.words[k], *axis);
    if (other_words || block.rest_level != 0 || s.skip_level != 0) return forget();
    for (const ir::Word& w : program_.words_of(block)) move(w);
  }

  void center(const ir::Statement& s, ir::Word& w, std::size_t axis) {
    if (!mill_ || (turned_ && !known_[axis])) {
      diagnostics_.push_back(passes::diagnose(
          passes::not_known("an absolute arc centre, whose start is not known here,"), s.span, to_.title));
      return;
    }
    w.mode = ir::WordMode::as_modal;
    const ir::Expression e = program_.at(w.value);
    if (known_[axis] && e.op == Operator::constant) {
      w.value = program_.add_constant(e.value - *known_[axis], e.span);
      return;
    }
    ir::Variable end;
    end.number = kEndOfBlock + static_cast<std::uint32_t>(axis);
    const ExpressionId start = known_[axis] ? program_.add_constant(*known_[axis]) : program_.add_variable(end);
    w.value = program_.add_operator(Operator::subtract, w.value, start, e.span);
  }

  // Where modes are left to others, only words that say it themselves are places.
  void move(const ir::Word& w) {
    if (w.address == Address::t || w.address == Address::d || w.address >= Address::polar_angle) return forget();
    const auto axis = axis_of(w.address);
    if (!axis) return;
    const ir::Expression& e = program_.at(w.value);
    const bool place =
        w.mode == ir::WordMode::absolute || (w.mode == ir::WordMode::as_modal && absolute_ && !increments_);
    std::optional<double>& known = known_[*axis];
    if (e.op != Operator::constant || (!place && w.mode != ir::WordMode::incremental))
      known.reset();
    else if (place)
      known = e.value;
    else if (known)
      *known += e.value;
  }

  ir::Program& program_;
  const ir::Control& to_;
  std::array<std::optional<double>, kAxes> known_;
  bool mill_;
  bool turned_ = false;
  bool increments_ = false;  // G91 somewhere in the text
  bool absolute_ = false;    // G90 was stated
  std::vector<text::Diagnostic> diagnostics_;
};

}  // namespace

std::vector<text::Diagnostic> translate_centers(ir::Program& program, const ir::Control& from, const ir::Control& to) {
  if (from.dialect == to.dialect || to.semantics.arc_radius_is_r == from.semantics.arc_radius_is_r) return {};
  const bool any = std::ranges::any_of(program.words, [](const ir::Word& w) { return center_of(w).has_value(); });
  return any && to.semantics.arc_radius_is_r ? Centers(program, from, to).run() : std::vector<text::Diagnostic>();
}

}  // namespace dripfeed::passes
