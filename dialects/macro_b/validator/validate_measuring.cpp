// Moves that a signal ends: the automatic measuring of a tool's length (G37; G36 and G37 of lathes), and skip moves
// (G31) with a feed of 0.
#include <algorithm>
#include <string>

#include "dialects/macro_b/validator/validate.h"

namespace dripfeed::macro_b {

namespace {

using ir::Address;
using ir::Function;
using ir::StatementKind;
using enum text::DiagnosticId;

class MeasuringCheck {
 public:
  MeasuringCheck(const ir::Program& program, const ir::Control& control, const Section& section, Findings& findings)
      : program_(program), control_(control), findings_(findings), number_known_(section.is_subprogram) {}

  void statement(const ir::Statement& s) {
    if (s.kind == StatementKind::block) block(program_.blocks[s.payload]);
    number_known_ |= s.kind == StatementKind::call || s.kind == StatementKind::native || s.kind == StatementKind::go_to;
  }

 private:
  void block(const ir::Block& block) {
    for (const ir::Code& code : program_.codes_of(block)) {
      if (code.function == Function::skip_move) feed_of_skip(block);
      if (code.function == Function::measure_tool) measuring(code, block);
    }
    number_known_ |= find(block, kNumber) != nullptr;
  }

  // The signal never comes to a tool that does not move.
  void feed_of_skip(const ir::Block& block) {
    const ir::Word* feed = find(block, Address::f);
    if (feed == nullptr || feed->value == ir::ExpressionId::none) return;
    const ir::Expression& value = program_.at(feed->value);
    if (value.op == ir::Operator::constant && value.value == 0.0)
      findings_.add(no_feed, feed->span, {}, ir::AlarmDetail::skip);
  }

  void measuring(const ir::Code& code, const ir::Block& block) {
    std::ptrdiff_t axes = 0;
    for (const ir::Word& word : program_.words_of(block)) axes += is_axis(control_, word.address) ? 1 : 0;
    if (axes != 1) add(code, "its block names no axis or several", ir::AlarmDetail::none);
    for (const Address address : {Address::h, Address::t})
      if (const ir::Word* word = find(block, address); word != nullptr && !is_axis(control_, address))
        return add(code, std::string(text_of(program_, word->span)) + " stands in its block",
                   ir::AlarmDetail::beside_tool);
    if (!number_known_ && control_.kind == ir::MachineKind::mill)
      add(code, "no offset number (H) stands before it", ir::AlarmDetail::without_offset);
  }

  void add(const ir::Code& code, std::string what, ir::AlarmDetail detail) {
    findings_.add(measuring_invalid, code.span, {std::string(text_of(program_, code.span)), std::move(what)}, detail);
  }

  [[nodiscard]] const ir::Word* find(const ir::Block& block, Address address) const {
    const auto words = program_.words_of(block);
    const auto word = std::ranges::find(words, address, &ir::Word::address);
    return word == words.end() ? nullptr : &*word;
  }

  static constexpr Address kNumber = Address::h;
  const ir::Program& program_;
  const ir::Control& control_;
  Findings& findings_;
  bool number_known_;
};

}  // namespace

void check_measuring(const ir::Program& program, const ir::Control& control, const Section& section,
                     Findings& findings) {
  MeasuringCheck check(program, control, section, findings);
  for (std::uint32_t i = section.first; i < section.last; ++i) check.statement(program.statements[i]);
}

}  // namespace dripfeed::macro_b
