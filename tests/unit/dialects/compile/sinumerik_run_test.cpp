// SINUMERIK programs from text to motions: inputs that are not known, data of the control, axes as values, sections,
// calls by text, frames, polar positions, arcs, corners and standard cycles. The oracle of each is the closed form in
// the test, or the rule of the Programming Manuals Fundamentals (PG), Job Planning (PGA) and Cycles (PGZ) that it
// names.
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "dialects/compile/execute.h"
#include "dialects/interpreter/trace.h"
#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

struct Result {
  interpreter::RunResult result;
  std::string trace;
  std::vector<ir::Motion> motions;

  [[nodiscard]] bool names(std::string_view what) const {
    return std::ranges::any_of(result.not_interpreted,
                               [&](const interpreter::NotInterpreted& one) { return one.name == what; });
  }
  [[nodiscard]] double value(std::string_view name) const {
    for (const interpreter::VariableValue& variable : result.variables)
      if (variable.name == name) return variable.value.value_or(-999.0);
    return -999.0;
  }
  [[nodiscard]] std::string text(std::string_view name) const {
    for (const interpreter::VariableValue& variable : result.variables)
      if (variable.name == name) return variable.text.value_or("no text");
    return "no variable";
  }
};

using Texts = std::map<std::string, std::string, std::less<>>;

Result run(const std::string& text, const Texts& called = {}, ir::MachineKind kind = ir::MachineKind::mill,
           std::vector<interpreter::InitialValue> state = {}) {
  ir::Control control = test::control("sinumerik-840d", kind);
  control.semantics.power_on_known = true;
  const text::Source source("TEST.MPF", text);
  const ir::ReadResult read = find_dialect(control.dialect)->read(source, control);
  EXPECT_FALSE(text::has_error(read.diagnostics)) << said(read.diagnostics, source) << text;
  ProgramLibrary library(control, [&](std::string_view name) -> std::optional<text::Source> {
    const auto found = called.find(name);
    if (found == called.end()) return std::nullopt;
    return text::Source(found->first, found->second);
  });
  interpreter::RunNames names;
  interpreter::RunOptions options{.initial_values = std::move(state), .want_variables = true, .names = &names};
  options.limits.loop_passes = 100'000;
  interpreter::TraceWriter writer(control, names);
  Motions motions;
  FanOut both({&writer, &motions});
  Result out;
  out.result = execute(read.program, control, &library, both, options);
  out.trace = writer.text();
  out.motions = motions.all;
  return out;
}

std::string moves(const Result& run) {
  std::string out;
  std::size_t begin = 0;
  while (begin < run.trace.size()) {
    const std::size_t end = run.trace.find('\n', begin);
    const std::string line = run.trace.substr(begin, end - begin);
    if (line.contains("rapid") || line.contains("linear") || line.contains("arc-") || line.contains("thread") ||
        line.contains("dwell") || line.contains("spline"))
      out += line + "\n";
    begin = end + 1;
  }
  return out;
}

std::string alarm_of(const Result& run) {
  return run.result.diagnostics.empty() ? "" : run.result.diagnostics.back().diagnostic.alarm;
}

// --- inputs

TEST(SinumerikInputs, WhatIsComputedFromAnInputIsNoAlarm) {
  const Result ran = run("R1=10/INI[3]\nG0 X=R1 Y5\nG1 Z=SQRT(R1-100) F100\nM30\n");
  EXPECT_EQ(ran.result.ended, interpreter::Ended::end);
  EXPECT_TRUE(ran.names("INI[3]"));
  EXPECT_TRUE(ran.names("X from a value that is not known"));
  ASSERT_EQ(ran.motions.size(), 3U);
  EXPECT_EQ(ran.motions[0].axes_commanded, 2U);     // Y alone
  EXPECT_NE(ran.motions[0].axes_unknown & 1U, 0U);  // X is anywhere
}

TEST(SinumerikInputs, AStateFileGivesThem) {
  const Result ran = run("R1=10/INI[3]\nIF $A_IN[2]==1\nR2=1\nENDIF\nG0 X=R1+LENGTH\nM30\n", {}, ir::MachineKind::mill,
                         {{.bank = ir::Bank::named, .name = "INI[3]", .value = 4.0},
                          {.bank = ir::Bank::named, .name = "LENGTH", .value = 0.5},
                          {.bank = ir::Bank::system, .name = "$A_IN[2]", .value = 1.0}});
  EXPECT_EQ(ran.value("R1"), 2.5);
  EXPECT_EQ(ran.value("R2"), 1.0);
  EXPECT_TRUE(ran.trace.contains("rapid X3.0000"));
  EXPECT_TRUE(ran.result.not_interpreted.empty());
}

