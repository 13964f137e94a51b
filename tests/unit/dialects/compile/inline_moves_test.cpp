// CIP, CT, drilling cycles of lathes, G70 to G73 and CYCLE95 on controls that have no word for them: their moves in
// their place. Oracle: the run of the source, and for arcs centres worked out by hand.
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

using ir::MachineKind;

ConvertResult converted(const std::string& text, const std::string& from, const std::string& to, MachineKind kind) {
  ConvertRequest request;
  request.source = text::Source("program", text);
  request.from = control(from, kind);
  request.to = control(to, kind);
  return convert(request);
}

// The same moves there, to the decimals that are printed; gives the translation.
std::string expect_same_there(const std::string& text, const std::string& from, const std::string& to,
                              MachineKind kind) {
  SCOPED_TRACE(to);
  const ConvertResult made = converted(text, from, to, kind);
  EXPECT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, text::Source("program", text));
  const auto a = real_moves(run_text(text, control(from, kind)).motions);
  const auto b = real_moves(run_text(made.text, control(to, kind)).motions);
  EXPECT_GE(a.size(), 4U);
  expect_same(a, b, 1.1e-3, made.text);
  return made.text;
}

std::string refusal(const std::string& text, const std::string& from, const std::string& to, MachineKind kind) {
  const ConvertResult made = converted(text, from, to, kind);
  EXPECT_TRUE(text::has_error(made.diagnostics)) << made.text;
  EXPECT_EQ(made.text, "");
  return messages_of(made.diagnostics, text::Source("program", text));
}

const std::vector<std::string> kNumbered = {"fanuc", "mazak", "mitsubishi-m80"};

TEST(InlineMoves, ArcsByAPointOrATangent) {
  const std::string text =
      "G17 G90 G71 G94\nS1000 M3\nG0 X0 Y0 Z5\nG1 Z-1 F100\nCIP X20 Y0 I1=10 J1=10 F200 M8\nCT X40 Y-5\nX50 Y0\n"
      "G1 X60\nCIP X60 Y-20 I1=70 J1=-10\nG1 Z-2\nM9\nG0 Z10\nM30\n";
  for (const std::string& to : kNumbered) {
    const std::string made = expect_same_there(text, "sinumerik-840d", to, MachineKind::mill);
    // A half circle about (10, 0); it ends downward, so that (x - 20)^2 + y^2 = 2 (x - 20) r goes on through (40, -5).
    EXPECT_NE(made.find("G02 X20. Y0. I10. J0."), std::string::npos) << made;
    EXPECT_NE(made.find("G03 X40. Y-5. I10.625 J0."), std::string::npos) << made;
  }
}

// The chords of one that leaves its plane are straight cuts there, and whoever takes them over is informed.
TEST(InlineMoves, AnArcInSpace) {
  const std::string text = "G17 G90 G71 G94\nS1000 M3\nG0 X0 Y0 Z0\nCIP X10 I1=5 K1=5 F200\nX20 I1=15 K1=5\nM30\n";
  const auto here = real_moves(run_text(text, control("sinumerik-840d", MachineKind::mill)).motions);
  for (const std::string& to : kNumbered) {
    const ConvertResult made = converted(text, "sinumerik-840d", to, MachineKind::mill);
    const std::string messages = messages_of(made.diagnostics, text::Source("program", text));
    EXPECT_FALSE(text::has_error(made.diagnostics)) << messages;
    EXPECT_NE(messages.find("it is written as its moves"), std::string::npos) << messages;
    const auto there = real_moves(run_text(made.text, control(to, MachineKind::mill)).motions);
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t i = 1; i < here.size(); ++i) {
      EXPECT_EQ(there[i].kind, ir::MotionKind::linear);
      for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(here[i].end[axis], there[i].end[axis], 0.6e-3);
      EXPECT_EQ(there[i].feed, 200.0);
    }
  }
  const std::string compensated =
      refusal("G17 G90 G71 G94\nS1000 M3\nG0 X0 Y0 Z0\nG41 G1 X5 F200\nCIP X10 I1=7 K1=5\nG40 G1 X20\nM30\n",
              "sinumerik-840d", "fanuc", MachineKind::mill);
  EXPECT_NE(compensated.find("CIP where the radius is compensated"), std::string::npos) << compensated;
}

