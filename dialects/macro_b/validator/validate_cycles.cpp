// Cycles: pecks without a depth and taps without a speed, which all paths to them lack; shapes that are not there or
// cannot be cut.
#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include <fmt/format.h>

#include "dialects/facts/in_effect.h"
#include "dialects/ir/cycle.h"
#include "dialects/macro_b/validator/validate.h"
#include "dialects/text/number.h"

namespace dripfeed::macro_b {

namespace {

using facts::Kept;
using ir::Address;
using ir::DrillCycle;
using ir::Function;
using ir::StatementKind;
using enum text::DiagnosticId;

const ir::Word* find_word(std::span<const ir::Word> words, Address address) {
  const auto found = std::ranges::find(words, address, &ir::Word::address);
  return found == words.end() ? nullptr : &*found;
}

bool is_peck(DrillCycle cycle) { return cycle == DrillCycle::deep_hole || cycle == DrillCycle::chip_break; }
bool is_tap(DrillCycle cycle) { return cycle == DrillCycle::tap_right || cycle == DrillCycle::tap_left; }

class CycleCheck {
 public:
  CycleCheck(const ir::Program& program, const ir::Control& control, const facts::Resolved& facts,
             const Section& section, Findings& findings)
      : program_(program),
        control_(control),
        findings_(findings),
        labels_(program, section),
        in_effect_(program, facts, !section.is_subprogram) {}

  void statement(std::uint32_t at) {
    const ir::Statement& s = program_.statements[at];
    if (s.kind != StatementKind::block) return;
    const ir::Block& block = program_.blocks[s.payload];
    const auto words = program_.words_of(block);
    for (const ir::Code& code : program_.codes_of(block)) {
      if (code.function == Function::drill) drill(at, code, words);
      if (ir::follows_shape(code)) shape(at, code, words);
    }
  }

 private:
  void drill(std::uint32_t at, const ir::Code& code, std::span<const ir::Word> words) {
    in_effect_.at(at);
    const auto cycle = static_cast<DrillCycle>(code.argument % ir::kDrillAlongZ);
    if (is_peck(cycle) && control_.semantics.pecks_need_depth && lacks_depth(words))
      findings_.add(peck_without_depth, code.span);
    const bool lacks_speed = in_effect_.lacks(Kept::speed) && find_word(words, Address::s) == nullptr;
    if (!is_tap(cycle) || !lacks_speed || speed_reported_) return;
    text::Diagnostic* finding =
        findings_.add(tap_without_speed, code.span, {std::string(text_of(program_, code.span))});
    if (finding != nullptr && finding->alarm.empty()) finding->severity = text::Severity::warning;
    speed_reported_ = true;
  }

  // Q stays from one cycle to the next until G80 or a motion code ends them.
  [[nodiscard]] bool lacks_depth(std::span<const ir::Word> words) const {
    if (find_word(words, Address::q) != nullptr) return false;
    const std::optional<facts::Setting> before = in_effect_.certain(facts::Mode::cycle);
    return before && (before->function != Function::drill || in_effect_.lacks(Kept::drill_peck));
  }

  [[nodiscard]] std::optional<std::uint32_t> number_of(const ir::Word* word) const {
    if (word == nullptr || word->value == ir::ExpressionId::none) return std::nullopt;
    const ir::Expression& value = program_.at(word->value);
    if (value.op != ir::Operator::constant || value.value < 1.0 || value.value > 99'999'999.0) return std::nullopt;
    return static_cast<std::uint32_t>(value.value);
  }

  // G70 to G73 P(first block) Q(last block).
  void shape(std::uint32_t at, const ir::Code& code, std::span<const ir::Word> words) {
    pass(code, words);
    if ((find_word(words, Address::p) == nullptr) != (find_word(words, Address::q) == nullptr) ||
        (ir::is_cycle(code, ir::RepetitiveCycle::finish) && find_word(words, Address::p) == nullptr))
      findings_.add(cycle_shape_invalid, code.span, {"its first (P) or its last block (Q) is not named"},
                    ir::AlarmDetail::no_shape);
    const auto first = number_of(find_word(words, Address::p));
    const auto last = number_of(find_word(words, Address::q));
    if (!first || !last) return;
    const ir::Label* begin = labels_.find(*first, at);
    const ir::Label* end = begin == nullptr ? nullptr : labels_.find(*last, begin->statement);
    if (end == nullptr || end->statement < begin->statement) {
      findings_.add(cycle_shape_missing, code.span, {fmt::format("{}", *first), fmt::format("{}", *last)});
      return;
    }
    for (const ir::Label* label : {begin, end}) named_twice(code, *label);
    if (!begins_straight(begin->statement))
      findings_.add(cycle_shape_invalid, code.span, {fmt::format("N{} is not a G00 or G01 move", *first)});
    blocks_of(code, *begin, *end);
  }

