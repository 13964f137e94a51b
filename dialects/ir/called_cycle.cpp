// Look-ups in a few dozen values.
#include "dialects/ir/called_cycle.h"

#include <algorithm>

namespace dripfeed::ir {

std::size_t place_of(const CalledCycle& cycle, CycleValue value) {
  const auto found = std::ranges::find(cycle.values, value);
  return found == cycle.values.end() ? kNoPlace : static_cast<std::size_t>(found - cycle.values.begin());
}

ExpressionId value_of(const Program& program, const Call& call, CycleValue value) {
  const std::span<const Argument> given = program.arguments_of(call);
  const std::size_t place = place_of(*call.cycle, value);
  return place < given.size() ? given[place].value : ExpressionId::none;
}

std::optional<double> number_of(const Program& program, const Call& call, CycleValue value) {
  const ExpressionId id = value_of(program, call, value);
  if (id == ExpressionId::none) return std::nullopt;
  const Expression& e = program.at(id);
  if (e.op == Operator::constant) return e.value;
  const bool is_negative = e.op == Operator::negate && program.at(e.a).op == Operator::constant;
  return is_negative ? std::optional(-program.at(e.a).value) : std::nullopt;
}

std::span<const Argument> arguments_after(const Program& program, const Call& call, CycleValue value) {
  const std::span<const Argument> given = program.arguments_of(call);
  const std::size_t place = place_of(*call.cycle, value);
  return place < given.size() ? given.subspan(place + 1) : std::span<const Argument>();
}

}  // namespace dripfeed::ir