TEST(InlineMoves, ArcsAgainAndAgainInALoop) {
  const std::string text =
      "DEF INT NR\nG17 G90 G71 G94\nS1000 M3\nG0 Z5\nFOR NR=1 TO 3\nG0 X0 Y0\nCIP X20 Y0 I1=10 J1=10 F200\nX0 I1=10 "
      "J1=-10\nENDFOR\nG0 Z10\nM30\n";
  for (const std::string& to : kNumbered) {
    const std::string made = expect_same_there(text, "sinumerik-840d", to, MachineKind::mill);
    EXPECT_NE(made.find("WHILE"), std::string::npos) << made;  // still a macro
  }
}

TEST(InlineMoves, DuringModalDrilling) {
  const std::string made = expect_same_there(
      "G17 G90 G71 G94\nS1000 M3\nG0 X0 Y0 Z5\nCIP X20 Y0 I1=10 J1=10 F200\nG0 Z5\nMCALL CYCLE81(5,0,2,-9)\nX5 Y5\nX9\n"
      "MCALL\nG0 Z10\nM30\n",
      "sinumerik-840d", "fanuc", MachineKind::mill);
  EXPECT_NE(made.find("G81"), std::string::npos) << made;
}

TEST(InlineMoves, TheFeedAndTheMotionAfterThem) {
  // After the arcs the modal motion is the arc's: X50 is one; G1 and a feed of its own follow, then a rapid.
  expect_same_there(
      "G17 G90 G71 G94\nS1000 M3\nG0 X0 Y0 Z5\nG1 Y1 F100\nCIP X20 Y1 I1=10 J1=11 F200\nG1\nX30\nF50\nX40\nG0 X50\n"
      "X60\nM30\n",
      "sinumerik-840d", "fanuc", MachineKind::mill);
}

const std::string kLathe = "%\nO1\nG21 G18 G99 G97 G40\nS500 M03\nG00 X62. Z2.\n";

TEST(InlineMoves, StockRemovalAlongAShape) {
  const std::string shape = "N10 G00 X20.\nG01 Z-20. F0.1\nX40. Z-30.\nG02 X60. Z-40. R10.\nN20 G01 X62.\n";
  const std::string made = expect_same_there(
      kLathe + "G71 U2. R0.5\nG71 P10 Q20 U0.4 W0.1 F0.3\n" + shape + "G70 P10 Q20\nG01 X64.\nG00 X100. Z50.\nM30\n%\n",
      "fanuc", "sinumerik-840d", MachineKind::lathe);
  // The finishing cut, once: the shape's own blocks are gone.
  EXPECT_EQ(made.find("G2 X60. Z-40. I10. K0."), made.rfind("G2 X60. Z-40.")) << made;
  EXPECT_NE(made.find("G2 X60. Z-40. I10. K0."), std::string::npos) << made;
  EXPECT_EQ(made.find("N10"), std::string::npos) << made;
}

TEST(InlineMoves, TheNoseIsCompensatedWhereTheShapeSaysSo) {
  const std::string made =
      expect_same_there(kLathe +
                            "G71 U2. R0.5\nG71 P10 Q20 U0.4 W0.1 F0.3\nN10 G00 G42 X20.\nG01 Z-20. F0.1\nX40. Z-30.\n"
                            "N20 G40 X62.\nG70 P10 Q20\nG00 X100. Z50.\nM30\n%\n",
                        "fanuc", "sinumerik-840d", MachineKind::lathe);
  EXPECT_NE(made.find("G0 G42 X20."), std::string::npos) << made;
  EXPECT_NE(made.find("G40 X62."), std::string::npos) << made;
}

