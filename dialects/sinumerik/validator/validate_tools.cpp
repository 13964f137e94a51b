// Compensation where no tool edge is active, and constant surface speed without a speed: what all paths to a block
// lack. A subprogram may have them from its caller.
#include <algorithm>

#include "dialects/facts/in_effect.h"
#include "dialects/sinumerik/validator/validate.h"

namespace dripfeed::sinumerik {

namespace {

using facts::Kept;
using facts::Mode;
using ir::Address;
using ir::Function;
using ir::StatementKind;
using text::DiagnosticId;

bool is_number(const facts::Written* written, double number) {
  return written != nullptr && written->is_stated && written->is_number && written->number == number;
}

class Tools {
 public:
  Tools(const Check& check, const facts::Resolved& facts)
      : check_(check),
        in_effect_(check.program, facts, !may_have_caller(check.program)),
        has_surface_speed_(has_code(check.program, Function::surface_speed_on)) {}

  void statement(std::uint32_t at) {
    const ir::Statement& s = check_.program.statements[at];
    if (s.kind != StatementKind::block && s.kind != StatementKind::assign) return;
    in_effect_.at(at);
    if (s.kind == StatementKind::assign)
      offset_data(s);
    else
      block(check_.block_of(s));
  }

 private:
  void block(const ir::Block& block) {
    for (const ir::Code& code : check_.program.codes_of(block)) {
      in_effect_.take(code);
      if (code.function == Function::comp_left || code.function == Function::comp_right) compensation(code, block);
    }
    if (has_surface_speed_) surface_speed(block);
  }

  void compensation(const ir::Code& code, const ir::Block& block) {
    const text::Span off = off_in(block);
    if (!off.empty())
      check_.report(DiagnosticId::comp_without_tool, code.span,
                    {std::string(check_.text_of(code.span)), std::string(check_.text_of(off))});
  }

  // T0 or D0 that is in effect with the block; empty where an edge may be.
  [[nodiscard]] text::Span off_in(const ir::Block& block) const {
    const ir::Word* own = nullptr;
    for (const ir::Word& word : check_.program.words_of(block))
      if (word.address == Address::t || word.address == Address::d) own = &word;
    if (own == nullptr) return off();
    const ir::Expression& value = check_.program.at(own->value);
    return value.op == ir::Operator::constant && value.value == 0.0 ? own->span : text::Span{};
  }
  [[nodiscard]] text::Span off() const {
    const facts::Written* edge = in_effect_.certain(Kept::edge);
    if (edge == nullptr) return {};
    if (is_number(edge, 0.0)) return word_of(in_effect_.origin(Kept::edge), Address::d);
    const bool by_tool = !edge->is_stated && is_number(in_effect_.certain(Kept::tool), 0.0);
    return by_tool ? word_of(in_effect_.origin(Kept::tool), Address::t) : text::Span{};
  }
  [[nodiscard]] text::Span word_of(std::uint32_t statement, Address address) const {
    text::Span found;
    for (const ir::Word& word : check_.program.words_of(check_.block_of(check_.program.statements[statement])))
      if (word.address == address) found = word.span;
    return found;
  }

  // The speed may stand in the block of G96 or after it; the control remembers the last one.
  void surface_speed(const ir::Block& block) {
    const std::optional<facts::Setting> setting = in_effect_.stated(Mode::surface_speed);
    if (!setting || setting->function != Function::surface_speed_on || !in_effect_.lacks(Kept::surface_speed)) return;
    const auto words = check_.program.words_of(block);
    const bool has_speed = std::ranges::find(words, Address::s, &ir::Word::address) != words.end();
    const std::uint32_t origin = in_effect_.origin(Mode::surface_speed);
    if (has_speed || origin == reported_ || std::ranges::none_of(words, ir::is_axis, &ir::Word::address)) return;
    reported_ = origin;
    check_.report(DiagnosticId::surface_speed_missing, in_effect_.span(Mode::surface_speed));
  }

  // Data of the edge that is active.
  void offset_data(const ir::Statement& s) {
    const text::Span off_by = off();
    if (off_by.empty()) return;
    const auto data = std::ranges::find_if(check_.program.variables, [&](const ir::Variable& v) {
      return v.bank == ir::Bank::system && v.name != ir::StringId::none && s.span.begin <= v.span.begin &&
             v.span.end <= s.span.end && check_.program.strings.at(v.name) == "$P_AD";
    });
    if (data == check_.program.variables.end()) return;
    check_
        .report(DiagnosticId::comp_without_tool, data->span,
                {std::string(check_.text_of(data->span)), std::string(check_.text_of(off_by))})
        .alarm = "17160";
  }

  const Check& check_;
  facts::InEffect in_effect_;
  bool has_surface_speed_;                 // somewhere in the text
  std::uint32_t reported_ = ir::kNoIndex;  // the G96 without a speed that was reported
};

}  // namespace

StatementCheck tools_check(const Check& check, const facts::Resolved& facts) {
  return [tools = Tools(check, facts)](std::uint32_t i) mutable { tools.statement(i); };
}

}  // namespace dripfeed::sinumerik