TEST(SinumerikInputs, AKnownDivisionByZeroIsStillOne) {
  const Result ran = run("R1=0\nR2=1/R1\nM30\n");
  EXPECT_EQ(ran.result.ended, interpreter::Ended::alarm);
  EXPECT_EQ(alarm_of(ran), "14051");
}

TEST(SinumerikInputs, ALoopThatWaitsForOneEnds) {
  const Result ran =
      run("WAITING:\nG4 F0.1\nIF $A_IN[1]==0 GOTOB WAITING\nLOOP\nIF $A_IN[2]==1 GOTOF OUT\nENDLOOP\nOUT:\n"
          "REPEAT\nG4 F1\nUNTIL $A_IN[3]\nM30\n");
  EXPECT_EQ(ran.result.ended, interpreter::Ended::end);
  EXPECT_TRUE(ran.names("a condition on a value that is not known"));
}

TEST(SinumerikInputs, LogicMayBeKnownAllTheSame) {
  const Result ran =
      run("R1=0 R2=1\nIF (R1==1) AND ($A_IN[1]==1)\nR3=1\nELSE\nR3=2\nENDIF\n"
          "IF (R2==1) OR ($A_IN[1]==1)\nR4=1\nENDIF\nM30\n");
  EXPECT_EQ(ran.value("R3"), 2.0);
  EXPECT_EQ(ran.value("R4"), 1.0);
  EXPECT_FALSE(ran.names("a condition on a value that is not known"));
}

TEST(SinumerikInputs, ASubprogramByItselfHasNoParametersAndNoFeed) {
  const Result ran =
      run("PROC PART(REAL LENGTH, VAR REAL OUT, STRING[10] NAME)\nG1 G91 X=LENGTH\nOUT=5\nIF NAME==\"A\"\n"
          "R1=1\nENDIF\nRET\n");
  EXPECT_EQ(ran.result.ended, interpreter::Ended::end);
  for (const interpreter::RunDiagnostic& d : ran.result.diagnostics)
    EXPECT_NE(d.diagnostic.severity, text::Severity::error) << text::message_of(d.diagnostic);
}

// --- data of the control

TEST(SinumerikData, GlobalDataIsOneForAllPrograms) {
  const Texts called = {{"SUB", "PROC SUB\nCOUNT=COUNT+1\nPLACE[2,1]=COUNT*10\nNAME=\"AB\"\nRET\n"}};
  const Result ran = run(
      "COUNT=5\nSUB\nSUB()\nR1=COUNT\nR2=PLACE[2,1]\nIF NAME==\"AB\"\nR3=1\nENDIF\nMSG(\"is \"<<NAME)\nM30\n", called);
  EXPECT_EQ(ran.value("R1"), 7.0);
  EXPECT_EQ(ran.value("R2"), 70.0);
  EXPECT_EQ(ran.value("R3"), 1.0);
  EXPECT_EQ(ran.value("PLACE[2,1]"), 70.0);
  EXPECT_TRUE(ran.trace.contains("message \"is AB\""));
}

TEST(SinumerikData, DefinitionFilesGiveTypesAndBounds) {
  const Texts called = {{"UGUD", "DEF NCK INT WHOLE\nDEF CHAN REAL ROW[3]\nDEF NCK STRING[20] LABEL\nM17\n"}};
  const Result ran = run("WHOLE=2.6\nR1=WHOLE\nR2=ISVAR(\"ROW\")\nR3=ISVAR(\"NOBODY\")\nM30\n", called);
  EXPECT_EQ(ran.value("R1"), 3.0);  // INT rounds half up
  EXPECT_EQ(ran.value("R2"), 1.0);
  EXPECT_EQ(ran.value("R3"), 0.0);
  const Result beyond = run("ROW[3]=1\nM30\n", called);
  EXPECT_EQ(beyond.result.ended, interpreter::Ended::alarm);
  const Result wrong = run("LABEL=5\nM30\n", called);
  EXPECT_EQ(alarm_of(wrong), "12150");
}