TEST(InlineMoves, StockRemovalAlongTheOtherAxisAndInAPattern) {
  expect_same_there(kLathe +
                        "G72 W2. R0.5\nG72 P10 Q20 U0.4 W0.1 F0.3\nN10 G00 Z-40.\nG01 X60. F0.1\nX40. Z-20.\n"
                        "N20 Z2.\nG70 P10 Q20\nG00 X70. Z5.\nG73 U6. W3. R3\nG73 P30 Q40 U0.4 W0.1 F0.3\n"
                        "N30 G00 X20. Z2.\nG01 Z-20. F0.1\nN40 X62. Z-30.\nG00 X100. Z50.\nM30\n%\n",
                    "fanuc", "sinumerik-840d", MachineKind::lathe);
}

TEST(InlineMoves, AContourBetweenLabels) {
  const std::string text =
      "G18 G90 G95 G71 DIAMON\nG97 S500 M3\nG0 X82 Z5\nCYCLE95(\"PART:PARTEND\",5,0.1,0.2,0,0.3,0.2,0.15,9)\nG0 X100\n"
      "M30\nPART:\nG1 X20 Z0\nZ-20\nX40 Z-30\nG3 X60 Z-40 CR=10\nPARTEND: G1 X80\nM17\n";
  for (const std::string& to : kNumbered) {
    const std::string made = expect_same_there(text, "sinumerik-840d", to, MachineKind::lathe);
    EXPECT_EQ(made.find("R10."), std::string::npos) << made;  // the contour's own blocks
  }
}

// The end's label alone on its line: the contour is what stands before it. All blocks are numbered, and no number is a
// path into the program.
TEST(InlineMoves, AContourThatEndsBeforeItsLabel) {
  const std::string blocks =
      "N5 G18 G90 G95 G71 DIAMOF\nN10 G97 S500 M3\nN20 G0 X41 Z5\nN30 CYCLE95(\"START:END\",5,0,0,0,0.3,0.2,0.15,1)\n"
      "N40 G0 X50\nN50 M30\nSTART:\nN60 G1 X10 Z0\nN70 Z-20\nN80 X40 Z-30\n";
  expect_same_there(blocks + "END:\nN90 M30\n", "sinumerik-840d", "fanuc", MachineKind::lathe);
  const ir::Control lathe = control("sinumerik-840d", MachineKind::lathe);
  const std::string in_line = blocks.substr(0, blocks.find("N80")) + "END: X40 Z-30\nN90 M30\n";
  const std::vector<ir::Motion> alone = run_text(blocks + "END:\nN90 M30\n", lathe).motions;
  EXPECT_GT(alone.size(), 10U);
  expect_same(real_moves(run_text(in_line, lathe).motions), real_moves(alone), 1e-9, in_line);
}

// D of G71 in one block is its depth and no offset.
TEST(InlineMoves, StockRemovalInOneBlock) {
  const std::string made = expect_same_there(
      kLathe + "G71 P1 Q2 U0.4 W0.1 D2000 F0.25\nN1 G00 X20.\nG01 Z-10.\nN2 X60.\nG00 X100. Z50.\nM30\n%\n", "fanuc",
      "sinumerik-840d", MachineKind::lathe);
  EXPECT_TRUE(made.contains("Z-9.9")) << made;
}

TEST(InlineMoves, HolesOfALathe) {
  const std::string text = kLathe +
                           "G00 X0 Z5.\nG83 Z-30. R-3. Q5000 P500 F0.1\nG80\nG00 Z20.\nX60. Z-10.\n"
                           "G87 X40. R-2. Q3000 F0.05\nZ-20.\nG80\nG01 X70. F0.2\nG00 X100. Z50.\nM30\n%\n";
  const std::string made = expect_same_there(text, "fanuc", "sinumerik-840d", MachineKind::lathe);
  EXPECT_EQ(made.find("CYCLE"), std::string::npos) << made;
  // The other two have them as they are.
  for (const std::string to : {"mazak", "mitsubishi-m80"})
    EXPECT_NE(expect_same_there(text, "fanuc", to, MachineKind::lathe).find("G87"), std::string::npos);
}

