// Moves that a signal ends: the automatic measuring of a tool's length (G37; G36 and G37 of lathes), and skip moves
// (G31) with a feed of 0.
#include <algorithm>
#include <string>

#include "dialects/facts/in_effect.h"
#include "dialects/macro_b/validator/validate.h"

namespace dripfeed::macro_b {

namespace {

using ir::Address;
using ir::Function;
using ir::StatementKind;
using enum text::DiagnosticId;

class MeasuringCheck {
 public:
  MeasuringCheck(const ir::Program& program, const ir::Control& control, const facts::Resolved& facts,
                 const Section& section, Findings& findings)
      : program_(program), control_(control), findings_(findings), in_effect_(program, facts, !section.is_subprogram) {}

  void statement(std::uint32_t at) {
    const ir::Statement& s = program_.statements[at];
    if (s.kind != StatementKind::block) return;
    const ir::Block& block = program_.blocks[s.payload];
    for (const ir::Code& code : program_.codes_of(block)) {
      if (code.function == Function::skip_move) feed_of_skip(block);
      if (code.function != Function::measure_tool) continue;
      in_effect_.at(at);
      measuring(code, block);
    }
  }

 private:
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
                   ir::AlarmDetail::with_tool);
    if (in_effect_.lacks(facts::Number::length_number) && control_.kind == ir::MachineKind::mill)
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

  const ir::Program& program_;
  const ir::Control& control_;
  Findings& findings_;
  facts::InEffect in_effect_;
};

}  // namespace

StatementCheck measuring_check(const ir::Program& program, const ir::Control& control, const facts::Resolved& facts,
                               const Section& section, Findings& findings) {
  return [check = MeasuringCheck(program, control, facts, section, findings)](std::uint32_t i) mutable {
    check.statement(i);
  };
}

}  // namespace dripfeed::macro_b