  // Which of the two the control takes, depends on where it begins to look.
  void named_twice(const ir::Code& code, const ir::Label& label) {
    const ir::Label* other = labels_.other(label);
    if (other == nullptr || !reported_.insert(label.number).second) return;
    text::Diagnostic* finding = findings_.add(label_defined_twice, other->span, {fmt::format("N{}", label.number)});
    if (finding != nullptr) finding->notes.push_back({code.span, "the cycle that names it"});
  }

  // The first of two blocks: G71 U(depth), G72 W(depth), G73 R(passes).
  void pass(const ir::Code& code, std::span<const ir::Word> words) {
    constexpr Address kPass[] = {Address::other, Address::u, Address::w, Address::r};
    const ir::Word* depth =
        ir::is_cycle(code, ir::RepetitiveCycle::finish) ? nullptr : find_word(words, kPass[code.argument]);
    if (depth == nullptr || find_word(words, Address::p) != nullptr || depth->value == ir::ExpressionId::none) return;
    const ir::Expression& value = program_.at(depth->value);
    if (value.op == ir::Operator::constant && value.value <= 0.0)
      findings_.add(cycle_shape_invalid, code.span,
                    {fmt::format("{} takes nothing off", text_of(program_, depth->span))},
                    ir::AlarmDetail::depth_of_pass);
  }

  [[nodiscard]] bool begins_straight(std::uint32_t at) const {
    const ir::Statement& s = program_.statements[at];
    if (s.kind != StatementKind::block) return false;
    return std::ranges::any_of(program_.codes_of(program_.blocks[s.payload]), [](const ir::Code& c) {
      return c.number != ir::ExpressionId::none || c.function == Function::rapid || c.function == Function::linear;
    });
  }

  void blocks_of(const ir::Code& code, const ir::Label& begin, const ir::Label& end) {
    std::uint32_t blocks = 0;
    for (std::uint32_t i = begin.statement; i <= end.statement; ++i) {
      const StatementKind kind = program_.statements[i].kind;
      if (kind == StatementKind::call || kind == StatementKind::subprogram_return || kind == StatementKind::return_to) {
        findings_.add(cycle_shape_invalid, code.span,
                      {fmt::format("{} stands in it", text_of(program_, program_.statements[i].span))},
                      ir::AlarmDetail::call_in_shape);
      }
      blocks += kind == StatementKind::block ? 1 : 0;
    }
    last_block(code, end);
    const std::uint32_t most = control_.limits.shape_blocks;
    if (most != 0 && blocks > most)
      findings_.add(cycle_shape_too_long, code.span, {fmt::format("{}", blocks), fmt::format("{}", most)});
  }

  // A corner needs the move after it, and the shape has none.
  void last_block(const ir::Code& code, const ir::Label& end) {
    const ir::Statement& s = program_.statements[end.statement];
    if (s.kind != StatementKind::block) return;
    for (const ir::Word& word : program_.words_of(program_.blocks[s.payload])) {
      if (word.address != Address::chamfer && word.address != Address::rounding) continue;
      findings_.add_own(cycle_shape_invalid, code.span,
                        {fmt::format("its last block ends in the corner {}", text_of(program_, word.span))},
                        ir::AlarmDetail::last_of_shape);
    }
  }

  const ir::Program& program_;
  const ir::Control& control_;
  Findings& findings_;
  LabelIndex labels_;
  facts::InEffect in_effect_;
  bool speed_reported_ = false;
  std::set<std::uint32_t> reported_;  // block numbers
};

}  // namespace

StatementCheck cycles_check(const ir::Program& program, const ir::Control& control, const facts::Resolved& facts,
                            const Section& section, Findings& findings) {
  return
      [check = CycleCheck(program, control, facts, section, findings)](std::uint32_t i) mutable { check.statement(i); };
}

}  // namespace dripfeed::macro_b