TEST(InlineMoves, DrillingCallsOnALathe) {
  const std::string text =
      "G18 G90 G95 G71 DIAMON\nG97 S500 M3\nG0 X0 Z5\nF0.1\nG17\nCYCLE83(10,0,2,-30,,-10,,2,0.5,0,1,1)\n"
      "CYCLE81(10,0,2,-5)\nG18\nG0 X100\nM30\n";
  for (const std::string& to : kNumbered) {
    const std::string made = expect_same_there(text, "sinumerik-840d", to, MachineKind::lathe);
    EXPECT_EQ(made.find("G83"), std::string::npos) << made;
  }
}

TEST(InlineMoves, InInches) {
  expect_same_there(
      "%\nO1\nG20 G18 G99 G97 G40\nS500 M03\nG00 X2.5 Z0.1\nG71 U0.1 R0.02\nG71 P10 Q20 U0.02 W0.005 F0.012\n"
      "N10 G00 X1.\nG01 Z-0.8 F0.004\nN20 X2.6 Z-1.2\nG70 P10 Q20\nG00 X4. Z2.\nM30\n%\n",
      "fanuc", "sinumerik-840d", MachineKind::lathe);
}

TEST(InlineMoves, OnOneSwitchTheMovesMustBeTheSame) {
  const std::string shape = "N10 G00 X20.\nG01 Z-20. F0.1\nN20 X62. Z-30.\n";
  const std::string rough = "G71 U2. R0.5\nG71 P10 Q20 U0.4 W0.1 F0.3\n";
  expect_same_there(kLathe + "/M08\n" + rough + shape + "/G70 P10 Q20\nG00 X100.\nM30\n%\n", "fanuc", "mazak",
                    MachineKind::lathe);  // as it is
  expect_same_there(kLathe + "/M08\n" + rough + shape + "G00 X100.\nM30\n%\n", "fanuc", "sinumerik-840d",
                    MachineKind::lathe);
  const std::string here = refusal(kLathe + "/G00 X70.\n" + rough + shape + "G00 X100.\nM30\n%\n", "fanuc",
                                   "sinumerik-840d", MachineKind::lathe);
  EXPECT_NE(here.find("makes other moves each time"), std::string::npos) << here;
}

// A macro whose arguments come from outside, a value of the control, a caller, another coordinate system: no one knows
// the moves. The message says which.
TEST(InlineMoves, WhatOthersDecideIsRefused) {
  struct Case {
    std::string text;
    std::string reason;
  };
  for (const Case& one : {
           Case{"G0 X0 Y0\nCIP X=R1 Y0 I1=10 J1=10 F200\nM30\n", "the variable R1, which nothing here sets"},
           Case{"G0 X0 Y0\nR1=$AA_IM[X]\nCIP X20 Y0 I1=10 J1=10 F200\nM30\n", "which the control knows"},
           Case{"G0 X0 Y0\nTRANS X10\nCIP X20 Y0 I1=10 J1=10 F200\nTRANS\nM30\n", "another coordinate system"},
           Case{"G0 X0 Y0\nL100\nCIP X20 Y0 I1=10 J1=10 F200\nM30\n", "a call of another program"},
           Case{"G0 X0 Y0\nCIP X20 Y0 I1=10 J1=10 F200\nM17\n", "not a main program"},
           Case{"CIP X20 Y0 I1=10 J1=10 F200\nM30\n", "does not know"},
           Case{"G0 X0 Y0\n/1 X1\n/2 X2\nCIP X20 Y0 I1=10 J1=10 F200\nM30\n", "block skip of several levels"},
       }) {
    const std::string here =
        refusal("G17 G90 G71 G94\nG0 Z5\n" + one.text, "sinumerik-840d", "fanuc", MachineKind::mill);
    EXPECT_NE(here.find(one.reason), std::string::npos) << here;
    EXPECT_NE(here.find("CIP"), std::string::npos) << here;
  }
  const std::string nose =
      refusal(kLathe +
                  "G42 G00 X61.\nG71 U2. R0.5\nG71 P10 Q20 U0.4 W0.1 F0.3\nN10 G00 X20.\nG01 Z-20. F0.1\nN20 X62.\n"
                  "G40 G00 X100.\nM30\n%\n",
              "fanuc", "sinumerik-840d", MachineKind::lathe);
  EXPECT_NE(nose.find("G71 where the radius is compensated"), std::string::npos) << nose;
  const std::string two =
      refusal("%_N_A_MPF\nG17 G90 G71 G94\nG0 X0 Y0\nCIP X20 Y0 I1=10 J1=10 F200\nM30\n%_N_B_SPF\nM17\n",
              "sinumerik-840d", "fanuc", MachineKind::mill);
  EXPECT_NE(two.find("CIP together with another program in the same text"), std::string::npos) << two;
}

