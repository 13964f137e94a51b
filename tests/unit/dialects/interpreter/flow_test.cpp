// Control flow: structures, jumps and where they look, limits, and how a run ends.
#include <gtest/gtest.h>

#include "dialects/ir/cycle.h"
#include "tests/unit/dialects/interpreter/run_trace.h"

namespace dripfeed::test {
namespace {

using interpreter::Ended;
using ir::JumpSearch;
using ir::Operator;
using ir::StatementKind;
using text::DiagnosticId;
using Builder = ProgramBuilder;

// variable = variable + step
void add_to(Builder& b, const ir::Variable& variable, double step) {
  b.assign(variable, b.apply(Operator::add, b.read(variable), b.number(step)));
}

TEST(Flow, IfElse) {
  for (const double condition : {0.0, 1.0}) {
    Builder b;
    b.when(StatementKind::if_begin, b.number(condition));
    b.assign(Builder::r(1), b.number(10));
    b.structure(StatementKind::else_begin);
    b.assign(Builder::r(1), b.number(20));
    b.structure(StatementKind::if_end);
    add_to(b, Builder::r(1), 1.0);
    b.end();
    EXPECT_EQ(run_program(b.build(), sinumerik_control()).value("R1"), condition == 0.0 ? 21.0 : 11.0);
  }
}

TEST(Flow, WhileInWhileInRepeatInLoop) {
  Builder b;
  b.structure(StatementKind::loop_begin);
  b.structure(StatementKind::repeat_begin);
  b.assign(Builder::r(1), b.number(0));
  b.when(StatementKind::while_begin, b.apply(Operator::less, b.read(Builder::r(1)), b.number(3)));
  b.assign(Builder::r(2), b.number(0));
  b.when(StatementKind::while_begin, b.apply(Operator::less, b.read(Builder::r(2)), b.number(4)));
  add_to(b, Builder::r(2), 1.0);
  add_to(b, Builder::r(5), 1.0);
  b.structure(StatementKind::while_end);
  add_to(b, Builder::r(1), 1.0);
  b.structure(StatementKind::while_end);
  add_to(b, Builder::r(3), 1.0);
  b.when(StatementKind::repeat_end, b.apply(Operator::equal, b.read(Builder::r(3)), b.number(2)));
  b.go_to("OUT", JumpSearch::forward);
  b.structure(StatementKind::loop_end);
  b.label("OUT");
  b.end();
  const Ran ran = run_program(b.build(), sinumerik_control());
  EXPECT_EQ(ran.result.ended, Ended::end);
  EXPECT_EQ(ran.value("R5"), 24.0);
  EXPECT_EQ(ran.value("R3"), 2.0);
}

TEST(Flow, WhileThatIsFalseAtOnce) {
  Builder b;
  b.when(StatementKind::while_begin, b.number(0));
  add_to(b, Builder::r(1), 1.0);
  b.structure(StatementKind::while_end);
  b.end();
  const Ran ran = run_program(b.build(), sinumerik_control());
  EXPECT_EQ(ran.value("R1"), 0.0);
  EXPECT_EQ(ran.result.blocks, 2U);  // the WHILE and the end
}

// FOR counts by one, tests before each pass, and an empty range runs no pass.
TEST(Flow, For) {
  const auto passes = [](double first, double last, ir::ValueType type) {
    Builder b;
    const ir::Variable counter = Builder::named(b.declare("N", type));
    b.for_begin(counter, b.number(first), b.number(last));
    add_to(b, Builder::r(1), 1.0);
    b.structure(StatementKind::for_end);
    b.end();
    return run_program(b.build(), sinumerik_control()).value("R1");
  };
  EXPECT_EQ(passes(1, 5, ir::ValueType::integer), 5.0);
  EXPECT_EQ(passes(5, 1, ir::ValueType::integer), 0.0);
  EXPECT_EQ(passes(0.5, 2.9, ir::ValueType::real), 3.0);
  EXPECT_EQ(passes(0.5, 2.9, ir::ValueType::integer), 2.0);  // starts at 1, after rounding
}

TEST(Flow, JumpsLookWhereTheySay) {
  // R1 collects which blocks ran: labels A stand at the start and at the end.
  const auto run_jump = [](JumpSearch search) {
    Builder b;
    b.label("A");
    add_to(b, Builder::r(1), 1.0);
    b.when(StatementKind::if_begin, b.apply(Operator::greater, b.read(Builder::r(1)), b.number(1.5)));
    b.end();
    b.structure(StatementKind::if_end);
    b.go_to("A", search);
    add_to(b, Builder::r(1), 100.0);
    b.label("A");
    add_to(b, Builder::r(1), 10.0);
    b.end();
    return run_program(b.build(), sinumerik_control()).value("R1");
  };
  EXPECT_EQ(run_jump(JumpSearch::forward), 11.0);
  EXPECT_EQ(run_jump(JumpSearch::both), 11.0);
  EXPECT_EQ(run_jump(JumpSearch::backward), 2.0);
}

TEST(Flow, GotoSearchesOnAndThenFromTheTop) {
  Builder b;
  b.go_to(20U);
  b.label(10U);
  b.assign(Builder::hash(100), b.number(1));
  b.end();
  b.label(20U);
  b.go_to(10U);
  const Ran ran = run_program(b.build(), mill_control());
  EXPECT_EQ(ran.value("#100"), 1.0);
  EXPECT_EQ(ran.result.blocks, 4U);
}

TEST(Flow, FirstOfTwoBlocksWithTheSameNumberAfterTheJump) {
  Builder b;
  b.label(5U);
  add_to(b, Builder::hash(100), 1.0);
  b.go_to(5U, b.apply(Operator::equal, b.read(Builder::hash(101)), b.number(9)));
  b.jump({.search = JumpSearch::both, .number = 5});
  b.assign(Builder::hash(101), b.number(9));
  b.label(5U);
  add_to(b, Builder::hash(100), 10.0);
  b.end();
  EXPECT_EQ(run_program(b.build(), mill_control()).value("#100"), 11.0);
}

TEST(Flow, ComputedTargets) {
  Builder b;
  b.assign(Builder::hash(1), b.number(29.6));  // rounded
  b.jump({.computed = b.read(Builder::hash(1))});
  b.label(20U);
  b.assign(Builder::hash(100), b.number(20));
  b.end();
  b.label(30U);
  b.assign(Builder::hash(100), b.number(30));
  b.jump({.computed = b.apply(Operator::subtract, b.read(Builder::hash(100)), b.number(13))});
  const Ran ran = run_program(b.build(), mill_control());
  EXPECT_EQ(ran.value("#100"), 30.0);
  EXPECT_EQ(ran.result.ended, Ended::alarm);
  EXPECT_EQ(ran.last_diagnostic()->diagnostic.id, DiagnosticId::jump_target_missing);
  EXPECT_EQ(ran.last_diagnostic()->diagnostic.arguments, std::vector<std::string>{"N17"});
}

TEST(Flow, TargetsAsText) {
  Builder b;
  b.jump({.search = JumpSearch::forward, .computed = b.apply(Operator::concatenate, b.text("L"), b.number(2, false))});
  b.label("L1");
  b.end();
  b.label("L2");
  b.jump({.search = JumpSearch::forward, .computed = b.text("N40")});
  b.end();
  b.label(40U);
  b.assign(Builder::r(1), b.number(7));
  b.end();
  EXPECT_EQ(run_program(b.build(), sinumerik_control()).value("R1"), 7.0);
}

TEST(Flow, MissingTargetIsAnAlarmUnlessTheJumpIsTolerant) {
  Builder b;
  b.go_to("NOWHERE", JumpSearch::both, ir::ExpressionId::none, true);
  b.jump({.tolerant = true, .computed = b.number(99)});
  b.assign(Builder::r(1), b.number(1));
  b.go_to("NOWHERE", JumpSearch::both, b.number(0));  // not taken: no harm
  b.go_to("NOWHERE", JumpSearch::both);
  const Ran ran = run_program(b.build(), sinumerik_control());
  EXPECT_EQ(ran.value("R1"), 1.0);
  EXPECT_EQ(ran.last_diagnostic()->diagnostic.id, DiagnosticId::jump_target_missing);
  EXPECT_EQ(ran.last_diagnostic()->line, 5U);
}

TEST(Flow, LimitsEndTheRun) {
  Builder b;
  b.label(1U);
  b.go_to(1U, b.apply(Operator::equal, b.read(Builder::hash(100)), b.read(Builder::hash(100))));
  b.end();
  interpreter::RunOptions options;
  options.limits.blocks = 1000;
  const Ran blocks = run_program(b.build(), mill_control(), options);
  EXPECT_EQ(blocks.result.ended, Ended::limit);
  EXPECT_EQ(blocks.result.blocks, 1000U);
  EXPECT_EQ(blocks.last_diagnostic()->diagnostic.id, DiagnosticId::limit_reached);
  EXPECT_EQ(blocks.last_diagnostic()->diagnostic.arguments, std::vector<std::string>{"blocks"});
  options.limits.blocks = 1'000'000;
  options.limits.loop_passes = 10;
  const Ran passes = run_program(b.build(), mill_control(), options);
  EXPECT_EQ(passes.result.ended, Ended::limit);
  EXPECT_EQ(passes.result.blocks, 11U);
}

// What a cycle makes of one block counts, too, and the run ends within the cycle.
TEST(Flow, MotionsAreLimitedWhereverTheyAreMade) {
  Builder b;
  b.block({{ir::Function::rapid}}, {{ir::Address::x, 0.0}, {ir::Address::y, 0.0}, {ir::Address::z, 2.0}});
  b.block({{ir::Function::drill, ir::drill_argument(ir::DrillCycle::deep_hole, 0)}},
          {{ir::Address::z, -99.0}, {ir::Address::r, 0.0}, {ir::Address::q, 0.001}, {ir::Address::f, 100.0}});
  b.end();
  interpreter::RunOptions options;
  options.limits.motions = 10'000;
  const Ran ran = run_program(b.build(), mill_control(), options);
  EXPECT_EQ(ran.result.ended, Ended::limit);
  EXPECT_EQ(ran.result.motions, 10'000U);
  EXPECT_EQ(ran.motions.size(), 10'000U);
  EXPECT_EQ(ran.last_diagnostic()->diagnostic.arguments, std::vector<std::string>{"motions"});
  EXPECT_EQ(ran.last_diagnostic()->diagnostic.severity, text::Severity::warning) << "no control has that limit";
}

TEST(Flow, ABudgetOfTheCallerEndsARun) {
  Builder b;
  b.label(1U);
  b.go_to(1U, b.apply(Operator::equal, b.read(Builder::hash(100)), b.read(Builder::hash(100))));
  b.end();
  interpreter::RunOptions options;
  int asked = 0;
  options.used_up = [&] { return ++asked < 3 ? std::string() : std::string("5 s"); };
  const Ran ran = run_program(b.build(), mill_control(), options);
  EXPECT_EQ(ran.result.ended, Ended::limit);
  EXPECT_EQ(asked, 3);
  EXPECT_LT(ran.result.blocks, 20'000U) << "it is asked often";
  EXPECT_EQ(ran.last_diagnostic()->diagnostic.arguments, std::vector<std::string>{"5 s"});
}

// The same jump back, and nothing that could have branched: twice is enough to know it.
TEST(Flow, AJumpBackWithoutAConditionIsEndless) {
  Builder b;
  b.label(1U);
  b.block({{ir::Function::rapid}}, {{ir::Address::x, 1.0}});
  b.go_to(1U);
  b.end();
  const Ran ran = run_program(b.build(), mill_control());
  EXPECT_EQ(ran.result.ended, Ended::limit);
  EXPECT_EQ(ran.result.blocks, 4U);
  EXPECT_EQ(ran.last_diagnostic()->diagnostic.id, DiagnosticId::endless_loop);
}

TEST(Flow, TextWithoutAnEnd) {
  Builder b;
  b.assign(Builder::hash(100), b.number(1));
  const Ran ran = run_program(b.build(), mill_control());
  EXPECT_EQ(ran.result.ended, Ended::text_end);
  EXPECT_EQ(ran.last_diagnostic()->diagnostic.id, DiagnosticId::missing_program_end);
  EXPECT_EQ(ran.trace, "");
  Builder empty;
  EXPECT_EQ(run_program(empty.build(), mill_control()).result.ended, Ended::text_end);
}

TEST(Flow, DataNeedsNoCodeThatEndsIt) {
  Builder b;
  b.assign(Builder::r(1), b.number(10));
  ir::Program data = b.build();
  data.is_data = true;
  const Ran ran = run_program(data, sinumerik_control());
  EXPECT_EQ(ran.result.ended, Ended::text_end);
  EXPECT_EQ(ran.last_diagnostic(), nullptr);
  EXPECT_EQ(ran.value("R1"), 10.0);
}

TEST(Flow, StructuresWithoutPartnersAreAlarmsWhenTheyAreReached) {
  Builder b;
  b.go_to(10U);
  b.when(StatementKind::while_begin, b.number(1));
  b.label(10U);
  b.assign(Builder::hash(100), b.number(1));
  b.structure(StatementKind::loop_end);
  const Ran ran = run_program(b.build(), mill_control());
  EXPECT_EQ(ran.value("#100"), 1.0);
  EXPECT_EQ(ran.result.ended, Ended::alarm);
  EXPECT_EQ(ran.last_diagnostic()->diagnostic.id, DiagnosticId::end_without_begin);
  Builder opener;
  opener.when(StatementKind::while_begin, opener.number(1));
  opener.end();
  EXPECT_EQ(run_program(opener.build(), mill_control()).last_diagnostic()->diagnostic.id, DiagnosticId::missing_end);
}

TEST(Flow, AlarmsHaveTheControlsNumberAndTheirPlace) {
  constexpr ir::AlarmRow kAlarms[] = {{DiagnosticId::division_by_zero, "PS0112"},
                                      {DiagnosticId::argument_out_of_domain, "PS0119"},
                                      {DiagnosticId::variable_out_of_range, "PS0115"}};
  ir::Control control = mill_control();
  control.alarms = kAlarms;
  control.variables = {{ir::Bank::hash, 1, 33, ir::VariableUse::local, true},
                       {ir::Bank::hash, 100, 149, ir::VariableUse::common, true},
                       {ir::Bank::hash, 500, 531, ir::VariableUse::permanent, false}};
  const auto alarm_of = [&](auto make) {
    Builder b;
    b.add(StatementKind::empty);
    make(b);
    b.end();
    const Ran ran = run_program(b.build(), control);
    EXPECT_EQ(ran.result.ended, Ended::alarm);
    EXPECT_EQ(ran.last_diagnostic()->line, 2U);
    return ran.last_diagnostic()->diagnostic.alarm;
  };
  EXPECT_EQ(alarm_of([](Builder& b) {
              b.assign(Builder::hash(100), b.apply(Operator::divide, b.number(1), b.read(Builder::hash(101))));
            }),
            "PS0112");
  EXPECT_EQ(alarm_of([](Builder& b) { b.assign(Builder::hash(100), b.apply(Operator::sqrt, b.number(-1))); }),
            "PS0119");
  EXPECT_EQ(alarm_of([](Builder& b) { b.assign(Builder::hash(150), b.number(1)); }), "PS0115");
  EXPECT_EQ(alarm_of([](Builder& b) { b.assign(Builder::hash(100), b.read(Builder::hash(34))); }), "PS0115");
  EXPECT_EQ(alarm_of([](Builder& b) { b.assign(Builder::indirect(ir::Bank::hash, b.number(150)), b.number(1)); }),
            "PS0115");
  Builder protected_one;
  protected_one.assign(Builder::indirect(ir::Bank::hash, protected_one.number(500)), protected_one.number(1));
  EXPECT_EQ(run_program(protected_one.build(), control).last_diagnostic()->diagnostic.id,
            DiagnosticId::variable_write_protected);
}

TEST(Flow, UserAlarms) {
  ir::Control control = mill_control();
  control.semantics.user_alarm_base = 3000;
  Builder b;
  b.alarm(b.number(1), b.text("TOOL BROKEN"));
  const Ran ran = run_program(b.build(), control);
  EXPECT_EQ(ran.result.ended, Ended::alarm);
  EXPECT_EQ(ran.last_diagnostic()->diagnostic.id, DiagnosticId::user_alarm);
  EXPECT_EQ(ran.last_diagnostic()->diagnostic.alarm, "3001");
  EXPECT_EQ(ran.last_diagnostic()->diagnostic.arguments, std::vector<std::string>{"3001 TOOL BROKEN"});
}

TEST(Flow, EndOfASubprogramInTheMainProgram) {
  Builder b;
  b.back();
  const Ran ends = run_program(b.build(), sinumerik_control());
  EXPECT_EQ(ends.result.ended, Ended::end);
  EXPECT_EQ(ends.trace, "1 end\n");
  ir::Control control = mill_control();
  control.semantics.return_in_main_restarts = true;
  const Ran by_itself = run_program(b.build(), control);
  EXPECT_EQ(by_itself.result.ended, Ended::end);
  EXPECT_EQ(by_itself.trace, "");
  EXPECT_EQ(by_itself.last_diagnostic(), nullptr) << "a subprogram, and its caller is not here";
  Builder main;
  main.back();
  main.end();
  const Ran restarts = run_program(main.build(), control);
  EXPECT_EQ(restarts.last_diagnostic()->diagnostic.id, DiagnosticId::endless_loop);
}

TEST(Flow, EndAsACodeOfTheBlock) {
  Builder b;
  b.block({{ir::Function::rapid}, {ir::Function::program_end_rewind}}, {{ir::Address::x, 1.0}});
  b.assign(Builder::hash(100), b.number(1));
  const Ran ran = run_program(b.build(), mill_control());
  EXPECT_EQ(ran.trace, "1 rapid X1.0000 Y0.0000 Z0.0000\n1 end\n");
  EXPECT_EQ(ran.value("#100"), -999.0);
}

}  // namespace
}  // namespace dripfeed::test
