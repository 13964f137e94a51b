// The arguments of macro calls: letters there, positions here.
//
//   G65 P9011 A1. X#1               L9011(1,,,,,,,,,,,,,,,,,,ARG_A)
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/passes/macro_arguments.h"
#include "dialects/passes/refusal.h"
#include "dialects/sinumerik/writer/raise.h"

namespace dripfeed::sinumerik {

namespace {

using ir::ExpressionId;
using ir::Operator;
using ir::StatementKind;

constexpr std::string_view kLengthLetters = "ABCIJKQRUVWXYZ";  // count increments when written without a point

class Arguments {
 public:
  explicit Arguments(const Raising& raising) : raising_(raising), program_(raising.program) {
    const auto& codes = program_.codes;
    inch_ = raising.from.semantics.power_on_unit == ir::Function::unit_inch ||
            std::ranges::find(codes, ir::Function::unit_inch, &ir::Code::function) != codes.end();
  }

  void call(const ir::Statement& s) {
    ir::Call call = program_.calls[s.payload];
    if (call.argument_count == 0) return;
    std::vector<ExpressionId> values;
    char last_center = 0;
    for (std::uint32_t i = 0; i < call.argument_count; ++i) {
      const ir::Argument argument = program_.arguments[call.first_argument + i];
      const auto position = passes::position_of_letter(argument.letter);
      const bool center = argument.letter >= 'I' && argument.letter <= 'K';
      if (!position) return raising_.cannot(passes::of_call(std::string("the argument ") + argument.letter), s.span);
      if (center && argument.letter <= last_center)
        return raising_.cannot(passes::of_call("arguments of the second kind (I J K more than once)"), s.span);
      if (center) last_center = argument.letter;
      if (values.size() <= *position) values.resize(*position + 1, ExpressionId::none);
      if (values[*position] != ExpressionId::none)
        return raising_.cannot(passes::together("an argument that is given twice"), s.span);
      values[*position] = value(argument, s.span);
    }
    call.first_argument = static_cast<std::uint32_t>(program_.arguments.size());
    call.argument_count = static_cast<std::uint32_t>(values.size());
    for (const ExpressionId value : values) program_.arguments.push_back({0, value});
    program_.calls[s.payload] = call;
  }

 private:
  ExpressionId value(const ir::Argument& argument, text::Span span) {
    const ir::Expression e = program_.at(argument.value);
    const ir::Semantics& from = raising_.from.semantics;
    const bool counts = e.op == Operator::constant && !e.has_point && kLengthLetters.contains(argument.letter) &&
                        from.decimal_mode == ir::DecimalMode::least_increment;
    if (!counts) return argument.value;
    if (inch_ && e.value != 0.0) raising_.cannot(passes::by_parameter("an argument without a point, in inches,"), span);
    return program_.add_constant(e.value * from.least_increment_mm, e.span);
  }

  const Raising& raising_;
  ir::Program& program_;
  bool inch_ = false;
};

}  // namespace

void raise_macro_calls(const Raising& raising) {
  if (!raising.from.semantics.has_vacant) return;
  Arguments arguments(raising);
  for (const ir::Statement& s : raising.program.statements)
    if (s.kind == StatementKind::call || s.kind == StatementKind::modal_call) arguments.call(s);
}

}  // namespace dripfeed::sinumerik
