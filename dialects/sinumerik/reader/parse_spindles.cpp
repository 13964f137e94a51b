// Spindles by their numbers, and brought to an angle. (PG, "Positioning spindles", "Setting the master spindle".)
#include <optional>
#include <string>

#include "dialects/ir/other_spindle.h"
#include "dialects/sinumerik/reader/parse.h"
#include "dialects/sinumerik/tables/whole_number.h"

namespace dripfeed::sinumerik {

// SPOS=90 stops the main spindle, as M19 does, SPOS[2]=90 that spindle. The angle is stated.
void Parser::orientation(ir::StringId name, text::Span head, ir::ExpressionId spindle) {
  word(ir::Address::other, 0, name, head);
  if (faulty_ || lower_.is_native()) return;
  ir::Code code{.function = ir::Function::spindle_orient, .group = ir::ModalGroup::non_modal, .span = to_here(head)};
  if (spindle != ir::ExpressionId::none) {
    const std::optional<std::uint32_t> number = spindle_number(spindle);
    if (!number) return;  // not known which one
    if (*number != 1) {
      code.function = ir::Function::other_spindle;
      code.argument = ir::spindle_order(*number, ir::kOrientsSpindle);
      code.name = name;
    }
  }
  lower_.last_word_is(ir::kTurnsSpindle);
  lower_.add_aside(code, std::nullopt);
}

std::optional<std::uint32_t> Parser::spindle_number(ir::ExpressionId id) const {
  const ir::Expression& e = program_.at(id);
  if (e.op != ir::Operator::constant || !(e.value >= 1.0) || e.value > ir::kMostSpindles) return std::nullopt;
  const auto number = static_cast<std::uint32_t>(e.value);
  return number == e.value ? std::optional(number) : std::nullopt;
}

// SETMS(2), and SETMS or SETMS() for the usual one. Of a number that is computed nothing is known.
void Parser::main_spindle(text::Span head) {
  cursor_.advance();
  ir::Code code{.function = ir::Function::main_spindle, .group = ir::ModalGroup::non_modal, .span = head};
  code.name = lower_.name("SETMS");
  TokenCursor probe = cursor_;
  if (probe.is_symbol('(')) {
    probe.advance();
    const std::uint32_t number = probe.kind() == ir::TokenKind::number ? whole_number(probe.text()) : 0;
    const bool stated = probe.kind() == ir::TokenKind::number;
    if (stated) probe.advance();
    if (!probe.is_symbol(')') || (stated && (number == 0 || number > ir::kMostSpindles)))
      return native("SETMS", false, head);
    code.argument = static_cast<std::int16_t>(number);
    if (stated) code.name = lower_.name("SETMS(" + std::to_string(number) + ")");
    probe.advance();
    cursor_.go_to(probe.index());
  }
  code.span = to_here(head);
  lower_.add_code(code);
}

}  // namespace dripfeed::sinumerik