TEST(SinumerikData, SystemVariablesKeepWhatWasWritten) {
  const Result ran =
      run("$AC_MARKER[3]=7\n$P_UIFR[1,X,TR]=12.5\n$TC_DP3[2,1]=80\nR1=$AC_MARKER[3] R2=$P_UIFR[1,X,TR]\n"
          "R3=$TC_DP3[2,1] R4=$AC_MARKER[4]\nM30\n");
  EXPECT_EQ(ran.value("R1"), 7.0);
  EXPECT_EQ(ran.value("R2"), 12.5);
  EXPECT_EQ(ran.value("R3"), 80.0);
  EXPECT_TRUE(ran.names("$AC_MARKER[4]"));
  EXPECT_TRUE(ran.names("$P_UIFR"));      // what it moves is not carried out
  EXPECT_FALSE(ran.names("$AC_MARKER"));  // a marker moves nothing
}

TEST(SinumerikData, TheModalStateAnswers) {
  const Result ran =
      run("G18 G91 T5 D2 S800 M4\nG90 G1 X10 Z-3 F120\nR1=$P_EP[X] R2=$P_EP[Z] R3=$P_GG[6] R4=$P_SDIR[1]\n"
          "R5=$P_F R6=$P_TOOLP R7=$P_GG[14]\nM30\n");
  EXPECT_EQ(ran.value("R1"), 10.0);
  EXPECT_EQ(ran.value("R2"), -3.0);
  EXPECT_EQ(ran.value("R3"), 2.0);
  EXPECT_EQ(ran.value("R4"), 4.0);
  EXPECT_EQ(ran.value("R5"), 120.0);
  EXPECT_EQ(ran.value("R6"), 5.0);
  EXPECT_EQ(ran.value("R7"), 1.0);
}

TEST(SinumerikData, EndPositionsOfALatheGoByTheLetter) {
  const Result ran = run("G18 G90 DIAMON\nG0 X40 Z-7\nR1=$AA_IW[X] R2=$AA_IW[Z]\nM30\n", {}, ir::MachineKind::lathe);
  EXPECT_EQ(ran.value("R1"), 40.0);
  EXPECT_EQ(ran.value("R2"), -7.0);
}

// --- values

TEST(SinumerikValues, AxesAreValues) {
  const Texts called = {{"GO", "PROC GO(AXIS WHERE, REAL HOW_FAR)\nG0 AX[WHERE]=HOW_FAR\nRET\n"}};
  const Result ran =
      run("DEF AXIS A1, A2\nA1=(Z)\nA2=AXNAME(\"x\")\nG90 G0 X0 Y0 Z0\nG0 AX[A1]=5 AX[A2]=IC(2)\nGO(Y,7)\n"
          "GO(A1,1)\nR1=(A1==Z) R2=A1==A2\nMSG(\"axis \"<<A1)\nM30\n",
          called);
  EXPECT_EQ(moves(ran),
            "4 rapid X0.0000 Y0.0000 Z0.0000\n5 rapid X2.0000 Y0.0000 Z5.0000\n"
            "@1:2 rapid X2.0000 Y7.0000 Z5.0000\n@1:2 rapid X2.0000 Y7.0000 Z1.0000\n");
  EXPECT_EQ(ran.value("R1"), 1.0);
  EXPECT_EQ(ran.value("R2"), 0.0);
  EXPECT_TRUE(ran.trace.contains("message \"axis Z\""));
}

TEST(SinumerikValues, TextFunctions) {
  const Result ran =
      run("DEF STRING[20] S=\"TURN_12.SPF\"\nDEF STRING[20] PART\nR1=INDEX(S,\"_\") R2=RINDEX(S,\"N\")\n"
          "R3=MINDEX(S,\".0123456789\") R4=INDEX(S,\"Q\")\nPART=SUBSTR(S,5,2)\nR5=NUMBER(PART)\n"
          "R6=ISNUMBER(PART) R7=ISNUMBER(S) R8=STRLEN(SUBSTR(S,5))\nM30\n");
  EXPECT_EQ(ran.value("R1"), 4.0);
  EXPECT_EQ(ran.value("R2"), 3.0);
  EXPECT_EQ(ran.value("R3"), 5.0);
  EXPECT_EQ(ran.value("R4"), -1.0);
  EXPECT_EQ(ran.text("PART"), "12");
  EXPECT_EQ(ran.value("R5"), 12.0);
  EXPECT_EQ(ran.value("R6"), 1.0);
  EXPECT_EQ(ran.value("R7"), 0.0);
  EXPECT_EQ(ran.value("R8"), 6.0);
}

