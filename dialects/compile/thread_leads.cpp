// Behind the last block of a thread the feed is said again as it is there.
#include "dialects/compile/thread_leads.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "dialects/compile/lathe_flow.h"
#include "dialects/passes/rewrite.h"

namespace dripfeed::compile {

namespace {

using ir::Address;
using ir::ExpressionId;
using ir::Function;
using ir::StatementKind;

class Leads {
 public:
  Leads(ir::Program& program, const ir::Control& from, const ir::Control& to)
      : program_(program), from_(from), to_(to), flow_(program, from), out_(program) {}

  std::vector<text::Diagnostic> run() {
    const auto count = static_cast<std::uint32_t>(program_.statements.size());
    for (index_ = 0; index_ < count; ++index_) {
      out_.at(index_);
      statement_ = program_.statements[index_];
      if (!cuts_thread(index_)) {
        out_.keep();
        continue;
      }
      const LatheState& before = *flow_.before(index_);
      const ir::Block block = program_.blocks[statement_.payload];
      leads_by_letters(to_) ? feed_as_lead(before, block) : lead_as_feed(before, block);
    }
    out_.finish();
    return std::move(diagnostics_);
  }

 private:
  // A block of a thread; where K, I or J say leads, with one of these.
  [[nodiscard]] bool cuts_thread(std::uint32_t index) const {
    const ir::Statement& s = program_.statements[index];
    const LatheState* state = flow_.before(index);
    if (s.kind != StatementKind::block || state == nullptr) return false;
    const ir::Block& block = program_.blocks[s.payload];
    const auto codes = program_.codes_of(block);
    const auto motion = std::ranges::find(codes, ir::ModalGroup::motion, &ir::Code::group);
    const bool thread =
        motion == codes.end() ? state->motion.is(Function::thread) : motion->function == Function::thread;
    if (!thread || has_own_words(program_, block)) return false;
    return leads_by_letters(from_) ? std::ranges::any_of(program_.words_of(block), is_lead) : moves_axes(block);
  }
  [[nodiscard]] bool thread_goes_on() const {
    return index_ + 1 < program_.statements.size() && !program_.statements[index_ + 1].is_label &&
           cuts_thread(index_ + 1);
  }
  static bool is_lead(const ir::Word& w) { return w.address >= Address::i && w.address <= Address::k; }

  void lead_as_feed(const LatheState& before, const ir::Block& block) {
    if (block.rest_level != 0) return cannot("block skip inside a block");
    const std::vector<ir::Code> codes(program_.codes_of(block).begin(), program_.codes_of(block).end());
    std::vector<ir::Word> words;
    std::optional<double> feed = before.feed.value;
    for (const ir::Word& w : program_.words_of(block)) {
      if (w.address == Address::f) feed = flow_.feed_of(w, index_);
      if (w.address == Address::f) continue;
      words.push_back(w);
      if (is_lead(w)) words.back().address = Address::f;
    }
    out_.emit_block(codes, words);
    if (thread_goes_on()) return;
    if (!feed && flow_.needs_feed(index_)) cannot("the feed behind a thread, which is not known here,");
    if (feed && *feed != 0.0) out_.emit_block({}, {word(Address::f, constant(*feed))});
  }

  // The lead stays in effect as a feed there, and is said in each block here.
  void feed_as_lead(const LatheState& before, const ir::Block& block) {
    if (block.rest_level != 0) return out_.keep();
    const std::vector<ir::Code> codes(program_.codes_of(block).begin(), program_.codes_of(block).end());
    std::vector<ir::Word> words(program_.words_of(block).begin(), program_.words_of(block).end());
    const auto written = std::ranges::find(words, Address::f, &ir::Word::address);
    const bool known = before.feed.value && *before.feed.value != 0.0;
    if (written == words.end() && !known) return cannot("the lead of a thread, not known here,");
    ir::Word lead = written == words.end() ? word(Address::f, constant(*before.feed.value)) : *written;
    if (written == words.end()) words.push_back(lead);
    out_.emit_block(codes, words);
    if (!thread_goes_on() && flow_.needs_feed(index_)) out_.emit_block({}, {lead});
  }

  [[nodiscard]] bool moves_axes(const ir::Block& block) const {
    return std::ranges::any_of(program_.words_of(block),
                               [&](const ir::Word& w) { return turning_axis(w.address, from_).has_value(); });
  }
  ExpressionId constant(double value) { return program_.add_constant(value, {}, true); }
  void cannot(std::string what) {
    diagnostics_.push_back(
        text::make_diagnostic(text::DiagnosticId::cannot_translate, statement_.span, {std::move(what), to_.title}));
  }

  ir::Program& program_;
  const ir::Control& from_;
  const ir::Control& to_;
  LatheFlow flow_;
  passes::Rewrite out_;
  std::uint32_t index_ = 0;
  ir::Statement statement_;
  std::vector<text::Diagnostic> diagnostics_;
};

}  // namespace

bool leads_by_letters(const ir::Control& control) { return !control.semantics.arc_radius_is_r; }

std::vector<text::Diagnostic> settle_leads(ir::Program& program, const ir::Control& from, const ir::Control& to) {
  const bool threads = std::ranges::find(program.codes, Function::thread, &ir::Code::function) != program.codes.end();
  const bool differ = leads_by_letters(from) != leads_by_letters(to);
  return threads && differ ? Leads(program, from, to).run() : std::vector<text::Diagnostic>();
}

}  // namespace dripfeed::compile
