// What is an error and what only a warning: an error is what the control alarms on whatever exists next to the program.
// The programs are patterns of machine builders' cycles that run in production.
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/unit/dialects/sinumerik/reading.h"

namespace dripfeed::sinumerik {
namespace {

// "warning unknown-name, error syntax-error" of a program that states its modes.
std::string faults(std::string_view body, std::string_view name = "A.SPF") {
  const std::string text = "G17 G710 G90 G94 F100 S100 M3\n" + std::string(body);
  std::string out;
  for (const text::Diagnostic& d : findings_of(name, text, control(ir::MachineKind::mill))) {
    if (d.severity == text::Severity::note) continue;
    if (!out.empty()) out += ", ";
    out += d.severity == text::Severity::error ? "error " : "warning ";
    out += text::row_of(d.id).name;
  }
  return out;
}

TEST(Certainty, ABlockThatNoRunComesToIsNotRead) {
  EXPECT_EQ(faults("G0 X1\nM17\n*** END OF FILE ***\n"), "warning syntax-error, warning unreachable");
  EXPECT_EQ(faults("G0 X1\n*** NOTE ***\nM17\n"), "error syntax-error");
  EXPECT_EQ(faults("GOTOF OVER\nR1=R2+\nOVER: G0 X1\nM17\n"), "warning missing-operand, warning unreachable");
}

TEST(Certainty, AJumpThatAConditionDecidesMayNeverBeTaken) {
  EXPECT_EQ(faults("GOTOF NOWHERE\nM17\n"), "error jump-target-missing");
  EXPECT_EQ(faults("IF $A_IN[1]==1 GOTOF NOWHERE\nM17\n"), "warning jump-target-missing");
  // GOTOF looks for the label after it.
  EXPECT_EQ(faults("BACK: R1=R1+1\nIF R1<3 GOTOF BACK\nM17\n"), "warning jump-target-missing");
}

TEST(Certainty, LabelsOfOneNameAndEndsWithoutTheirBeginRun) {
  EXPECT_EQ(faults("IF R1==1 GOTOF NEXT\nNEXT: G0 X1\nIF R1==2 GOTOF NEXT\nNEXT: G0 X2\nM17\n"),
            "warning label-defined-twice");
  EXPECT_EQ(faults("NEXT: G0 X1\nNEXT: G0 X2\nNEXT: G0 X3\nM17\n"), "warning label-defined-twice");
  EXPECT_EQ(faults("IF R1==1 GOTOF READY\nENDIF\nG0 X1\nREADY: M17\n"), "warning end-without-begin");
  EXPECT_EQ(faults("IF R1==1\nG0 X1\nM17\n"), "error missing-end");
  EXPECT_EQ(faults("IF R1==1\nG0 X1\nENDIF\nELSE\nM17\n"), "error end-without-begin");
}

// (A _DEC2): a macro of a definition file may stand for "MOD 100".
TEST(Certainty, ANameInThePlaceOfAnOperatorMayBeAMacro) {
  EXPECT_EQ(faults("IF (R1 _DIGIT)==2\nG0 X1\nENDIF\nM17\n"), "warning unknown-name");
  EXPECT_EQ(faults("DEFINE _DIGIT AS MOD 10\nIF (R1 _DIGIT)==2\nG0 X1\nENDIF\nM17\n", "A.MPF"), "");
}

TEST(Certainty, AMacroMayStandForAVariableThatIsWritten) {
  EXPECT_EQ(faults("DEFINE LAMP AS $A_DBB[320]\nLAMP=1\nM17\n", "A.MPF"), "");
  EXPECT_EQ(faults("DEFINE COUNTED AS R5\nCOUNTED=COUNTED+1\nM17\n", "A.MPF"), "");
}

// … and POS[X] for $AA_IW[X]; an index of a name that is defined here is a number for certain.
TEST(Certainty, ANameFromElsewhereMayTakeAnAxis) {
  EXPECT_EQ(faults("R1=WHERE[X]\nM17\n"), "warning unknown-name");
  EXPECT_TRUE(faults("DEF REAL WHERE[3]\nR1=WHERE[X]\nM17\n", "A.MPF").contains("error wrong-type"));
}

TEST(Certainty, WhatControlsInUseTakeIsNoError) {
  EXPECT_EQ(faults("M3 G4 F2\nM17\n"), "warning statement-not-alone");
  EXPECT_EQ(faults("MSG\nM17\n"), "warning missing-bracket");
  EXPECT_EQ(faults("DEF REAL LIMIT=-100000000.0\nR1=LIMIT\nM17\n", "B.SPF").find("too-many-digits"), std::string::npos);
  EXPECT_EQ(faults("G0 X100000000.0\nM17\n"), "error too-many-digits");
  EXPECT_EQ(faults("$TC_DP1[1,0]=0\nM17\n").find("variable-out-of-range"), std::string::npos);
}

// An asynchronous subprogram may end by going back to where it was called.
TEST(Certainty, ARepositionEndsASubprogram) {
  EXPECT_EQ(faults("G0 X1\nREPOSA\n").find("missing-program-end"), std::string::npos);
  EXPECT_EQ(faults("REPOSA\nG0 X1\n"), "warning not-interpreted, error missing-program-end");
}

}  // namespace
}  // namespace dripfeed::sinumerik