TEST(SinumerikValues, ArraysHaveThreeDimensions) {
  const Result ran = run("DEF INT A[2,3,4]=SET(1,2,3,4,5,6)\nA[1,2,3]=9\nR1=A[0,1,1] R2=A[1,2,3] R3=A[1,0,0]\nM30\n");
  EXPECT_EQ(ran.value("R1"), 6.0);  // row by row: four elements, then the fifth and sixth
  EXPECT_EQ(ran.value("R2"), 9.0);
  EXPECT_EQ(ran.value("R3"), 0.0);
  EXPECT_EQ(run("DEF INT A[2,3,4]\nR1=4\nA[0,0,R1]=1\nM30\n").result.ended, interpreter::Ended::alarm);
}

// --- flow

TEST(SinumerikFlow, SectionsAreRepeated) {
  // PGA, "Program section repetition": P counts the repetitions after the first pass.
  EXPECT_EQ(run("R1=0\nAA:\nR1=R1+1\nREPEAT AA P=3\nM30\n").value("R1"), 4.0);
  EXPECT_EQ(run("R1=0\nAA: R1=R1+1\nR1=R1+10\nREPEATB AA P=2\nM30\n").value("R1"), 13.0);
  EXPECT_EQ(run("R1=0\nAA: R1=R1+1\nBB: R1=R1+10\nR1=R1+100\nREPEAT AA BB P=2\nM30\n").value("R1"), 133.0);
  EXPECT_EQ(run("R1=0\nAA: R1=R1+1\nR1=R1+10\nENDLABEL: R1=R1+100\nR1=R1+1000\nREPEAT AA\nM30\n").value("R1"), 1222.0);
  EXPECT_EQ(run("R1=0\nREPEAT AA BB P=2\nGOTOF EE\nAA: R1=R1+1\nBB: R1=R1+1\nEE: M30\n").value("R1"), 4.0);
}

TEST(SinumerikFlow, SectionsNest) {
  EXPECT_EQ(run("R1=0 R2=0\nAA: R1=R1+1\nBB: R2=R2+1\nREPEATB BB P=1\nREPEAT AA P=1\nM30\n").value("R2"), 4.0);
  const Result missing = run("REPEAT NOWHERE P=2\nM30\n");
  EXPECT_EQ(alarm_of(missing), "14080");
}

TEST(SinumerikFlow, GotosStartsAgain) {
  EXPECT_EQ(
      run("R1=R1+1\nIF R1<4 GOTOS\nM30\n", {}, ir::MachineKind::mill, {{.bank = ir::Bank::r, .number = 1}}).value("R1"),
      4.0);
}

TEST(SinumerikFlow, TargetsAreComputed) {
  EXPECT_EQ(run("R1=2\nGOTOF \"L\"<<R1\nL1: R2=1\nM30\nL2: R2=2\nM30\n").value("R2"), 2.0);
}

TEST(SinumerikFlow, CallsByText) {
  const Texts called = {{"GROOVE", "R1=R1+1\nM17\n"}, {"WITH", "PROC WITH(REAL A)\nR1=R1+A\nRET\n"}};
  const Result ran =
      run("DEF STRING[40] NAME=\"groove\"\nR1=0\nCALL NAME\nCALL \"_N_GROOVE_SPF\"\n"
          "EXTCALL(\"A:/parts/GROOVE.SPF\")\nPCALL /_N_WKS_DIR/_N_X_WPD/_N_WITH_SPF(5)\nP=2 GROOVE\nM30\n",
          called);
  EXPECT_EQ(ran.value("R1"), 10.0);
  EXPECT_EQ(alarm_of(run("CALL \"NOBODY\"\nM30\n")), "14011");
}

TEST(SinumerikFlow, TextsAreExecutedInTheirProgram) {
  const Result ran =
      run("DEF REAL SIZE=2\nDEF REAL ROW[3]\nDEF STRING[20] N=\"ROW\"\nEXECSTRING(N<<\"[1]=SIZE*3\")\n"
          "R1=ROW[1]\nEXECSTRING(\"G0 X=SIZE R2=\"<<4)\nM30\n");
  EXPECT_EQ(ran.value("R1"), 6.0);
  EXPECT_EQ(ran.value("R2"), 4.0);
  EXPECT_TRUE(ran.trace.contains("6 rapid X2.0000"));
}

