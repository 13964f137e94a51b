// Frames, polar positions, arcs and corners of SINUMERIK programs, from text to motions. The oracle of each is the
// closed form in the test, or the rule of the Programming Manuals Fundamentals (PG) and Job Planning (PGA) that it
// names.
#include <cmath>

#include "tests/unit/dialects/compile/sinumerik_run.h"

namespace dripfeed::compile::test {
namespace {

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
  EXPECT_TRUE(oval.names("arcs that a frame stretches"));
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

// PG, "Circular interpolation with polar coordinates": the pole is the centre.
TEST(SinumerikGeometry, ArcsRoundThePole) {
  const Result ran = run("G17 G90 G0 X30 Y10 Z0\nG111 X10 Y10\nG3 AP=90 RP=20 F100\nG2 AP=IC(-90) RP=20\nM30\n");
  EXPECT_EQ(moves(ran),
            "1 rapid X30.0000 Y10.0000 Z0.0000\n"
            "3 arc-ccw X10.0000 Y30.0000 Z0.0000 G17 I-20.0000 J0.0000 K0.0000 F100.0000/min\n"
            "4 arc-cw X30.0000 Y10.0000 Z0.0000 G17 I0.0000 J-20.0000 K0.0000 F100.0000/min\n");
  // Turned by a frame: the pole turns along.
  const Result turned = run("G17 G90 G0 X0 Y0 Z0\nROT Z90\nG0 X20 Y0\nG111 X0 Y0\nG3 AP=90 RP=20 F100\nM30\n");
  EXPECT_TRUE(turned.trace.contains("5 arc-ccw X-20.0000 Y0.0000 Z0.0000 G17 I0.0000 J-20.0000")) << turned.trace;
  // A centre, a radius or an angle of its own goes first.
  const Result own = run("G17 G90 G0 X30 Y10 Z0\nG111 X10 Y10\nG3 AP=90 RP=20 CR=20 F100\nM30\n");
  EXPECT_TRUE(own.trace.contains("I-20.0000 J0.0000")) << own.trace;
  // Not on the circle round the pole: 14040.
  const Result off = run("G17 G90 G0 X35 Y10 Z0\nG111 X10 Y10\nG3 AP=90 RP=20 F100\nM30\n");
  EXPECT_FALSE(off.trace.contains("arc")) << off.trace;
}

// A quarter circle of radius 10: it leaves along Z and ends along X.
TEST(SinumerikGeometry, ATangentialArcInThePlaneOfALathe) {
  const Result ran = run("G18 G90 DIAMON G0 X40 Z5\nG1 Z-10 F100\nCT X60 Z-20\nM30\n");
  EXPECT_TRUE(ran.trace.contains("3 arc-cw X30.0000 Y0.0000 Z-20.0000 G18 I10.0000 J0.0000 K0.0000")) << ran.trace;
  // Where the line began is not known: neither is its direction.
  EXPECT_TRUE(run("G17 G90\nG1 X10 F100\nCT X20 Y10\nM30\n").names("arcs from or to a position that is not known"));
}

TEST(SinumerikGeometry, ArcThroughAPoint) {
  // Three points of the circle about (0, 0) with radius 10; the point in between states the direction round.
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
  EXPECT_TRUE(ran.names("arcs from or to a position that is not known"));
  EXPECT_EQ(alarm_of(ran), "14095");  // the last one: both ends are known, and it does not fit
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
  // direction.
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

TEST(SinumerikGeometry, MeasuringEndsWhereTheStateSaysThatTheProbeTouches) {
  const std::string text = "G17 G90 G0 X0 Y0 Z0\nMEAS=1 G1 X10 F100\nR1=$AA_IW[X]\nR2=$AA_MW[X]\nM30\n";
  const Result ran = run(text, {}, ir::MachineKind::mill,
                         {{.bank = ir::Bank::system, .number = 0, .name = "$AA_MW[X]", .value = 4.5}});
  EXPECT_TRUE(ran.trace.contains("2 linear X4.5000")) << ran.trace;
  EXPECT_EQ(ran.value("R1"), 4.5);
  EXPECT_EQ(ran.value("R2"), 4.5);
}

// MEAW does not end the move.
TEST(SinumerikGeometry, MeasuringWithoutDeletingThePathGoesToItsEnd) {
  const Result ran = run("G17 G90 G0 X0 Y0 Z0\nMEAW=1 G1 X10 F100\nR1=$AA_IW[X]\nM30\n");
  EXPECT_EQ(ran.value("R1"), 10.0);
  EXPECT_TRUE(ran.names("MEAW"));
}

TEST(SinumerikGeometry, TappingHasALead) {
  const Result ran = run("G17 G90 G0 X0 Y0 Z2\nG331 Z-20 K1.5 S500\nG332 Z2 K1.5\nG1 F100 G63 Z-5\nM30\n");
  EXPECT_TRUE(ran.trace.contains("2 thread X0.0000 Y0.0000 Z-20.0000 F1.5000/rev")) << ran.trace;
}

// --- frames as values (PGA, "Coordinate transformations (frames)")

TEST(SinumerikFrameValues, TheProgrammableFrameIsAChain) {
  const std::string head = "G17 G90 G0 X0 Y0 Z0\n";
  // 90 degrees take X to Y; the shift lies outside.
  EXPECT_EQ(moves(run(head + "$P_PFRAME=CTRANS(X,5):CROT(Z,90)\nX10 Y0\nM30\n")),
            "1 rapid X0.0000 Y0.0000 Z0.0000\n3 rapid X5.0000 Y10.0000 Z0.0000\n");
  EXPECT_EQ(moves(run(head + "$P_PFRAME=CTRANS(X,1):CSCALE(X,2):CMIRROR(Y)\nX10 Y5\nM30\n")),
            "1 rapid X0.0000 Y0.0000 Z0.0000\n3 rapid X21.0000 Y-5.0000 Z0.0000\n");
  EXPECT_EQ(moves(run(head + "TRANS X7\n$P_PFRAME=$P_PFRAME:CTRANS(Y,2)\nX1 Y1\n$P_PFRAME=CTRANS()\nX1 Y1\nM30\n")),
            "1 rapid X0.0000 Y0.0000 Z0.0000\n4 rapid X8.0000 Y3.0000 Z0.0000\n6 rapid X1.0000 Y1.0000 Z0.0000\n");
}

TEST(SinumerikFrameValues, ATurnInAPlane) {
  const std::string head = "G90 G0 X1 Y2 Z3\n";
  struct Row {
    std::string made, same;
  };
  const Row rows[] = {{"G17\n$P_PFRAME=CRPL(0,30)", "G17\nROT RPL=30"},
                      {"G18\n$P_PFRAME=CRPL(0,30)", "G18\nROT RPL=30"},
                      {"G19\n$P_PFRAME=CRPL(0,30)", "G19\nROT RPL=30"},
                      {"G17\n$P_PFRAME=CTRANS(X,10):CRPL(1,30)", "G17\n$P_PFRAME=CTRANS(X,10):CROT(Z,30)"},
                      {"G17\nR1=0\n$P_PFRAME=CRPL(R1,30)", "G17\nR1=0\nROT RPL=30"},
                      {"G17\nR1=3\n$P_PFRAME=CRPL(R1,30)", "G17\nR1=3\n$P_PFRAME=CROT(X,30)"},
                      {"G17\n$P_PFRAME=CRPL(2,30)", "G17\n$P_PFRAME=CROT(Y,30)"},
                      {"G17\n$P_PFRAME=CRPL(3,30):CMIRROR(Y)", "G17\n$P_PFRAME=CROT(X,30):CMIRROR(Y)"}};
  for (const Row& row : rows)
    EXPECT_EQ(moves(run(head + row.made + "\nX10 Y20 Z30\nM30\n")),
              moves(run(head + row.same + "\nX10 Y20 Z30\nM30\n")))
        << row.made;
}

// K2, "Frames": total = base : settable : programmable. $P_BFRAME at once, $P_UBFR with the next G500, G54 ...
TEST(SinumerikFrameValues, BaseFrames) {
  const std::string head = "G17 G90 G54 G0 X0 Y0 Z0\n$P_UIFR[1]=CTRANS(X,100)\nG54\n";
  // The zero goes 5 to the right: what stood at 7 stands at 2.
  const Result at_once = run(head + "$P_BFRAME=CTRANS(X,1)\nX7 Y0 Z0\n$P_BFRAME=CTRANS(X,6)\nG91 X1\nM30\n");
  EXPECT_TRUE(at_once.trace.contains("7 rapid X3.0000 Y0.0000 Z0.0000")) << at_once.trace;
  const Result turned = run(head + "$P_BFRAME=CTRANS()\nX7 Y0 Z0\n$P_BFRAME=CROT(Z,90)\nG91 X1 Y1\nM30\n");
  // The settable zero turns as well: (107, 0) is (0, -107) in the turned base, 100 to the left of it is (-100, -107).
  EXPECT_TRUE(turned.trace.contains("7 rapid X-99.0000 Y-106.0000 Z0.0000")) << turned.trace;
  // In memory: nothing moves until the offset is selected again.
  const Result later = run(head +
                           "$P_UBFR=CTRANS(X,1)\nG54\nX7 Y0 Z0\n$P_UBFR=CTRANS(X,6)\nG91 X1\nG54\nX1\n"
                           "R1=$P_UBFR[X,TR] R2=$P_BFRAME[X,TR]\nM30\n");
  EXPECT_TRUE(later.trace.contains("8 rapid X8.0000")) << later.trace;
  EXPECT_TRUE(later.trace.contains("10 rapid X4.0000")) << later.trace;
  EXPECT_EQ(later.value("R1"), 6.0);
  EXPECT_EQ(later.value("R2"), 6.0);
  // Where the settable frame is not known, neither is the place.
  const Result unknown =
      run("G17 G90 G54 G0 X0 Y0 Z0\n$P_BFRAME=CTRANS(X,1)\nX0 Y0 Z0\n$P_BFRAME=CTRANS(X,6)\nG91 X1\nM30\n");
  EXPECT_TRUE(unknown.names("increments from a position that is not known"));
  // A base frame of the machine is an input.
  EXPECT_TRUE(run("R1=$P_BFRAME[X,TR]\nM30\n").names("base frame"));
}

TEST(SinumerikGeometry, AFeedOfOneBlock) {
  const Result ran = run("G17 G90 G94 G0 X0 Y0 Z0\nG1 X1 F100\nX2 FB=40\nX3\nG700 X1 FB=2\nM30\n");
  EXPECT_TRUE(ran.trace.contains("3 linear X2.0000 Y0.0000 Z0.0000 F40.0000/min")) << ran.trace;
  EXPECT_TRUE(ran.trace.contains("4 linear X3.0000 Y0.0000 Z0.0000 F100.0000/min"));
  EXPECT_TRUE(ran.trace.contains("5 linear X25.4000 Y0.0000 Z0.0000 F50.8000/min"));
}

// OFFN counts with the compensation of the radius alone.
TEST(SinumerikGeometry, AnOffsetOfTheContourIsReportedWhereItActs) {
  constexpr auto kReported = "OFFN: an offset of the contour in addition to the tool's radius";
  const std::string head = "G17 G90 G94 T1 D1\nG1 X0 Y0 Z0 F100\n";
  EXPECT_FALSE(run(head + "OFFN=0\nG41 X5\nX10\nG40 X20\nM30\n").names(kReported));
  EXPECT_FALSE(run(head + "OFFN=2\nX10\nOFFN=0\nG41 X15\nG40 X20\nM30\n").names(kReported));
  EXPECT_TRUE(run(head + "OFFN=2\nG41 X5\nX10\nG40 X20\nM30\n").names(kReported));
}

// Corners of polar words: the right angle at (10, 0) as AP and RP say it.
TEST(SinumerikGeometry, CornersOfPolarWords) {
  const std::string head = "G17 G90 G0 X0 Y0 Z0\nG111 X0 Y0\n";
  const std::string by_words = moves(run(head + "G1 X10 Y0 RND=2 F100\nX10 Y10 CHR=1\nX0 Y10\nM30\n"));
  const std::string polar =
      moves(run(head + "G1 AP=0 RP=10 RND=2 F100\nAP=45 RP=14.142135623730951 CHR=1\nAP=90 RP=10\nM30\n"));
  EXPECT_EQ(polar, by_words);
  EXPECT_TRUE(polar.contains("arc-ccw")) << polar;
}

TEST(SinumerikFrameValues, PartsAreReadAndWritten) {
  const Result result =
      run("DEF FRAME FR, OTHER\nG17 G90 G0 X0 Y0 Z0\nFR=CTRANS(X,5,Y,6):CROT(Z,30):CSCALE(X,2)\nOTHER=FR\nFR[X,TR]=7\n"
          "R1=FR[Y,TR] R2=FR[Z,RT] R3=FR[X,SC] R4=OTHER[X,TR] R5=FR[X,TR]\n"
          "TRANS X3\nR6=$P_PFRAME[X,TR]\n$P_PFRAME[Y,TR]=4\nX1 Y1\nM30\n");
  EXPECT_EQ(result.value("R1"), 6.0);
  EXPECT_NEAR(result.value("R2"), 30.0, 1e-9);
  EXPECT_NEAR(result.value("R3"), 2.0, 1e-12);
  EXPECT_EQ(result.value("R4"), 5.0);
  EXPECT_EQ(result.value("R5"), 7.0);
  EXPECT_EQ(result.value("R6"), 3.0);
  EXPECT_EQ(moves(result), "2 rapid X0.0000 Y0.0000 Z0.0000\n10 rapid X4.0000 Y5.0000 Z0.0000\n");
}

TEST(SinumerikFrameValues, SettableFramesMoveTheZeroPoint) {
  const std::string text =
      "G17 G90 G71 G94\n$P_UIFR[1]=CTRANS(X,10)\n$P_UIFR[2]=CTRANS(X,15,Y,3)\nG54\nG0 X20 Y0 Z0\n%sG55\nG91 X1\nM30\n";
  const auto with = [&](const std::string& line) {
    std::string made = text;
    return moves(run(made.replace(made.find("%s"), 2, line)));
  };
  // The machine stands at X30 Y0: in the second offset at X15 Y-3.
  EXPECT_EQ(with(""), "5 rapid X20.0000 Y0.0000 Z0.0000\n7 rapid X16.0000 Y-3.0000 Z0.0000\n");
  EXPECT_EQ(with("$P_UIFR[2,X,TR]=20\n"), "5 rapid X20.0000 Y0.0000 Z0.0000\n8 rapid X11.0000 Y-3.0000 Z0.0000\n");
  // The second turned by 90 degrees: what lies along X lies along -Y.
  EXPECT_EQ(with("$P_UIFR[2]=CROT(Z,90)\n"), "5 rapid X20.0000 Y0.0000 Z0.0000\n8 rapid X1.0000 Y-30.0000 Z0.0000\n");
  EXPECT_EQ(run("$P_UIFR[2]=CTRANS(X,15,Y,3)\nR1=$P_UIFR[2,Y,TR]\nM30\n").value("R1"), 3.0);
}

TEST(SinumerikFrameValues, AnOffsetThatOnlyTheControlKnowsStaysUnknown) {
  const Result result = run("G17 G90 G71 G94\n$P_UIFR[1]=CTRANS(X,10)\nG54\nG0 X20 Y0 Z0\nG55\nG91 X1\nM30\n");
  ASSERT_FALSE(result.motions.empty());
  EXPECT_NE(result.motions.back().axes_unknown & 1U, 0U);
}

TEST(SinumerikFrameValues, AnOffsetWrittenInPartIsUnknownWhereItIsSelectedAgain) {
  const std::string text = "G17 G90 G71 G94 G54\nG0 X20 Y0 Z0\n$P_UIFR[1,X,TR]=12.5\n%sG91 X1\nM30\n";
  std::string again = text;
  const Result selected = run(again.replace(again.find("%s"), 2, "G54\n"));
  EXPECT_NE(selected.motions[selected.motions.size() - 2].axes_unknown & 1U, 0U) << selected.trace;
  std::string once = text;
  const Result kept = run(once.replace(once.find("%s"), 2, ""));
  EXPECT_EQ(kept.motions[kept.motions.size() - 2].axes_unknown & 1U, 0U) << kept.trace;
}

TEST(SinumerikFrameValues, CoarseAndFineShifts) {
  EXPECT_EQ(moves(run("G17 G90 G0 X0 Y0 Z0\nG58 X5\nG59 X2\nX1\nG58 X10\nX1\nG59 X0\nX1\nM30\n")),
            "1 rapid X0.0000 Y0.0000 Z0.0000\n4 rapid X8.0000 Y0.0000 Z0.0000\n6 rapid X13.0000 Y0.0000 Z0.0000\n"
            "8 rapid X11.0000 Y0.0000 Z0.0000\n");
  EXPECT_EQ(moves(run("G17 G90 G0 X0 Y0 Z0\nTRANS X5\nATRANS X2\nG58 X10\nX1\nM30\n")),
            "1 rapid X0.0000 Y0.0000 Z0.0000\n5 rapid X13.0000 Y0.0000 Z0.0000\n");
}

TEST(SinumerikFrameValues, FramesAreNoNumbers) {
  EXPECT_EQ(alarm_of(run("DEF FRAME FR\nFR=5\nM30\n")), "12150");
  EXPECT_EQ(alarm_of(run("R1=CTRANS(X,5)\nM30\n")), "12150");
  EXPECT_EQ(alarm_of(run("DEF FRAME FR\nR1=FR+1\nM30\n")), "12150");
}

}  // namespace
}  // namespace dripfeed::compile::test
