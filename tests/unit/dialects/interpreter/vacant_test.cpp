// The vacant value, row by row of the controls' table (#0 and variables that were never set).
#include <gtest/gtest.h>

#include "tests/unit/dialects/interpreter/run_trace.h"

namespace dripfeed::test {
namespace {

using ir::Address;
using ir::Function;
using ir::Operator;
using Builder = ProgramBuilder;

// What #2 is after `#2 = expression(#1)`, with #1 vacant or 0.
template <class Make>
std::optional<double> result_with(bool vacant, Make make) {
  Builder b;
  if (!vacant) b.assign(Builder::hash(1), b.number(0));
  b.assign(Builder::hash(2), make(b, b.read(Builder::hash(1))));
  b.end();
  const Ran ran = run_program(b.build(), mill_control());
  EXPECT_EQ(ran.result.ended, interpreter::Ended::end);
  for (const auto& variable : ran.result.variables)
    if (variable.name == "#2") return variable.value;
  ADD_FAILURE() << "#2 is not listed";
  return std::nullopt;
}

TEST(Vacant, CopyStaysVacantAndArithmeticTakesZero) {
  const auto copy = [](Builder&, ir::ExpressionId x) { return x; };
  EXPECT_EQ(result_with(true, copy), std::nullopt);
  EXPECT_EQ(result_with(false, copy), 0.0);
  const auto times_five = [](Builder& b, ir::ExpressionId x) { return b.apply(Operator::multiply, x, b.number(5)); };
  EXPECT_EQ(result_with(true, times_five), 0.0);
  const auto twice = [](Builder& b, ir::ExpressionId x) { return b.apply(Operator::add, x, x); };
  EXPECT_EQ(result_with(true, twice), 0.0);
  const auto plus_one = [](Builder& b, ir::ExpressionId x) { return b.apply(Operator::add, x, b.number(1)); };
  EXPECT_EQ(result_with(true, plus_one), 1.0);
  EXPECT_EQ(result_with(false, plus_one), 1.0);
  const auto cosine = [](Builder& b, ir::ExpressionId x) { return b.apply(Operator::cos, x); };
  EXPECT_EQ(result_with(true, cosine), 1.0);
  const auto root = [](Builder& b, ir::ExpressionId x) { return b.apply(Operator::sqrt, x); };
  EXPECT_EQ(result_with(true, root), 0.0);
}

// A macro that is run without its caller: what it was not given is named where it ends by an alarm, and only there.
TEST(Vacant, MissingArgumentsAreNamedAtAnAlarm) {
  const auto inputs_of = [](bool alarm) {
    Builder b;
    b.assign(Builder::hash(3), b.read(Builder::hash(1)));  // #3 stays vacant, but it is the macro's own
    b.assign(Builder::hash(100),
             b.apply(Operator::divide, b.number(1), alarm ? b.read(Builder::hash(7)) : b.number(1)));
    b.end();
    const Ran ran = run_program(b.build(), mill_control());
    EXPECT_EQ(ran.result.ended, alarm ? interpreter::Ended::alarm : interpreter::Ended::end);
    std::vector<std::string> names;
    for (const auto& one : ran.result.not_interpreted)
      if (one.is_input) names.push_back(one.name);
    return names;
  };
  EXPECT_EQ(inputs_of(true), (std::vector<std::string>{"#1", "#7"}));
  EXPECT_EQ(inputs_of(false), std::vector<std::string>{});
}

TEST(Vacant, Comparisons) {
  struct Row {
    Operator op;
    bool with_vacant;  // #1 op #0, otherwise #1 op 0
    double when_vacant;
    double when_zero;
  };
  constexpr Row kRows[] = {
      {Operator::equal, true, 1, 0},         {Operator::not_equal, true, 0, 1},  {Operator::not_equal, false, 1, 0},
      {Operator::greater_equal, true, 1, 1}, {Operator::less_equal, true, 1, 1}, {Operator::greater, false, 0, 0},
      {Operator::less, false, 0, 0},         {Operator::equal, false, 0, 1},     {Operator::greater_equal, false, 1, 1},
      {Operator::less_equal, false, 1, 1},
  };
  for (const Row& row : kRows) {
    const auto compare = [&](Builder& b, ir::ExpressionId x) {
      return b.apply(row.op, x, row.with_vacant ? b.vacant() : b.number(0));
    };
    EXPECT_EQ(result_with(true, compare), row.when_vacant) << static_cast<int>(row.op) << row.with_vacant;
    EXPECT_EQ(result_with(false, compare), row.when_zero) << static_cast<int>(row.op) << row.with_vacant;
  }
}

TEST(Vacant, WordIsIgnoredWithItsSign) {
  Builder b;
  b.block({{Function::rapid}}, {{Address::x, 100.0}, {Address::y, 5.0}});
  b.block({}, {{Address::x, 50.0}, {Address::y, b.read(Builder::hash(1))}});
  b.block({}, {{Address::x, 60.0}, {Address::y, b.apply(Operator::negate, b.read(Builder::hash(1)))}});
  b.assign(Builder::hash(1), b.number(0));
  b.block({}, {{Address::y, b.apply(Operator::negate, b.read(Builder::hash(1)))}});
  b.end();
  const Ran ran = run_program(b.build(), mill_control());
  EXPECT_EQ(ran.trace,
            "1 rapid X100.0000 Y5.0000 Z0.0000\n"
            "2 rapid X50.0000 Y5.0000 Z0.0000\n"
            "3 rapid X60.0000 Y5.0000 Z0.0000\n"
            "5 rapid X60.0000 Y0.0000 Z0.0000\n"
            "6 end\n");
  ASSERT_EQ(ran.result.diagnostics.size(), 2U);
  EXPECT_EQ(ran.result.diagnostics[0].diagnostic.id, text::DiagnosticId::vacant_value);
  EXPECT_EQ(ran.result.diagnostics[0].line, 2U);
}

TEST(Vacant, ConditionIsFalse) {
  Builder b;
  b.when(ir::StatementKind::if_begin, b.vacant());
  b.assign(Builder::hash(100), b.number(1));
  b.structure(ir::StatementKind::if_end);
  b.end();
  EXPECT_EQ(run_program(b.build(), mill_control()).value("#100"), -999.0);
}

TEST(Vacant, ControlWithoutItReadsZero) {
  Builder b;
  b.assign(Builder::r(2), b.apply(Operator::add, b.read(Builder::r(1)), b.number(1)));
  b.block({{Function::rapid}}, {{Address::x, b.read(Builder::r(7))}});
  b.end();
  const Ran ran = run_program(b.build(), sinumerik_control());
  EXPECT_EQ(ran.value("R1"), 0.0);
  EXPECT_EQ(ran.value("R2"), 1.0);
  EXPECT_EQ(ran.trace, "2 rapid X0.0000 Y0.0000 Z0.0000\n3 end\n");
}

TEST(Vacant, ZeroIsWriteProtected) {
  Builder b;
  b.assign(Builder::hash(0), b.number(1));
  const Ran ran = run_program(b.build(), mill_control());
  EXPECT_EQ(ran.result.ended, interpreter::Ended::alarm);
  EXPECT_EQ(ran.last_diagnostic()->diagnostic.id, text::DiagnosticId::variable_write_protected);
}

}  // namespace
}  // namespace dripfeed::test