TEST(SinumerikFlow, MacrosAreReadInThePlaceOfTheirNames) {
  const Result ran = run("DEFINE UP AS G0 Z=R1\nDEFINE G301 AS G91 G1 X-1 F50\nR1=20\nUP\nG301\nM30\n");
  EXPECT_EQ(moves(ran), "4 rapid X0.0000 Y0.0000 Z20.0000\n5 linear X-1.0000 Y0.0000 Z20.0000 F50.0000/min\n");
}

// --- frames

TEST(SinumerikFrames, RotationInThePlane) {
  // x' = 10 + cos 90 · x - sin 90 · y, y' = 20 + sin 90 · x + cos 90 · y
  const Result ran =
      run("G17 G90 G0 X0 Y0 Z0\nTRANS X10 Y20\nAROT RPL=90\nG0 X5 Y1\nG91 X1\nG90 TRANS\nG0 X0 Y0\nM30\n");
  EXPECT_EQ(moves(ran),
            "1 rapid X0.0000 Y0.0000 Z0.0000\n4 rapid X9.0000 Y25.0000 Z0.0000\n5 rapid X9.0000 Y26.0000 Z0.0000\n"
            "7 rapid X0.0000 Y0.0000 Z0.0000\n");
}

TEST(SinumerikFrames, ASubstitutingFrameReplacesAll) {
  // PG, "Frame instructions": ROT alone deletes the shift before it; TRANS deletes the rotation.
  const Result ran = run("G17 G90 G0 X0 Y0\nTRANS X10\nROT Z=90\nG0 X5\nTRANS Y1\nG0 X2 Y2\nM30\n");
  EXPECT_TRUE(ran.trace.contains("4 rapid X0.0000 Y5.0000"));
  EXPECT_TRUE(ran.trace.contains("6 rapid X2.0000 Y3.0000"));
}

TEST(SinumerikFrames, MirrorTurnsArcsRound) {
  const Result ran = run("G17 G90 G0 X0 Y0\nMIRROR X0\nG1 X10 F100\nG2 X20 Y-10 I0 J-10\nM30\n");
  EXPECT_TRUE(ran.trace.contains("3 linear X-10.0000"));
  EXPECT_TRUE(ran.trace.contains("4 arc-ccw X-20.0000 Y-10.0000 Z0.0000 G17 I0.0000 J-10.0000")) << ran.trace;
}

TEST(SinumerikFrames, ScaleAndRadius) {
  const Result ran = run("G17 G90 G0 X0 Y0\nSCALE X2 Y2\nG1 X5 F100\nG3 X10 Y5 CR=5\nM30\n");
  EXPECT_TRUE(ran.trace.contains("4 arc-ccw X20.0000 Y10.0000 Z0.0000 G17 I0.0000 J10.0000")) << ran.trace;
  const Result oval = run("G17 G90 G0 X0 Y0\nSCALE X2\nG1 X5 F100\nG3 X10 Y5 CR=5\nM30\n");
  EXPECT_TRUE(oval.names("arcs that a frame tilts or stretches"));
}

TEST(SinumerikFrames, SaveGivesThemBack) {
  const Texts called = {{"SUB", "PROC SUB SAVE\nROT Z90\nG0 X1\nRET\n"}};
  const Result ran = run("G17 G90 G0 X0 Y0\nSUB\nG0 X3 Y0\nM30\n", called);
  EXPECT_TRUE(ran.trace.contains("3 rapid X3.0000 Y0.0000")) << ran.trace;
}

// --- positions and arcs

TEST(SinumerikGeometry, PolarPositions) {
  const Result ran =
      run("G17 G90 G0 X0 Y0 Z0\nG111 X10 Y10\nG0 RP=10 AP=0\nG1 AP=90 F100\nG110 X5\nG1 RP=2 AP=180\nM30\n");
  EXPECT_EQ(moves(ran),
            "1 rapid X0.0000 Y0.0000 Z0.0000\n3 rapid X20.0000 Y10.0000 Z0.0000\n"
            "4 linear X10.0000 Y20.0000 Z0.0000 F100.0000/min\n6 linear X13.0000 Y20.0000 Z0.0000 F100.0000/min\n");
}

