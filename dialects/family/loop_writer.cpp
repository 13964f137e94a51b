// A loop is one WHILE, with an index of its own where its name is not the count.
#include "dialects/family/loop_writer.h"

#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

namespace dripfeed::family {

namespace {

using ir::ExpressionId;
using ir::Operator;
using ir::StatementKind;

// Added to the quotient before it is cut to a whole number: up to the next one, but not for a millionth of a step.
constexpr double kTripRounding = 0.999999;
constexpr double kBackward = -0.000001;

}  // namespace

// A condition that takes statements is found in the loop:
//   go_on = 1;  while go_on = 1;  statements;  if condition;  body;  else;  go_on = 0;  end;  end
void LoopWriter::while_begin(const Step& step) {
  if (!values_.needs_statements(step.values[0])) {
    emit_.open(StatementKind::while_begin, values_.copy(step.values[0]));
    return conditions_.push_back(ir::SymbolId::none);
  }
  const ir::SymbolId go_on = emit_.new_symbol("go_on");
  emit_.assign(go_on, emit_.constant(1.0));
  emit_.open(StatementKind::while_begin, emit_.binary(Operator::equal, emit_.variable(go_on), emit_.constant(1.0)));
  emit_.open(StatementKind::if_begin, values_.copy(step.values[0]));
  conditions_.push_back(go_on);
}

void LoopWriter::while_end() {
  const ir::SymbolId go_on = conditions_.back();
  conditions_.pop_back();
  if (go_on != ir::SymbolId::none) {
    emit_.close(StatementKind::else_begin);
    emit_.assign(go_on, emit_.constant(0.0));
    emit_.close(StatementKind::if_end);
  }
  emit_.close(StatementKind::while_end);
}

// index = 0; while index < count: target = list[index]
void LoopWriter::for_in_begin(const Step& step) {
  const List& list = family_.lists[static_cast<std::size_t>(step.number)];
  const std::string name(program_.strings.at(program_.at(step.target).name));
  const ir::SymbolId index = emit_.new_symbol(fmt::format("{}_index", name));
  emit_.assign(index, emit_.constant(0.0));
  emit_.open(StatementKind::while_begin,
             emit_.binary(Operator::less, emit_.variable(index), emit_.constant(names_.value_of(list.count))));
  emit_.assign(step.target, emit_.variable(list.symbol, emit_.variable(index)));
  loops_.push_back({index, Operator::add});
}

// last = trunc((to - from)/step + 0.999999); while index <= last: t = from + index*step, and exactly `to` at last.
void LoopWriter::for_begin(const Step& step) {
  const std::string name(program_.strings.at(program_.at(step.target).name));
  const ValueWriter::Bound from = values_.bound(step.values[0], fmt::format("{}_from", name));
  const ValueWriter::Bound to = values_.bound(step.values[1], fmt::format("{}_to", name));
  if (names_.counts_whole(step)) return count_begin(step, from, to);
  const ValueWriter::Bound by = values_.bound(step.values[2], fmt::format("{}_step", name));
  const ExpressionId distance = step.down ? values_.calculate(Operator::subtract, values_.say(from), values_.say(to))
                                          : values_.calculate(Operator::subtract, values_.say(to), values_.say(from));
  const ExpressionId trips = values_.calculate(Operator::divide, distance, values_.say(by));
  const ValueWriter::Bound last = last_trip(trips, name);
  const ir::SymbolId index = emit_.new_symbol(fmt::format("{}_index", name));
  emit_.assign(index, emit_.constant(0.0));
  emit_.open(StatementKind::while_begin, emit_.binary(Operator::less_equal, emit_.variable(index), values_.say(last)));
  const ExpressionId gone = values_.calculate(Operator::multiply, emit_.variable(index), values_.say(by));
  emit_.assign(step.target, values_.calculate(step.down ? Operator::subtract : Operator::add, values_.say(from), gone));
  emit_.open(StatementKind::if_begin, emit_.binary(Operator::greater_equal, emit_.variable(index), values_.say(last)));
  emit_.assign(step.target, values_.say(to));
  emit_.close(StatementKind::if_end);
  loops_.push_back({index, Operator::add});
}

// The number of the last trip, from 0; less than 0 where there is none.
ValueWriter::Bound LoopWriter::last_trip(ExpressionId trips, std::string_view name) {
  if (const std::optional<double> known = values_.number(trips))
    return {.value = *known < kBackward ? -2.0 : std::trunc(*known + kTripRounding)};
  const ValueWriter::Bound last{.symbol = emit_.new_symbol(fmt::format("{}_last", name))};
  emit_.assign(last.symbol, trips);
  // Cutting goes toward zero, so a path that leads back must not come to it.
  emit_.open(StatementKind::if_begin, emit_.binary(Operator::less, values_.say(last), emit_.constant(kBackward)));
  emit_.assign(last.symbol, emit_.constant(-2.0));
  emit_.close(StatementKind::if_end);
  const ExpressionId raised = emit_.binary(Operator::add, values_.say(last), emit_.constant(kTripRounding));
  emit_.assign(last.symbol, program_.add_operator(Operator::truncate, raised));
  return last;
}

// The name counts itself.
void LoopWriter::count_begin(const Step& step, const ValueWriter::Bound& from, const ValueWriter::Bound& to) {
  emit_.assign(step.target, values_.say(from));
  emit_.open(StatementKind::while_begin, emit_.binary(step.down ? Operator::greater_equal : Operator::less_equal,
                                                      emit_.variable(step.target), values_.say(to)));
  loops_.push_back({step.target, step.down ? Operator::subtract : Operator::add});
}

void LoopWriter::for_end() {
  const Loop loop = loops_.back();
  loops_.pop_back();
  emit_.assign(loop.index, emit_.binary(loop.next, emit_.variable(loop.index), emit_.constant(1.0)));
  emit_.close(StatementKind::while_end);
}

}  // namespace dripfeed::family
