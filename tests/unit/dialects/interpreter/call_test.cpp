// Calls: whose variables, what arguments, how often, how deep, and what comes back.
#include <gtest/gtest.h>

#include "tests/unit/dialects/interpreter/run_trace.h"

namespace dripfeed::test {
namespace {

using interpreter::Ended;
using ir::Address;
using ir::CallKind;
using ir::Function;
using ir::Operator;
using text::DiagnosticId;
using Builder = ProgramBuilder;

ir::ExpressionId plus(Builder& b, const ir::Variable& variable, double step) {
  return b.apply(Operator::add, b.read(variable), b.number(step));
}

TEST(Call, SubprogramSharesTheCallersLocals) {
  Builder sub("O1000");
  sub.assign(Builder::hash(1), plus(sub, Builder::hash(1), 1.0));
  sub.back();
  Programs programs;
  programs.add("O1000", sub.build());
  Builder b;
  b.assign(Builder::hash(1), b.number(5));
  b.call(CallKind::subprogram, "O1000", {}, b.number(3));
  b.assign(Builder::hash(100), b.read(Builder::hash(1)));
  b.end();
  const Ran ran = run_program(b.build(), mill_control(), {}, programs);
  EXPECT_EQ(ran.value("#100"), 8.0);
  EXPECT_EQ(ran.result.programs, (std::vector<std::string>{"MAIN", "O1000"}));
}

TEST(Call, MacroHasItsOwnLocalsByLetter) {
  Builder macro("O9010");
  macro.assign(Builder::hash(100), macro.read(Builder::hash(1)));
  macro.assign(Builder::hash(101), macro.read(Builder::hash(24)));
  macro.assign(Builder::hash(102), macro.read(Builder::hash(2)));  // not given: vacant
  macro.assign(Builder::hash(1), macro.number(-1));
  macro.back();
  Programs programs;
  programs.add("O9010", macro.build());
  Builder b;
  b.assign(Builder::hash(1), b.number(5));
  b.assign(Builder::hash(2), b.number(6));
  b.call(CallKind::macro, "O9010", {{'A', b.number(1.5)}, {'X', b.read(Builder::hash(1))}});
  b.assign(Builder::hash(103), b.read(Builder::hash(1)));
  b.end();
  const Ran ran = run_program(b.build(), mill_control(), {}, programs);
  EXPECT_EQ(ran.value("#100"), 1.5);
  EXPECT_EQ(ran.value("#101"), 5.0);
  EXPECT_EQ(ran.value("#102"), -999.0);
  EXPECT_EQ(ran.value("#103"), 5.0);
}

TEST(Call, EveryLetterHasItsNumber) {
  constexpr std::pair<char, int> kNumbers[] = {{'A', 1},  {'B', 2},  {'C', 3},  {'I', 4},  {'J', 5},  {'K', 6},
                                               {'D', 7},  {'E', 8},  {'F', 9},  {'H', 11}, {'M', 13}, {'Q', 17},
                                               {'R', 18}, {'S', 19}, {'T', 20}, {'U', 21}, {'V', 22}, {'W', 23},
                                               {'X', 24}, {'Y', 25}, {'Z', 26}};
  for (const auto& [letter, number] : kNumbers) {
    Builder macro("O1");
    macro.assign(Builder::hash(100), macro.read(Builder::hash(static_cast<std::uint32_t>(number))));
    macro.back();
    Programs programs;
    programs.add("O0001", macro.build());
    Builder b;
    b.call(CallKind::macro, "", {{letter, b.number(7)}}, ir::ExpressionId::none, b.number(1));
    b.end();
    EXPECT_EQ(run_program(b.build(), mill_control(), {}, programs).value("#100"), 7.0) << letter;
  }
}

// I J K again and again: the n-th group starts at #(4 + 3(n-1)); a later word wins.
TEST(Call, GroupsOfIJK) {
  Builder macro("O1");
  for (std::uint32_t n = 4; n <= 12; ++n) macro.assign(Builder::hash(100 + n), macro.read(Builder::hash(n)));
  macro.back();
  Programs programs;
  programs.add("O1", macro.build());
  Builder b;
  b.call(CallKind::macro, "O1",
         {{'I', b.number(1)}, {'K', b.number(3)}, {'I', b.number(4)}, {'J', b.number(5)}, {'J', b.number(8)}});
  b.end();
  const Ran ran = run_program(b.build(), mill_control(), {}, programs);
  EXPECT_EQ(ran.value("#104"), 1.0);
  EXPECT_EQ(ran.value("#105"), -999.0);
  EXPECT_EQ(ran.value("#106"), 3.0);
  EXPECT_EQ(ran.value("#107"), 4.0);
  EXPECT_EQ(ran.value("#108"), 5.0);
  EXPECT_EQ(ran.value("#111"), 8.0);
  Builder mixed;  // I-3.0 I4.0 D5.0: D is #7 as well
  mixed.call(CallKind::macro, "O1", {{'I', mixed.number(-3)}, {'I', mixed.number(4)}, {'D', mixed.number(5)}});
  mixed.end();
  EXPECT_EQ(run_program(mixed.build(), mill_control(), {}, programs).value("#107"), 5.0);
  Builder bad;
  bad.call(CallKind::macro, "O1", {{'N', bad.number(1)}});
  EXPECT_EQ(run_program(bad.build(), mill_control(), {}, programs).result.ended, Ended::alarm);
}

TEST(Call, ArgumentsWithoutAPointCountIncrements) {
  ir::Control control = mill_control();
  control.semantics.decimal_mode = ir::DecimalMode::least_increment;
  Builder macro("O1");
  macro.assign(Builder::hash(100), macro.read(Builder::hash(24)));
  macro.assign(Builder::hash(101), macro.read(Builder::hash(19)));
  macro.back();
  Programs programs;
  programs.add("O1", macro.build());
  Builder b;
  b.call(CallKind::macro, "O1", {{'X', b.number(1500, false)}, {'S', b.number(1500, false)}});
  b.end();
  const Ran ran = run_program(b.build(), control, {}, programs);
  EXPECT_EQ(ran.value("#100"), 1.5);
  EXPECT_EQ(ran.value("#101"), 1500.0);
}

TEST(Call, ArgumentsAreComputedOnceForAllRepeats) {
  Builder macro("O1");
  macro.assign(Builder::hash(100), plus(macro, Builder::hash(100), 1.0));
  macro.assign(Builder::hash(101),
               macro.apply(Operator::add, macro.read(Builder::hash(101)), macro.read(Builder::hash(1))));
  macro.back();
  Programs programs;
  programs.add("O1", macro.build());
  Builder b;
  b.assign(Builder::hash(100), b.number(10));
  b.call(CallKind::macro, "O1", {{'A', b.read(Builder::hash(100))}}, b.number(4));
  b.end();
  const Ran ran = run_program(b.build(), mill_control(), {}, programs);
  EXPECT_EQ(ran.value("#100"), 14.0);
  EXPECT_EQ(ran.value("#101"), 40.0);
}

TEST(Call, RepeatsOfZeroAndVacant) {
  Builder sub("O1");
  sub.assign(Builder::hash(100), plus(sub, Builder::hash(100), 1.0));
  sub.back();
  Programs programs;
  programs.add("O1", sub.build());
  Builder b;
  b.call(CallKind::subprogram, "O1", {}, b.number(0));
  b.call(CallKind::subprogram, "O1", {}, b.read(Builder::hash(5)));  // vacant: a word that is not there
  b.end();
  EXPECT_EQ(run_program(b.build(), mill_control(), {}, programs).value("#100"), 1.0);
}

// A procedure with values, references, defaults and conversions.
struct Procedure {
  Procedure() : b("P") {
    const ir::SymbolId a = b.declare("A");
    const ir::SymbolId n = b.declare("N", ir::ValueType::integer);
    const ir::SymbolId out = b.declare("OUT");
    const ir::SymbolId local = b.declare("LOCAL");
    for (const ir::SymbolId id : {a, n, out}) b.symbol(id).is_parameter = true;
    b.symbol(out).by_reference = true;
    b.symbol(n).initial = b.number(7, false);
    b.procedure();
    b.assign(Builder::named(local), b.apply(Operator::add, b.read(Builder::named(local)), b.number(100)));
    b.assign(Builder::named(out), b.apply(Operator::add, b.read(Builder::named(a)), b.read(Builder::named(n))));
    b.assign(Builder::r(9), b.read(Builder::named(local)));
    b.assign(Builder::named(a), b.number(0));  // by value: the caller's stays
    b.back();
    programs.add("P", b.build());
  }
  Builder b;
  Programs programs;
};

TEST(Call, ParametersByValueReferenceAndDefault) {
  Procedure procedure;
  Builder b;
  const ir::Variable x = Builder::named(b.declare("X1"));
  const ir::Variable list = Builder::named(b.declare("LIST", ir::ValueType::real, 4), b.number(2));
  b.assign(x, b.number(1.5));
  b.call(CallKind::subprogram, "P", {{0, b.read(x)}, {0, b.number(2.5)}, {0, b.read(Builder::r(1))}});
  b.call(CallKind::subprogram, "P", {{0, b.read(x)}, {}, {0, b.read(list)}});
  b.call(CallKind::subprogram, "P", {{0, b.number(1)}, {}, {0, b.read(Builder::indirect(ir::Bank::r, b.number(3)))}});
  b.call(CallKind::subprogram, "P", {{0, b.read(Builder::r(3))}, {}, {0, b.read(x)}});
  b.end();
  const Ran ran = run_program(b.build(), sinumerik_control(), {}, procedure.programs);
  ASSERT_EQ(ran.result.ended, Ended::end);
  EXPECT_EQ(ran.value("R1"), 4.5);  // 2.5 became 3
  EXPECT_EQ(ran.value("LIST[2]"), 8.5);
  EXPECT_EQ(ran.value("R3"), 8.0);
  EXPECT_EQ(ran.value("X1"), 15.0);
  EXPECT_EQ(ran.value("R9"), 100.0);  // its own names start again
}

TEST(Call, ReferencesAreTheVariableItself) {
  Builder inner("INNER");
  const ir::SymbolId v = inner.declare("V");
  inner.symbol(v).is_parameter = inner.symbol(v).by_reference = true;
  inner.procedure();
  inner.assign(Builder::named(v), plus(inner, Builder::named(v), 1.0));
  inner.assign(Builder::r(2), inner.read(Builder::r(1)));  // sees the new value at once
  inner.back();
  Builder outer("OUTER");
  const ir::SymbolId w = outer.declare("W");
  outer.symbol(w).is_parameter = outer.symbol(w).by_reference = true;
  outer.procedure();
  outer.call(CallKind::subprogram, "INNER", {{0, outer.read(Builder::named(w))}});
  outer.back();
  Programs programs;
  programs.add("INNER", inner.build());
  programs.add("OUTER", outer.build());
  Builder b;
  b.assign(Builder::r(1), b.number(5));
  b.call(CallKind::subprogram, "OUTER", {{0, b.read(Builder::r(1))}});
  b.end();
  const Ran ran = run_program(b.build(), sinumerik_control(), {}, programs);
  ASSERT_EQ(ran.result.ended, Ended::end);
  EXPECT_EQ(ran.value("R1"), 6.0);
  EXPECT_EQ(ran.value("R2"), 6.0);
}

TEST(Call, WrongArguments) {
  Procedure procedure;
  const auto id_of = [&](std::initializer_list<ir::Argument> arguments, Builder& b) {
    b.call(CallKind::subprogram, "P", arguments);
    b.end();
    const Ran ran = run_program(b.build(), sinumerik_control(), {}, procedure.programs);
    EXPECT_EQ(ran.result.ended, Ended::alarm);
    return ran.last_diagnostic()->diagnostic.id;
  };
  Builder many;
  EXPECT_EQ(id_of({{0, many.number(1)}, {0, many.number(1)}, {0, many.read(Builder::r(1))}, {0, many.number(1)}}, many),
            DiagnosticId::wrong_argument_count);
  Builder few;
  EXPECT_EQ(id_of({{0, few.number(1)}}, few), DiagnosticId::wrong_argument_count);
  Builder value;
  EXPECT_EQ(id_of({{0, value.number(1)}, {}, {0, value.number(1)}}, value), DiagnosticId::wrong_type);
  Builder string;
  EXPECT_EQ(id_of({{0, string.text("A")}, {}, {0, string.read(Builder::r(1))}}, string), DiagnosticId::wrong_type);
}

TEST(Call, SaveGivesTheModesBack) {
  const auto run_with = [](bool saves) {
    Builder sub("S");
    sub.procedure(saves);
    sub.block({{Function::incremental}, {Function::rapid}, {Function::local_shift, 1}}, {{Address::x, 5.0}});
    sub.block({}, {{Address::x, 1.0}});
    sub.back();
    Programs programs;
    programs.add("S", sub.build());
    Builder b;
    b.block({{Function::absolute}, {Function::linear}}, {{Address::x, 10.0}, {Address::f, 100.0}});
    b.call(CallKind::subprogram, "S");
    b.block({}, {{Address::x, 10.0}});
    b.end();
    return run_program(b.build(), sinumerik_control(), {}, programs).trace;
  };
  EXPECT_EQ(run_with(true),
            "1 linear X10.0000 Y0.0000 Z0.0000 F100.0000/min\n"
            "@1 S\n@1:3 rapid X11.0000 Y0.0000 Z0.0000\n3 linear X10.0000 Y0.0000 Z0.0000 F100.0000/min\n4 end\n");
  EXPECT_EQ(run_with(false),
            "1 linear X10.0000 Y0.0000 Z0.0000 F100.0000/min\n"
            "@1 S\n@1:3 rapid X11.0000 Y0.0000 Z0.0000\n3 rapid X21.0000 Y0.0000 Z0.0000\n4 end\n");
}

TEST(Call, MissingProgramNestingAndDepth) {
  Builder recursive("O1");
  recursive.call(CallKind::subprogram, "O1");
  recursive.back();
  Programs programs;
  programs.add("O1", recursive.build());
  ir::Control control = mill_control();
  control.limits.call_nesting = 4;
  const Ran nested = run_program(recursive.program(), control, {}, programs);
  EXPECT_EQ(nested.result.ended, Ended::alarm);
  EXPECT_EQ(nested.last_diagnostic()->diagnostic.id, DiagnosticId::call_nesting_too_deep);
  EXPECT_EQ(nested.last_diagnostic()->diagnostic.arguments, (std::vector<std::string>{"5", "4"}));
  control.limits.call_nesting = 0;
  const Ran deep = run_program(recursive.program(), control, {}, programs);
  EXPECT_EQ(deep.result.ended, Ended::limit);
  Builder missing;
  missing.call(CallKind::subprogram, "O4711");
  const Ran ran = run_program(missing.build(), control, {}, programs);
  EXPECT_EQ(ran.last_diagnostic()->diagnostic.id, DiagnosticId::call_target_missing);
  EXPECT_EQ(ran.last_diagnostic()->diagnostic.arguments, std::vector<std::string>{"O4711"});
}

TEST(Call, ReturnToABlockOfTheCaller) {
  Builder sub("O1");
  sub.back_to(50);
  Programs programs;
  programs.add("O1", sub.build());
  Builder b;
  b.call(CallKind::subprogram, "O1");
  b.assign(Builder::hash(100), b.number(1));
  b.label(50U);
  b.end();
  const Ran ran = run_program(b.build(), mill_control(), {}, programs);
  EXPECT_EQ(ran.result.ended, Ended::end);
  EXPECT_EQ(ran.value("#100"), -999.0);
  Builder without;
  without.call(CallKind::subprogram, "O1");
  without.end();
  const Ran lost = run_program(without.build(), mill_control(), {}, programs);
  EXPECT_EQ(lost.last_diagnostic()->diagnostic.id, DiagnosticId::jump_target_missing);
  EXPECT_EQ(lost.last_diagnostic()->program, 0U);
}

TEST(Call, EndOfProgramInASubprogram) {
  Builder sub("O1");
  sub.end();
  Programs programs;
  programs.add("O1", sub.build());
  Builder b;
  b.call(CallKind::subprogram, "O1");
  b.block({{Function::rapid}}, {{Address::x, 1.0}});
  b.end();
  EXPECT_EQ(run_program(b.build(), mill_control(), {}, programs).trace, "@1 O1\n@1:1 end\n");
  EXPECT_EQ(run_program(b.build(), sinumerik_control(), {}, programs).trace,
            "2 rapid X1.0000 Y0.0000 Z0.0000\n3 end\n");
}

TEST(Call, SubprogramWithoutReturn) {
  Builder sub("O1");
  sub.assign(Builder::hash(100), sub.number(1));
  Programs programs;
  programs.add("O1", sub.build());
  Builder b;
  b.call(CallKind::subprogram, "O1");
  b.end();
  const Ran ran = run_program(b.build(), mill_control(), {}, programs);
  EXPECT_EQ(ran.result.ended, Ended::text_end);
  EXPECT_EQ(ran.last_diagnostic()->program, 1U);
}

}  // namespace
}  // namespace dripfeed::test