TEST(SinumerikGeometry, ArcThroughAPoint) {
  // Three points of the circle about (0, 0) with radius 10; the point in between says which way round.
  const Result ran = run("G17 G90 G0 X10 Y0 Z0\nCIP X-10 Y0 I1=0 J1=10 F100\nCIP X10 Y0 I1=0 J1=10\nM30\n");
  EXPECT_TRUE(ran.trace.contains("2 arc-ccw X-10.0000 Y0.0000 Z0.0000 G17 I-10.0000 J0.0000")) << ran.trace;
  EXPECT_TRUE(ran.trace.contains("3 arc-cw X10.0000 Y0.0000 Z0.0000 G17 I10.0000 J0.0000")) << ran.trace;
}

TEST(SinumerikGeometry, TangentialArc) {
  // From (10, 0) along X to (20, 10): the centre lies on x = 10 at equal distance from both ends: (10, 10).
  const Result ran = run("G17 G90 G0 X0 Y0 Z0\nG1 X10 F100\nCT X20 Y10\nG1 Y20\nM30\n");
  EXPECT_TRUE(ran.trace.contains("3 arc-ccw X20.0000 Y10.0000 Z0.0000 G17 I0.0000 J10.0000")) << ran.trace;
}

TEST(SinumerikGeometry, ArcsFromAnUnknownPlaceAreNoAlarm) {
  const Result ran = run("G17 G90 G1 F100\nG2 X10 Y0 I3 J0\nG2 X10 Y20 CR=10\nG2 X10 Y0 CR=3\nM30\n");
  EXPECT_TRUE(ran.names("arcs from or to a place that is not known"));
  EXPECT_EQ(alarm_of(ran), "14040");  // the last one: both ends are known, and it does not fit
  EXPECT_EQ(ran.result.diagnostics.back().line, 4U);
}

TEST(SinumerikGeometry, RoundingBetweenLines) {
  // A right angle: the rounding of radius 2 takes 2 off each side.
  const Result ran = run("G17 G90 G0 X0 Y0 Z0\nG1 X10 RND=2 F100\nG1 Y10\nM30\n");
  EXPECT_EQ(moves(ran),
            "1 rapid X0.0000 Y0.0000 Z0.0000\n2 linear X8.0000 Y0.0000 Z0.0000 F100.0000/min\n"
            "3 arc-ccw X10.0000 Y2.0000 Z0.0000 G17 I0.0000 J2.0000 K0.0000 F100.0000/min\n"
            "3 linear X10.0000 Y10.0000 Z0.0000 F100.0000/min\n");
}

TEST(SinumerikGeometry, ChamfersByLegAndByEdge) {
  const Result leg = run("G17 G90 G0 X0 Y0 Z0\nG1 X10 CHR=3 F100\nG1 Y10\nM30\n");
  EXPECT_TRUE(leg.trace.contains("2 linear X7.0000 Y0.0000")) << leg.trace;
  EXPECT_TRUE(leg.trace.contains("3 linear X10.0000 Y3.0000")) << leg.trace;
  // The edge of a chamfer in a right angle is the leg times the root of 2.
  const Result edge = run("G17 G90 G0 X0 Y0 Z0\nG1 X10 CHF=4.242640687119285 F100\nG1 Y10\nM30\n");
  EXPECT_TRUE(edge.trace.contains("2 linear X7.0000 Y0.0000")) << edge.trace;
}

TEST(SinumerikGeometry, RoundingBetweenLineAndArc) {
  // The line y = 0 meets the circle about (1, 4) with radius 5 at (4, 0). The centre of a rounding of radius 1 inside
  // is 1 above the line and 4 from the circle's centre: (1 + sqrt 7, 1); it touches the circle at (1, 4) + 5 / 4 of the
  // way.
  const Result ran = run("G17 G90 G0 X0 Y0 Z0\nG1 X4 RND=1 F100\nG3 X1 Y9 I-3 J4\nM30\n");
  ASSERT_EQ(ran.motions.size(), 5U) << ran.trace;
  const double x = 1.0 + std::sqrt(7.0);
  EXPECT_NEAR(ran.motions[1].end[0], x, 1e-9);
  EXPECT_NEAR(ran.motions[2].end[0], 1.0 + 1.25 * (x - 1.0), 1e-9);
  EXPECT_NEAR(ran.motions[2].end[1], 4.0 - 1.25 * 3.0, 1e-9);
  EXPECT_NEAR(ran.motions[3].start[0] + ran.motions[3].center[0], 1.0, 1e-9);
  EXPECT_NEAR(ran.motions[3].start[1] + ran.motions[3].center[1], 4.0, 1e-9);
}