// What goes along with a shape's blocks, and what counts on a cycle that is no longer there.
TEST(InlineMoves, WhatWouldBeLostIsRefused) {
  const std::string rough = "G71 U2. R0.5\nG71 P10 Q20 U0.4 W0.1 F0.3\n";
  const auto lathe = [&](const std::string& shape) {
    return refusal(kLathe + rough + shape + "G00 X100.\nM30\n%\n", "fanuc", "sinumerik-840d", MachineKind::lathe);
  };
  for (const std::string shape :
       {"N10 G00 X20. M68\nG01 Z-20. F0.1\nN20 X62.\n", "N10 G00 X20.\n#500=5\nN20 G01 X62. Z-9. F0.1\n",
        "N10 G00 X20.\nG50 S800\nN20 G01 X62. Z-9. F0.1\n"}) {
    const std::string here = lathe(shape);
    EXPECT_NE(here.find("a shape that holds more than moves"), std::string::npos) << here;
  }
  // The second shape has the numbers of the first: which one is meant is not as it looks.
  const std::string one = "N10 G00 X20.\nG01 Z-20. F0.1\nN20 X62.\n";
  refusal(
      kLathe + rough + one + "G00 X62. Z-18.\n" + rough + "N10 G00 X50.\nG01 Z-40. F0.1\nN20 X62.\nG00 X100.\nM30\n%\n",
      "fanuc", "sinumerik-840d", MachineKind::lathe);
  const std::string mill = "%\nO1\nG21 G17 G90 G94 G40\nS800 M03\nG00 X0. Y0. Z20.\n";
  const std::string figure = "G34 X50. Y50. I20. J0. K4\n";
  for (const std::string to : {"fanuc", "sinumerik-840d"}) {
    // An oriented stop, a tap; holes and a level that count on the cycle after the figure.
    refusal(mill + "G98 G87 Z-10. R-15. Q0.2 F100. L0\n" + figure + "G80\nM30\n%\n", "mitsubishi-m80", to,
            MachineKind::mill);
    refusal(mill + "G98 G84 Z-10. R5. F100. L0\n" + figure + "G80\nM30\n%\n", "mitsubishi-m80", to, MachineKind::mill);
    refusal(mill + "G98 G81 Z-5. R2. F100. L0\n" + figure + "X100. Y50.\nX100. Y60.\nG80\nM30\n%\n", "mitsubishi-m80",
            to, MachineKind::mill);
    refusal(mill + "G99 G81 Z-5. R2. F100. L0\n" + figure + "G98 G81 X100. Y50. Z-5. R2.\nX120.\nG80\nM30\n%\n",
            "mitsubishi-m80", to, MachineKind::mill);
    // A level that the figure's block says itself stays.
    expect_same_there(
        mill + "G99 G81 X5. Y5. Z-5. R2. F100.\nG98 " + figure + "G81 X100. Y50. Z-5. R2.\nX120.\nG80\nM30\n%\n",
        "mitsubishi-m80", to, MachineKind::mill);
  }
}

TEST(InlineMoves, ACycleThatBecameMovesIsReported) {
  const std::string text = kLathe + "G00 X0 Z5.\nG83 Z-30. R-3. Q5000 F0.1\nG80\nG00 Z20.\nM30\n%\n";
  const ConvertResult made = converted(text, "fanuc", "sinumerik-840d", MachineKind::lathe);
  const std::string here = messages_of(made.diagnostics, text::Source("program", text));
  EXPECT_NE(here.find("it is written as its moves"), std::string::npos) << here;
  EXPECT_NE(here.find("warning"), std::string::npos) << here;
}

}  // namespace
}  // namespace dripfeed::compile::test
