// Where called cycles leave the tool, the feed and the spindle. In addition to random programs and the interpreter:
// tests/unit/dialects/compile/facts_oracle_test.cpp.
#include <gtest/gtest.h>

#include "dialects/facts/facts.h"
#include "dialects/ir/called_cycle.h"
#include "tests/support/program_builder.h"
#include "tests/unit/dialects/facts/mill.h"

namespace dripfeed::facts {
namespace {

using ir::Address;
using ir::CalledCycle;
using ir::CalledSort;
using ir::CycleValue;
using ir::Function;
using ir::ModalGroup;
using Builder = dripfeed::test::ProgramBuilder;

const CalledCycle kBore{.name = "BORE",
                        .hole = ir::DrillCycle::feed_out,
                        .values = {CycleValue::return_level, CycleValue::feed_in, CycleValue::feed_out}};
const CalledCycle kTap{.name = "TAP",
                       .hole = ir::DrillCycle::tap_right,
                       .values = {CycleValue::return_level, CycleValue::speed, CycleValue::spindle_after}};
const CalledCycle kRow{.name = "ROW",
                       .sort = CalledSort::holes_in_row,
                       .values = {CycleValue::pattern_first, CycleValue::pattern_second, CycleValue::pattern_angle,
                                  CycleValue::pattern_start, CycleValue::pattern_step, CycleValue::pattern_count}};

struct Case : Builder {
  void start() {
    block({{Function::rapid, 0, ModalGroup::motion}, {Function::spindle_cw, 0, ModalGroup::spindle}},
          {{Address::x, 0.0}, {Address::y, 0.0}, {Address::z, 50.0}, {Address::f, 100.0}, {Address::s, 800.0}});
  }
  void call_cycle(const CalledCycle& cycle, std::initializer_list<double> values) {
    std::vector<ir::Argument> arguments;
    for (const double value : values) arguments.push_back({.value = number(value)});
    ir::Program& p = program();
    const auto first = static_cast<std::uint32_t>(p.arguments.size());
    call(ir::CallKind::subprogram, cycle.name);
    p.arguments.insert(p.arguments.end(), arguments.begin(), arguments.end());
    p.calls.back().first_argument = first;
    p.calls.back().argument_count = static_cast<std::uint32_t>(arguments.size());
    p.calls.back().cycle = &cycle;
  }
  Facts at_end() {
    end();
    const ir::Program& p = build();
    const ir::Control control = mill();
    const Resolved resolved(p, control);
    return *resolved.before(static_cast<std::uint32_t>(p.statements.size()) - 1);
  }
};

TEST(CalledCycles, AHoleLeavesTheToolOverItsPositionAtTheReturnLevel) {
  Case c;
  c.start();
  c.call_cycle(kBore, {12.0, 0.0, 250.0});
  const Facts facts = c.at_end();
  EXPECT_TRUE(facts[Number::x].is(0.0));
  EXPECT_TRUE(facts[Number::z].is(12.0));
  EXPECT_EQ(facts[Kept::feed].certain()->number, 250.0) << "the feed of the cycle stays in effect";
  EXPECT_TRUE(facts[Mode::spindle].is({.function = Function::spindle_cw}));
}

TEST(CalledCycles, ATapLeavesTheSpindleAsItsValueStates) {
  for (const auto& [after, wanted] : {std::pair(3.0, Function::spindle_cw),
                                      {4.0, Function::spindle_ccw},
                                      {5.0, Function::spindle_stop},
                                      {0.0, Function::spindle_stop}}) {
    Case c;
    c.start();
    c.call_cycle(kTap, {12.0, 300.0, after});
    const Facts facts = c.at_end();
    EXPECT_TRUE(facts[Mode::spindle].is({.function = wanted})) << after;
    EXPECT_EQ(facts[Kept::speed].certain()->number, 800.0) << "the one before comes back";
  }
}

TEST(CalledCycles, AModalCallFollowsTheMovesOfAnotherCycle) {
  Case c;
  c.start();
  c.call_cycle(kBore, {8.0, 0.0, 0.0});
  c.program().statements.back().kind = ir::StatementKind::modal_call;
  c.call_cycle(kBore, {12.0, 0.0, 0.0});
  c.add(ir::StatementKind::modal_call_end);
  EXPECT_FALSE(c.at_end()[Number::z].is_certain());
}

TEST(CalledCycles, ARowBeginsAtItsNearerEnd) {
  Case c;
  c.start();
  c.call_cycle(kRow, {100.0, 5.0, 0.0, 0.0, -20.0, 4.0});
  const Facts facts = c.at_end();
  EXPECT_TRUE(facts[Number::x].is(100.0)) << "from X0 the hole at X40 is the first";
  EXPECT_TRUE(facts[Number::y].is(5.0));
  EXPECT_TRUE(facts[Number::z].is(50.0)) << "without a modal call nothing is drilled";
}

}  // namespace
}  // namespace dripfeed::facts