TEST(SinumerikGeometry, ModalRounding) {
  const Result ran = run("G17 G90 G0 X0 Y0 Z0\nRNDM=1\nG1 X10 F100\nG1 Y10\nG1 X0\nM30\n");
  EXPECT_EQ(std::ranges::count(ran.motions, ir::MotionKind::arc_ccw, &ir::Motion::kind), 2);
}

TEST(SinumerikGeometry, MeasuringEndsWhereTheProbeTouches) {
  const Result ran = run("G17 G90 G0 X0 Y0 Z0\nMEAS=1 G1 X10 F100\nR1=$AA_IW[X]\nM30\n");
  EXPECT_TRUE(ran.names("MEAS: where the probe touches"));
  EXPECT_TRUE(ran.names("$AA_IW[0]"));
}

TEST(SinumerikGeometry, Splines) {
  const Result ran = run("G17 G90 G0 X0 Y0 Z0\nBSPLINE X10 Y5 F100\nX20 Y0\nG1 X30\nM30\n");
  EXPECT_TRUE(ran.trace.contains("3 spline X20.0000 Y0.0000")) << ran.trace;
  EXPECT_TRUE(ran.names("the curve of a spline"));
}

TEST(SinumerikGeometry, TappingHasALead) {
  const Result ran = run("G17 G90 G0 X0 Y0 Z2\nG331 Z-20 K1.5 S500\nG332 Z2 K1.5\nG1 F100 G63 Z-5\nM30\n");
  EXPECT_TRUE(ran.trace.contains("2 thread X0.0000 Y0.0000 Z-20.0000 F1.5000/rev")) << ran.trace;
}

// --- standard cycles

TEST(SinumerikCycles, Drilling) {
  // PGZ, CYCLE81: to RFP + SDIS by rapid, to the depth by feed, to RTP by rapid; DPR counts from RFP.
  const Result ran = run("G17 G90 G0 X1 Y2 Z50\nF100\nCYCLE81(20,0,2,-12)\nCYCLE82(20,5,2,,10,0.5)\nG0 X0\nM30\n");
  EXPECT_EQ(moves(ran),
            "1 rapid X1.0000 Y2.0000 Z50.0000\n3 rapid X1.0000 Y2.0000 Z2.0000\n"
            "3 linear X1.0000 Y2.0000 Z-12.0000 F100.0000/min\n3 rapid X1.0000 Y2.0000 Z20.0000\n"
            "4 rapid X1.0000 Y2.0000 Z7.0000\n4 linear X1.0000 Y2.0000 Z-5.0000 F100.0000/min\n4 dwell P0.5000\n"
            "4 rapid X1.0000 Y2.0000 Z20.0000\n5 rapid X0.0000 Y2.0000 Z20.0000\n");
}

TEST(SinumerikCycles, DeepHoles) {
  // Chip breaking without degression: strokes of 5 mm, back by 1 mm after each.
  const Result ran = run("G17 G90 G0 X0 Y0 Z50\nF100\nCYCLE83(20,0,2,-15,,,5,0,0,0,1,0)\nM30\n");
  std::string depths;
  for (const ir::Motion& m : ran.motions)
    if (m.kind == ir::MotionKind::linear) depths += std::to_string(static_cast<int>(m.end[2])) + " ";
  EXPECT_EQ(depths, "-5 -4 -10 -9 -15 ");
}

TEST(SinumerikCycles, TappingByLeadAndBySize) {
  const Result ran = run("G17 G90 G0 X0 Y0 Z50\nCYCLE84(20,0,3,-12,,0,3,,1.5,0,400,400)\nM30\n");
  EXPECT_TRUE(ran.trace.contains("thread X0.0000 Y0.0000 Z-12.0000 F1.5000/rev")) << ran.trace;
  const Result size = run("G17 G90 G0 X0 Y0 Z50\nCYCLE84(20,0,3,-12,,0,3,8,,0,400,400)\nM30\n");
  EXPECT_TRUE(size.trace.contains("thread X0.0000 Y0.0000 Z-12.0000 F1.2500/rev")) << size.trace;
}

