// What the optimizer makes of texts: each rule by itself, what it leaves alone, and what it refuses.
#include "dialects/compile/render/optimized.h"

#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "dialects/compile/dialect/dialect.h"

namespace dripfeed::compile {
namespace {

using optimize::Rule;

struct Given {
  std::string_view dialect = "sinumerik-840d";
  std::vector<Rule> only = {};  // empty: the usual ones
  std::vector<optimize::NumberRange> own = {};
  std::vector<optimize::NumberRange> free = {};
};

constexpr optimize::NumberRange kR{ir::Bank::r, 0, 99};
constexpr optimize::NumberRange kFreeR{ir::Bank::r, 200, 209};

OptimizeResult optimized(const std::string& text, const Given& given = {}) {
  const Dialect& dialect = *find_dialect(given.dialect);
  OptimizeRequest request{.source = text::Source("program", text),
                          .control = dialect.control(ir::MachineKind::mill, ir::GSystem::a),
                          .cost = {}};
  request.cost = find_dialect("sinumerik-840d")->control(ir::MachineKind::mill, ir::GSystem::a).cost;
  if (!given.only.empty())
    for (std::size_t i = 0; i < optimize::kRules; ++i) request.settings.rules.set(static_cast<Rule>(i), false);
  for (const Rule rule : given.only) request.settings.rules.set(rule, true);
  request.settings.own = given.own;
  request.settings.free = given.free;
  OptimizeResult result = optimize_text(request);
  EXPECT_FALSE(text::has_error(result.diagnostics)) << text;
  return result;
}

void expect_text(const std::string& text, const std::string& wanted, const Given& given) {
  const OptimizeResult result = optimized(text, given);
  EXPECT_EQ(result.obstacle, "");
  EXPECT_EQ(result.not_verified, "");
  EXPECT_EQ(result.text, wanted);
}

TEST(Optimized, NamesBecomeTheNumbersThatAreFree) {
  expect_text("DEF REAL LONG, WIDE=3\nLONG=2 ; mm\nG0 X0 Y0\nG1 X=LONG Y=WIDE F100\nM30\n",
              "R201=3\nR200=2 ; mm\nG0 X0 Y0\nG1 X=R200 Y=R201 F100\nM30\n",
              {.only = {Rule::numbered}, .free = {kFreeR}});
  // Without free numbers they stay.
  expect_text("DEF REAL LONG\nLONG=2\nG0 X=LONG\nM30\n", "DEF REAL LONG\nLONG=2\nG0 X=LONG\nM30\n",
              {.only = {Rule::numbered}});
}

TEST(Optimized, AnIntegerThatRoundsStaysOne) {
  const std::string text = "DEF INT NN\nG0 X0\nNN=7/2\nG1 X=NN F100\nM30\n";
  expect_text(text, text, {.only = {Rule::numbered}, .free = {kFreeR}});
}

TEST(Optimized, JumpsBecomeStructures) {
  expect_text("R1=0\nG0 X0\nN10 R1=R1+1\nG1 X=R1 F100\nIF R1<5 GOTOB N10\nM30\n",
              "R1=0\nG0 X0\nWHILE R1<5\nN10 R1=R1+1\nG1 X=R1 F100\nENDWHILE\nM30\n",
              {.only = {Rule::loops, Rule::branches}});
  // The value at the beginning is not known: at least one round, and what the loop does not change stands before it.
  expect_text("R2=3\nG0 X0\nN10 R1=R1+1\nR3=R2*SIN(R2)\nG1 X=R1+R3 F100\nIF R1<5 GOTOB N10\nM30\n",
              "R2=3\nG0 X0\nR3=R2*SIN(R2)\nREPEAT\nN10 R1=R1+1\nG1 X=R1+R3 F100\nUNTIL R1>=5\nM30\n",
              {.only = {Rule::loops, Rule::invariants}, .own = {kR}});
  // What is known before an IF is known after it, which is worth its blocks here.
  const std::string long_value = "SIN(R8)*COS(R8)*SIN(R8)*COS(R8)*SIN(R8)*COS(R8)*SIN(R8)*COS(R8)";
  const std::string head = "G0 X0\nR8=R1+30\nR9=" + long_value + "\n";
  expect_text(head + "IF R1<2 GOTOF N30\nG1 X1 F100\nGOTOF N40\nN30 G1 X2 F100\nN40 G1 Y=" + long_value + "\nM30\n",
              head + "IF R1>=2\nG1 X1 F100\nELSE\nN30 G1 X2 F100\nENDIF\nN40 G1 Y=R9\nM30\n",
              {.only = {Rule::branches, Rule::values}});
}

TEST(Optimized, AJumpIntoAPartLeavesItAsItIs) {
  const std::string text =
      "G0 X0\nIF R2>1 GOTOF N20\nN10 R1=R1+1\nN20 G1 X=R1 F100\nIF R1<5 GOTOB N10\nIF R1<7 GOTOB N10\nM30\n";
  expect_text(text, text, {.only = {Rule::loops, Rule::branches}});
}

TEST(Optimized, ALoopOfAControlWithNumberedLoopsGetsAFreeNumber) {
  expect_text(
      "O1\n#1=0\nG0X0\nN10#1=#1+1\n#2=0\nWHILE[#2LT2]DO1\n#2=#2+1\nG1X#2F100.\nEND1\nIF[#1LT5]GOTO10\nM30\n",
      "O1\n#1=0\nG0X0\nWHILE[#1 LT 5]DO2\nN10#1=#1+1\n#2=0\nWHILE[#2LT2]DO1\n#2=#2+1\nG1X#2F100.\nEND1\nEND2\nM30\n",
      {.dialect = "fanuc", .only = {Rule::loops, Rule::branches}});
}

TEST(Optimized, KnownValuesAreNotComputedAgain) {
  expect_text("R1=5\nG0 X0\nWHILE R2<3\nR3=0 R4=R3*R1\nR5=R4+R2\nG1 X=R5 F100\nR2=R2+1\nENDWHILE\nM30\n",
              "R1=5\nG0 X0\nWHILE R2<3\nG1 X=R2 F100\nR2=R2+1\nENDWHILE\nM30\n", {.only = {Rule::values}, .own = {kR}});
}

TEST(Optimized, WhatOthersMayReadIsSet) {
  const std::string text = "G0 X0\nR3=R1*2\nG1 X=R1 F100\nM30\n";
  expect_text(text, text, {});
  expect_text(text, "G0 X0\nG1 X=R1 F100\nM30\n", {.own = {kR}});
}

TEST(Optimized, AParameterStaysForPeopleToChange) {
  const std::string text = "R1=5 ; teeth\nR2=5 ; depth\nG0 X0\nG1 X=R1 Y=R2 F100\nM30\n";
  expect_text(text, text, {.own = {kR}});
}

TEST(Optimized, InvariantsMoveBeforeTheLoop) {
  expect_text("R1=30\nG0 X0\nWHILE R2<3\nR3=R1*2\nG1 X=R3+R2*SIN(R1) F100\nR2=R2+1\nENDWHILE\nM30\n",
              "R1=30\nG0 X0\nR3=R1*2\nR200=SIN(R1)\nWHILE R2<3\nG1 X=R3+R2*R200 F100\nR2=R2+1\nENDWHILE\nM30\n",
              {.only = {Rule::invariants}, .own = {kR}, .free = {kFreeR}});
}

TEST(Optimized, WhatMayBeAnAlarmStaysInTheLoop) {
  const std::string text = "G0 X0\nWHILE R2<3\nR3=SQRT(R1)\nG1 X=R3 F100\nR2=R2+1\nENDWHILE\nM30\n";
  expect_text(text, text, {.only = {Rule::invariants}, .own = {kR}});
}

TEST(Optimized, AValueThatIsReadOnceMovesIntoItsReader) {
  expect_text("G0 X0\nR3=R1+R2\nR4=R3*2\nG1 X=R4 Y=R1 F100\nM30\n", "G0 X0\nG1 X=(R1+R2)*2 Y=R1 F100\nM30\n",
              {.only = {Rule::merge}, .own = {kR}});
  // It is set again between.
  const std::string text = "G0 X0\nR3=R1+R2\nR1=R4\nG1 X=R3 Y=R1 Z=R1 F100\nM30\n";
  expect_text(text, text, {.only = {Rule::merge}, .own = {kR}});
}

TEST(Optimized, OnAControlWithVacantVariablesACopyIsNoNumber) {
  // X#2 with a vacant #2 is left out; X[#1+0] is not.
  const std::string text = "O1\nG0X0Y0\n#2=#1+0\nG1X#2Y1.F100.\nM30\n";
  expect_text(text, text, {.dialect = "fanuc", .only = {Rule::values}});
}

TEST(Optimized, AssignmentsThatDoNotNeedEachOtherShareABlock) {
  expect_text("G0 X0\nR1=1\nR2=R1+1\nR3=4\nG1 X=R2 Y=R3 F100\nM30\n",
              "G0 X0\nR1=1 R3=4\nR2=R1+1\nG1 X=R2 Y=R3 F100\nM30\n", {.only = {Rule::join}});
  // A comment keeps its line, unless comments are dropped.
  const std::string text = "G0 X0\nR1=1 ; depth\nR3=4\nG1 X=R1 Y=R3 F100\nM30\n";
  expect_text(text, text, {.only = {Rule::join}});
  expect_text(text, "G0 X0\nR1=1 R3=4\nG1 X=R1 Y=R3 F100\nM30\n", {.only = {Rule::join, Rule::comments}});
  const std::string fanuc = "O1\n#101=1.\n#102=2.\nG0X#101Y#102\nM30\n";
  expect_text(fanuc, fanuc, {.dialect = "fanuc"});
}

// Columns count as they are printed, parentheses of a product in a sum left out.
TEST(Optimized, AssignmentsShareALineThatPeopleCanRead) {
  const std::string left = "R11=R20*R21*R22+R23*R24*R25-R26*R27*R28+R20*R21";
  const std::string right = "R12=R30*R31*R32+R33*R34*R35-R36*R37*R38+R30*R31";
  const std::string more = "R13=R40*R41*R42+R43";
  ASSERT_LT(left.size() + right.size(), 110U);
  expect_text("G0 X0\n" + left + "\n" + right + "\n" + more + "\nG1 X=R11+R12+R13 F100\nM30\n",
              "G0 X0\n" + left + " " + right + "\n" + more + "\nG1 X=R11+R12+R13 F100\nM30\n", {.only = {Rule::join}});
}

TEST(Optimized, CommentsAndNumbersGoWhereTheyAreAskedTo) {
  expect_text("; ring 4\nN10 G0 X0 ; begin\nN20 R1=R1+1\n; inside\nN30 G1 X=R1 F100\nIF R1<5 GOTOB N20\nN40 M30\n",
              "; ring 4\nG0 X0\nN20 R1=R1+1\nG1 X=R1 F100\nIF R1<5 GOTOB N20\nM30\n",
              {.only = {Rule::comments, Rule::numbers}});
}

TEST(Optimized, UntouchedLinesKeepTheirBytes) {
  expect_text("N5  g0   x0\r\n r9 = r1+ r2 ;sum\r\nG1 X=R9 F100\r\nM30", "N5  g0   x0\r\nG1 X=R1+R2 F100\r\nM30",
              {.own = {kR}});
}

TEST(Optimized, AnArgumentByReferenceComesBackChanged) {
  const std::string text =
      "EXTERN OUTER(VAR REAL)\nDEF REAL A1\nG0 X0\nWHILE R2<3\nA1=2\nOUTER(A1)\nG1 X=A1 F100\nR2=R2+1\nENDWHILE\nM30\n";
  const OptimizeResult result = optimized(text, {.free = {kFreeR}});
  EXPECT_EQ(result.text, text);
}

TEST(Optimized, WhatAnOperatorMaySetAtAStopIsReadAfterIt) {
  const auto program = [](const std::string& between, const std::string& x) {
    return "R1=3\nG0 X0\nR3=SIN(R1)*COS(R1)\n" + between + "\nG1 X=" + x + " Y=R3 F100\nM30\n";
  };
  expect_text(program("G4 F1", "SIN(R1)*COS(R1)"), program("G4 F1", "R3"), {});
  expect_text(program("M0", "SIN(R1)*COS(R1)"), program("M0", "SIN(R1)*COS(R1)"), {});
}

TEST(Optimized, ACallerMayReadTheLocalVariablesOfWhatItCalled) {
  const std::string text = "O1\n#3=#1+1.\nG1X#1F100.\nM99\n";
  EXPECT_EQ(optimized(text, {.dialect = "fanuc"}).text, text);
}

TEST(Optimized, ACalledProgramMayKnowTheNamesOfItsCaller) {
  const std::string text = "EXTERN OUTER\nDEF REAL DEPTH\nG0 X0\nDEPTH=3\nOUTER\nG1 X1 F100\nM30\n";
  EXPECT_EQ(optimized(text, {.free = {kFreeR}}).text, text);
}

TEST(Optimized, ABlockThatIsJumpedToStays) {
  const std::string text =
      "O1\nG0X0\nIF[#101EQ1]GOTO80\n#102=3\nN80#149=50\nN90#149=60\nG1X1.F100.\nIF[#101EQ2]GOTO90\nM30\n";
  const OptimizeResult result = optimized(text, {.dialect = "fanuc"});
  EXPECT_EQ(result.obstacle, "");
  EXPECT_TRUE(result.text.contains("N80#149=50"));
}

TEST(Optimized, WhatIsNotUnderstoodLeavesTheProgramAsItWas) {
  for (const char* line : {"EXECSTRING(\"R1=2\")", "REPEATB N10 P=2", "MCALL DRILL_HOLE(5)"}) {
    const std::string text = "N10 G0 X0\nR3=R1+R2\n" + std::string(line) + "\nG1 X=R3 F100\nM30\n";
    const OptimizeResult result = optimized(text, {.own = {kR}});
    EXPECT_NE(result.obstacle, "") << line;
    EXPECT_EQ(result.text, text);
    EXPECT_TRUE(result.changes.empty());
  }
}

TEST(Optimized, WhatDependsOnInputsIsNotCalledVerified) {
  const OptimizeResult result =
      optimized("G0 X0\nR3=R1+R2\nIF $A_IN[1]==1 GOTOF N20\nG1 X=R3 F100\nN20 M30\n", {.own = {kR}});
  EXPECT_EQ(result.not_verified, "its run depends on $A_IN[1]");
}

TEST(Optimized, ReportsTheCostOfBothRuns) {
  const OptimizeResult result = optimized("G0 X0\nR3=R1+R2\nR4=R3*2\nG1 X=R4 F100\nM30\n", {.own = {kR}});
  ASSERT_TRUE(result.before && result.after);
  EXPECT_EQ(result.before->moves, 2U);
  EXPECT_EQ(result.before->blocks, 5U);
  EXPECT_EQ(result.after->blocks, 3U);
  EXPECT_NEAR(result.before->total_ms - result.after->total_ms, 2 * 0.782, 1e-9);
}

TEST(Optimized, ReportsWhatEachRuleSaves) {
  const OptimizeResult result = optimized(
      "R1=30 ; depth\nG0 X0\nWHILE R2<3\nR3=R1*SIN(R1) R4=R3+R2\nG1 X=R4 F100\nR2=R2+1 ; round\nENDWHILE\nM30\n",
      {.only = {Rule::values, Rule::invariants, Rule::merge, Rule::comments}, .own = {kR}});
  ASSERT_TRUE(result.saved);
  ASSERT_EQ(result.savings.size(), 3U) << result.text;  // no value was known already
  EXPECT_EQ(result.savings[0].rule, Rule::invariants);
  EXPECT_EQ(result.savings[1].rule, Rule::merge);
  EXPECT_EQ(result.savings[2].rule, Rule::comments);
  // SIN once instead of three times, for a block before the loop; then two rounds less of the block that it shared.
  double sum = 0.0;
  for (const RuleSaving& one : result.savings) {
    sum += one.saved.ms;
    EXPECT_LE(one.saved.least_ms, one.saved.ms);
    EXPECT_GE(one.saved.most_ms, one.saved.ms);
  }
  EXPECT_NEAR(sum, result.saved->ms, 1e-9);
  EXPECT_NEAR(sum, result.before->total_ms - result.after->total_ms, 1e-9);
  EXPECT_GT(result.savings[1].saved.ms, 0.0);
  EXPECT_EQ(result.savings[2].saved.ms, 0.0);  // the model has no figure for comments
  EXPECT_EQ(result.savings[2].edits, 0U);
}

// Fewer functions for one more block: by the model a gain, by the low figure of the one and the high one of the other
// none.
TEST(Optimized, TheIntervalOfASavingTakesEachFigureForItself) {
  ir::CostModel model;
  model.block_ms = 1.0, model.function_ms = 0.5, model.spread = 2.0;
  ComputeCost before{.total_ms = 3.0}, after{.total_ms = 1.5};
  before.counts[6] = 6;  // functions
  after.counts[0] = 1;   // blocks
  after.counts[6] = 1;
  const Saving saved = saving_between(before, after, model);
  EXPECT_EQ(saved.ms, 1.5);
  EXPECT_EQ(saved.least_ms, 2.5 / 2.0 - 1.0 * 2.0);
  EXPECT_EQ(saved.most_ms, 2.5 * 2.0 - 1.0 / 2.0);
}

}  // namespace
}  // namespace dripfeed::compile
