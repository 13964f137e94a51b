// SINUMERIK programs from text to motions: inputs that are not known, data of the control, axes as values, sections and
// calls by text. The oracle of each is the closed form in the test, or the rule of the Programming Manuals Fundamentals
// (PG) and Job Planning (PGA) that it names.
#include "tests/unit/dialects/compile/sinumerik_run.h"

#include "dialects/sinumerik/tables/vocabulary.h"

namespace dripfeed::compile::test {
namespace {

// --- inputs

// What was in effect before the program is not known: neither the tool in the spindle nor a mode that it does not
// state.
TEST(SinumerikInputs, TheStateBeforeTheProgramIsOne) {
  const ir::Control control = test::control("sinumerik-840d", ir::MachineKind::mill);
  const Result before = run_on(control, "R1=$P_TOOLNO\nR2=$P_TOOL\nR3=$P_GG[6]\nIF $P_TOOLNO>0\nG0 X1\nENDIF\nM30\n");
  EXPECT_TRUE(before.names("$P_TOOLNO"));
  EXPECT_TRUE(before.names("$P_TOOL"));
  EXPECT_TRUE(before.names("$P_GG[6]"));
  EXPECT_TRUE(before.names("a condition on a value that is not known"));
  const Result stated =
      run_on(control, "G18 G90 G710 T2 D1\nM6\nR1=$P_TOOLNO\nR2=$P_TOOL\nR3=$P_GG[6]\nR4=$P_GG[13]\nM30\n");
  EXPECT_EQ(stated.value("R1"), 2.0);
  EXPECT_EQ(stated.value("R2"), 1.0);
  EXPECT_EQ(stated.value("R3"), 2.0);
  EXPECT_EQ(stated.value("R4"), 4.0);
}

// A quarter of a circle whose X is a radius, on a lathe that is not named: DIAM90 takes increments so, DIAMON does not.
TEST(SinumerikInputs, AnArcThatDoesNotFitAnUnstatedDiameterModeIsNoError) {
  const ir::Control lathe = test::control("sinumerik-840d", ir::MachineKind::lathe);
  const std::string arc = "G18 G90 G95 F0.1\nG0 X100 Z0\nG91 G3 X-0.565 Z0.234 I0 K0.8\nM30\n";
  const auto severity = [&](const std::string& text) {
    const Result ran = run_on(lathe, text);
    return ran.result.diagnostics.empty() ? text::Severity::note : ran.result.diagnostics.back().diagnostic.severity;
  };
  EXPECT_EQ(severity(arc), text::Severity::warning);
  EXPECT_EQ(severity("DIAMON\n" + arc), text::Severity::error);
  EXPECT_EQ(severity("DIAM90\n" + arc), text::Severity::note);
}

TEST(SinumerikInputs, AMacroOfAVariableIsThatVariable) {
  const Result ran = run("DEFINE COUNTED AS R5\nCOUNTED=3\nCOUNTED=COUNTED+1\nM30\n");
  EXPECT_EQ(ran.value("R5"), 4.0);
}

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

TEST(SinumerikInputs, APathByGuessesEndsInTime) {
  // Without end whatever the inputs are: the conditions never let it out.
  const Result result = run("MARK: R3=R0\nMORE: R3=R3-1\nIF R3>0 GOTOB MORE\nGOTOB MARK\nM30\n", {},
                            ir::MachineKind::mill, {}, 10'000'000);
  EXPECT_EQ(result.result.ended, interpreter::Ended::limit);
  EXPECT_TRUE(text::message_of(result.result.diagnostics.back().diagnostic).contains("guesses at conditions"));
  EXPECT_LT(result.result.blocks, 1'000'000U);
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
  EXPECT_FALSE(ran.names("$P_UIFR"));     // it takes effect when the offset is selected
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
      run("DEF STRING[20] TX=\"TURN_12.SPF\"\nDEF STRING[20] PART\nR1=INDEX(TX,\"_\") R2=RINDEX(TX,\"N\")\n"
          "R3=MINDEX(TX,\".0123456789\") R4=INDEX(TX,\"Q\")\nPART=SUBSTR(TX,5,2)\nR5=NUMBER(PART)\n"
          "R6=ISNUMBER(PART) R7=ISNUMBER(TX) R8=STRLEN(SUBSTR(TX,5))\nM30\n");
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

TEST(SinumerikFlow, ReturnsGoToABlockOfTheCaller) {
  const Texts called = {{"UP", "PROC UP(STRING[9] A)\nRET(A)\n"}, {"DOWN", "RET(\"N20\")\n"}};
  EXPECT_EQ(run("R1=0\nUP(\"THERE\")\nR1=R1+1\nTHERE: R1=R1+10\nM30\n", called).value("R1"), 10.0);
  EXPECT_EQ(run("R1=0\nDOWN\nR1=R1+1\nN20 R1=R1+10\nM30\n", called).value("R1"), 10.0);
  EXPECT_EQ(alarm_of(run("UP(\"NOWHERE\")\nM30\n", called)), "14080");
}

TEST(SinumerikValues, TextsOfUnknownTypeAreTaken) {
  // No one knows whether the name, defined in the control, is a text; and SPRINT gives one.
  const Result result = run("DEF STRING[9] A\nA=NAME_IN_THE_CONTROL\nA=SPRINT(\"%5.2f\",R1)\nR5=1\nM30\n");
  EXPECT_TRUE(result.result.diagnostics.empty());
  EXPECT_EQ(result.value("R5"), 1.0);
  EXPECT_TRUE(result.names("SPRINT"));
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

TEST(SinumerikFlow, ASectionMayEndWithALoop) {
  const Result ran =
      run("R1=0\nGOTOF AFTER\nAA: FOR R2=1 TO 2\nR1=R1+1\nBB: ENDFOR\nR1=R1+100\nAFTER:\nREPEAT AA BB P=2\nM30\n");
  EXPECT_EQ(ran.value("R1"), 4.0);
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

// PGA, "Indirect subprogram call with specification of the calling program part".
TEST(SinumerikFlow, PartsOfProgramsAreCalled) {
  const Texts called = {{"PARTS", "G0 X100\nP1:\nG0 Y1\nY2\nP2:\nN40 G0 Z1\nN50 Z2\nN60\nG0 Z9\nM17\n"}};
  const auto part = [&](const std::string& line) {
    return run("DEF STRING[10] A=\"P1\"\nG17 G90 G0 X0 Y0 Z0\n" + line + "\nM30\n", called);
  };
  for (const std::string line :
       {"CALL \"PARTS\" BLOCK \"P1\" TO \"P2\"", "CALL \"/_N_SPF_DIR/_N_PARTS_SPF\" BLOCK A TO \"p2\"",
        "CALL \"PA\"<<\"RTS\" BLOCK \"P\"<<1 TO \"P2\""}) {
    const Result ran = part(line);
    EXPECT_TRUE(ran.trace.contains(":3 rapid X0.0000 Y1.0000 Z0.0000\n")) << ran.trace;
    EXPECT_TRUE(ran.trace.ends_with(":4 rapid X0.0000 Y2.0000 Z0.0000\n4 end\n")) << ran.trace;
    EXPECT_TRUE(ran.result.not_interpreted.empty()) << line;
  }
  EXPECT_TRUE(moves(part("P=2 CALL \"PARTS\" BLOCK \"N40\" TO \"N60\"")).ends_with("Z2.0000\n"));
  // A loop that ends at the last label ends the part; what the variables before it are, no one said.
  const Texts loop = {{"LOOPS", "DEF REAL RR\nP1: FOR R2=1 TO 2\nX=20+R2\nP2: ENDFOR\nX98\nM17\n"}};
  const Result ended = run("G17 G90 G0 X0 Y0 Z0\nCALL \"LOOPS\" BLOCK \"P1\" TO \"P2\"\nM30\n", loop);
  EXPECT_TRUE(ended.trace.contains("X22.0000")) << ended.trace;
  EXPECT_FALSE(ended.trace.contains("X98")) << ended.trace;
  EXPECT_TRUE(ended.names("the variables that a program defines before the part of it that is called"));
  // What the last label's own block does then, the manual does not say.
  const Result own = part("CALL \"PARTS\" BLOCK \"P1\" TO \"N50\"");
  EXPECT_TRUE(own.names("whether CALL BLOCK runs the block of its last label"));
  // The whole program, once more, is another one: nothing of the part stays with it.
  const Result both = part("CALL \"PARTS\" BLOCK \"P1\" TO \"P2\"\nPARTS");
  EXPECT_TRUE(both.trace.contains(":9 rapid X100.0000 Y2.0000 Z9.0000")) << both.trace;
}

TEST(SinumerikFlow, APartOfTheProgramItselfHasItsVariables) {
  const std::string head = "DEF REAL A=3\nG17 G90 G0 X0 Y0 Z0\n";
  const std::string tail = "\nGOTOF ENDE\nL1:\nG0 X=A\nA=A+1\nL2:\nENDE:\nM30\n";
  const auto with = [&](const std::string& lines) { return run(head + lines + tail); };
  const Result ran = with("CALL BLOCK \"L1\" TO \"L2\"\nCALL BLOCK \"l1\" TO \"L2\"");
  EXPECT_EQ(moves(ran),
            "2 rapid X0.0000 Y0.0000 Z0.0000\n7 rapid X3.0000 Y0.0000 Z0.0000\n7 rapid X4.0000 Y0.0000 Z0.0000\n");
  for (const std::string line : {"CALL BLOCK \"L1\" TO \"L2\" P=3", "P=3 CALL BLOCK \"L1\" TO \"L2\""})
    EXPECT_TRUE(with(line).names("CALL")) << line;
  EXPECT_TRUE(run("DEF STRING[5] TX=\"L1\"\n" + head + "CALL BLOCK TX TO \"L2\"" + tail).names("CALL"));
}

TEST(SinumerikFlow, APartThatIsNotThereIsAnAlarm) {
  const Texts called = {{"PARTS", "P1:\nG0 Y1\nP2:\nM17\n"}};
  for (const std::string line : {"CALL \"PARTS\" BLOCK \"P1\" TO \"P3\"", "CALL \"PARTS\" BLOCK \"P2\" TO \"P1\"",
                                 "CALL \"PARTS\" BLOCK \"N5\" TO \"P2\"", "CALL BLOCK \"P1\" TO \"P2\""}) {
    const Result ran = run("G0 X0\n" + line + "\nM30\n", called);
    ASSERT_EQ(ran.result.ended, interpreter::Ended::alarm) << line;
    EXPECT_EQ(ran.result.diagnostics.back().diagnostic.id, text::DiagnosticId::jump_target_missing) << line;
  }
  const Result none = run("G0 X0\nCALL \"NOPE\" BLOCK \"P1\" TO \"P2\"\nM30\n", called);
  EXPECT_EQ(none.result.diagnostics.back().diagnostic.id, text::DiagnosticId::call_target_missing);
}

TEST(SinumerikFlow, TextsAreExecutedInTheirProgram) {
  const Result ran =
      run("DEF REAL SIZE=2\nDEF REAL ROW[3]\nDEF STRING[20] NA=\"ROW\"\nEXECSTRING(NA<<\"[1]=SIZE*3\")\n"
          "R1=ROW[1]\nEXECSTRING(\"G0 X=SIZE R2=\"<<4)\nM30\n");
  EXPECT_EQ(ran.value("R1"), 6.0);
  EXPECT_EQ(ran.value("R2"), 4.0);
  EXPECT_TRUE(ran.trace.contains("6 rapid X2.0000"));
}

// More than a run keeps: it ends, and none of the names has a value.
TEST(SinumerikFlow, MoreVariablesThanARunKeeps) {
  const Result ran = run("DEF REAL FF\nDEF REAL A[1000,1000,2]\nG0 X1\nM30\n", {}, ir::MachineKind::mill,
                         {{.bank = ir::Bank::named, .name = "FF", .value = 3.0}});
  EXPECT_EQ(ran.result.ended, interpreter::Ended::limit);
  EXPECT_TRUE(ran.motions.empty());
}

TEST(SinumerikFlow, MacrosAreReadInThePlaceOfTheirNames) {
  const Result ran = run("DEFINE UP AS G0 Z=R1\nDEFINE G301 AS G91 G1 X-1 F50\nR1=20\nUP\nG301\nM30\n");
  EXPECT_EQ(moves(ran), "4 rapid X0.0000 Y0.0000 Z20.0000\n5 linear X-1.0000 Y0.0000 Z20.0000 F50.0000/min\n");
}

// A swivelled plane, a transformation, a measured offset: where later coordinates lie is not known, and stays so.
TEST(SinumerikRun, CoordinatesAreLostAfterWhatShiftsThem) {
  const ir::Control control = test::control("sinumerik-840d", ir::MachineKind::mill);
  const auto lost_after = [&](const std::string& statement) {
    const Result ran = run_on(control, "G17 G90 G94 G710\nG0 X0 Y0 Z9\n" + statement + "\nG0 X1\nG0 G54 X2\nM30\n");
    std::vector<bool> lost;
    for (const ir::Motion& m : moves_of(ran.motions)) lost.push_back((m.gaps & ir::kFrameLost) != 0);
    return lost;
  };
  const std::vector<bool> from_there = {false, true, true};
  EXPECT_EQ(lost_after("CYCLE800(1,\"\",0,57,0,0,0,0,30,0,0,0,0,1)"), from_there);
  EXPECT_EQ(lost_after("TRAORI"), from_there);
  EXPECT_EQ(lost_after("CYCLE977(1)"), from_there);
  EXPECT_EQ(lost_after("CYCLE72(\"A\",20,0,2,-5)"), (std::vector<bool>{false, false, false}));
  EXPECT_EQ(lost_after("M8"), (std::vector<bool>{false, false, false}));
}

// $TC_DP3 and $TC_DP6 of the profile's tools, until the program changes such data.
TEST(SinumerikInputs, DataOfTheProfilesToolsAreKnown) {
  ir::Control control = test::control("sinumerik-840d", ir::MachineKind::mill);
  control.tool_radii = {{.tool = 1, .offset = 1, .radius_mm = 5.0}, {.tool = 1, .offset = 2, .radius_mm = 4.9}};
  control.tool_lengths = {{.tool = 1, .offset = 1, .length_mm = 120.0}};
  const auto read = [&](const std::string& text) { return run_on(control, "G17 G90 G710\n" + text + "M30\n"); };
  const Result known = read("R1=$TC_DP6[1,1]\nR2=$TC_DP6[1,2]\nR3=$TC_DP3[1,1]\n");
  EXPECT_EQ(known.value("R1"), 5.0);
  EXPECT_EQ(known.value("R2"), 4.9);
  EXPECT_EQ(known.value("R3"), 120.0);
  EXPECT_FALSE(known.names("$TC_DP6[1,1]"));
  EXPECT_TRUE(read("R1=$TC_DP6[2,1]\n").names("$TC_DP6[2,1]"));
  EXPECT_TRUE(read("R1=$TC_DP3[1,2]\n").names("$TC_DP3[1,2]"));
  EXPECT_TRUE(read("G700\nR1=$TC_DP6[1,1]\n").names("$TC_DP6[1,1]"));
  const Result changed = read("$TC_DP6[1,1]=4\nR1=$TC_DP6[1,1]\nR2=$TC_DP6[1,2]\nR3=$TC_DP3[1,1]\n");
  EXPECT_EQ(changed.value("R1"), 4.0);
  EXPECT_TRUE(changed.names("$TC_DP6[1,2]"));
  EXPECT_EQ(changed.value("R3"), 120.0);
}

// No verdict is pass after them: each is named, and the axes may be anywhere.
TEST(SinumerikInputs, ACycleThatIsNotReadIsNamed) {
  const ir::Control control = test::control("sinumerik-840d", ir::MachineKind::mill);
  std::size_t count = 0;
  for (const sinumerik::WordList& list : sinumerik::vocabulary()) {
    const bool moves = list.effect == sinumerik::Effect::moves || list.effect == sinumerik::Effect::shifts;
    if (list.role != sinumerik::Role::cycle || !moves) continue;
    for (const std::string_view name : list.names) {
      for (const std::string_view mark : {"", "MCALL "}) {
        const Result ran = run_on(control, "G17 G90 G94 G710\nG0 X0 Y0 Z9\n" + std::string(mark) + std::string(name) +
                                               "(1,2)\nG0 X1\nMCALL\nM30\n");
        EXPECT_TRUE(ran.names(name)) << mark << name;
        EXPECT_FALSE(std::ranges::any_of(ran.result.not_interpreted,
                                         [&](const auto& one) { return one.name == name && one.effects_known; }));
      }
      ++count;
    }
  }
  EXPECT_GT(count, 60U);
}

}  // namespace
}  // namespace dripfeed::compile::test