TEST(SinumerikCycles, BoringCycles) {
  // CYCLE85: in by FFR, out by RFF; CYCLE86: lifted off by RPA, RPO, RPAP before it goes out, and back beside the hole.
  const Result ream = run("G17 G90 G94 G0 X0 Y0 Z50\nF100\nCYCLE85(20,0,2,-10,,0,60,120)\nG0 X1\nM30\n");
  EXPECT_TRUE(
      ream.trace.contains("3 linear X0.0000 Y0.0000 Z-10.0000 F60.0000/min\n"
                          "3 linear X0.0000 Y0.0000 Z2.0000 F120.0000/min\n"))
      << ream.trace;
  const Result bore = run("G17 G90 G94 G0 X0 Y0 Z50\nF100 S500\nCYCLE86(20,0,2,-10,,0,3,-1,-1,0.5,45)\nM30\n");
  EXPECT_TRUE(
      bore.trace.contains("3 rapid X-1.0000 Y-1.0000 Z-9.5000\n3 rapid X-1.0000 Y-1.0000 Z20.0000\n"
                          "3 rapid X0.0000 Y0.0000 Z20.0000\n"))
      << bore.trace;
  EXPECT_EQ(alarm_of(run("G17 G90 G0 X0 Y0 Z50\nF100\nCYCLE86(20,0,2,-10)\nM30\n")), "61102");
  EXPECT_EQ(alarm_of(run("G17 G90 G0 X0 Y0 Z50\nF100\nCYCLE81(-5,0,2,-10)\nM30\n")), "61101");
}

TEST(SinumerikCycles, RowsAndCirclesOfHoles) {
  const Result row = run("G17 G90 G0 X0 Y0 Z0\nHOLES1(10,20,90,5,10,3)\nM30\n");
  EXPECT_EQ(moves(row),
            "1 rapid X0.0000 Y0.0000 Z0.0000\n2 rapid X10.0000 Y25.0000 Z0.0000\n2 rapid X10.0000 Y35.0000 Z0.0000\n"
            "2 rapid X10.0000 Y45.0000 Z0.0000\n");
  const Result circle = run("G17 G90 G0 X0 Y0 Z0\nHOLES2(10,20,5,0,0,4)\nM30\n");
  EXPECT_EQ(moves(circle),
            "1 rapid X0.0000 Y0.0000 Z0.0000\n2 rapid X15.0000 Y20.0000 Z0.0000\n2 rapid X10.0000 Y25.0000 Z0.0000\n"
            "2 rapid X5.0000 Y20.0000 Z0.0000\n2 rapid X10.0000 Y15.0000 Z0.0000\n");
}

TEST(SinumerikCycles, ThreadsAreCutToTheirDepth) {
  // Four cuts of equal area: depths 0.9 · sqrt(k / 4); the finishing cut takes the allowance of 0.1.
  const Result ran = run("G18 G90 G95 G0 X60 Z10 S500 M3\nCYCLE97(2,,0,-30,40,40,4,2,1,0.1,0,0,4,0,3,1)\nM30\n", {},
                         ir::MachineKind::lathe);
  std::vector<double> diameters;
  for (const ir::Motion& m : ran.motions)
    if (m.kind == ir::MotionKind::thread) diameters.push_back(m.end[0]);
  ASSERT_EQ(diameters.size(), 5U) << ran.trace;
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_NEAR(diameters[k], 40.0 - 2.0 * 0.9 * std::sqrt(static_cast<double>(k + 1) / 4.0), 1e-9);
  EXPECT_NEAR(diameters[4], 38.0, 1e-9);
  EXPECT_TRUE(ran.trace.contains("thread X38.0000 Z-32.0000 F2.0000/rev")) << ran.trace;
}

TEST(SinumerikCycles, AProgramOfTheUserGoesBefore) {
  const Texts called = {{"CYCLE81", "PROC CYCLE81(REAL A)\nR1=A\nRET\n"}};
  EXPECT_EQ(run("CYCLE81(7)\nM30\n", called).value("R1"), 7.0);
}

TEST(SinumerikCycles, OthersAreNamed) {
  const Result ran =
      run("G17 G90 G0 X0 Y0 Z0\nPOCKET3(10,0,1,-5,40,30,8,0,0,0,2,0,0,100,100,0,11,5)\nG91 G0 X1\nM30\n");
  EXPECT_TRUE(ran.names("POCKET3"));
  EXPECT_TRUE(ran.names("increments from a position that is not known"));
}

}  // namespace
}  // namespace dripfeed::compile::test
