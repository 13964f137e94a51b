// Standard cycles of SINUMERIK, from the call to motions. The oracle of each is the sequence that the Programming
// Manual Cycles (PGZ) states.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "dialects/text/number.h"
#include "tests/unit/dialects/compile/sinumerik_run.h"

namespace dripfeed::compile::test {
namespace {

// --- standard cycles

// AXN: the first or second axis of the plane; 0 and 3 are the one that stands on it.
TEST(SinumerikCycles, DrillAlongAnotherAxisOfThePlane) {
  const std::string turned = "G18 G90 G94 F100 S400 M3\nG0 X0 Y0 Z50\n";
  const std::string standing = "G17 G90 G94 F100 S400 M3\nG0 X0 Y0 Z50\n";
  struct Row {
    std::string begin;
    std::string end;
  };
  for (const Row& row :
       {Row{"CYCLE83(20,0,3,-12,,,5,0,0.5,,1,1", ",2)"}, Row{"CYCLE84(20,0,3,-12,,0,3,,1.5,0,400,400", ")"},
        Row{"CYCLE840(20,0,3,-12,,0,4,3,0,,1.5", ")"}}) {
    const std::string in_g17 = moves(run(standing + row.begin + ",0" + row.end + "\nM30\n"));
    EXPECT_EQ(moves(run(turned + row.begin + ",1" + row.end + "\nM30\n")), in_g17);
    EXPECT_EQ(moves(run(standing + row.begin + ",3" + row.end + "\nM30\n")), in_g17);
    const std::string along_x = moves(run(turned + row.begin + ",2" + row.end + "\nM30\n"));
    EXPECT_NE(along_x.find("X-12.0000 Y0.0000 Z50.0000"), std::string::npos) << along_x;
  }
}

TEST(SinumerikCycles, Drilling) {
  // PGZ, CYCLE81: to RFP + SDIS by rapid, to the depth by feed, to RTP by rapid; DPR counts from RFP.
  const Result ran = run("G17 G90 G0 X1 Y2 Z50\nF100\nCYCLE81(20,0,2,-12)\nCYCLE82(20,5,2,,10,0.5)\nG0 X0\nM30\n");
  EXPECT_EQ(moves(ran),
            "1 rapid X1.0000 Y2.0000 Z50.0000\n3 rapid X1.0000 Y2.0000 Z2.0000\n"
            "3 linear X1.0000 Y2.0000 Z-12.0000 F100.0000/min\n3 rapid X1.0000 Y2.0000 Z20.0000\n"
            "4 rapid X1.0000 Y2.0000 Z7.0000\n4 linear X1.0000 Y2.0000 Z-5.0000 F100.0000/min\n4 dwell P0.5000\n"
            "4 rapid X1.0000 Y2.0000 Z20.0000\n5 rapid X0.0000 Y2.0000 Z20.0000\n");
}

// PGZ: a drilling pattern leaves the modes of its caller as they were.
TEST(SinumerikCycles, PatternsLeaveTheModes) {
  const Result ran = run("G17 G90 G94 F100\nG0 X0 Y0 Z10\nG91 G1\nHOLES1(0,0,0,10,10,2)\nX5\nM30\n");
  EXPECT_TRUE(moves(ran).ends_with("5 linear X25.0000 Y0.0000 Z10.0000 F100.0000/min\n")) << moves(ran);
}

TEST(SinumerikCycles, DeepHoles) {
  // Chip breaking without degression: strokes of 5 mm, back by 1 mm after each.
  const Result ran = run("G17 G90 G0 X0 Y0 Z50\nF100\nCYCLE83(20,0,2,-15,,,5,0,0,0,1,0)\nM30\n");
  std::string depths;
  for (const ir::Motion& m : ran.motions)
    if (m.kind == ir::MotionKind::linear) depths += std::to_string(static_cast<int>(m.end[2])) + " ";
  EXPECT_EQ(depths, "-5 -4 -10 -9 -15 ");
}

// PGZ, CYCLE83, "Degression", as the control's cycle (V06.02.09) cuts it: each stroke is DAM shorter than the one
// before and never shorter than DAM; where at most 2 DAM are left, the last two are alike, and no stroke leaves less
// than DAM. DAM below 0 is the factor of each stroke, and MDEP the shortest one then: where a stroke would leave less
// than MDEP, the last two are alike.
std::vector<double> strokes_by_the_manual(double depth, double first, double degression, double least) {
  std::vector<double> ends;
  double stroke = first;
  double next = first;
  for (double at = 0.0; at < depth;) {
    at = std::min(at + next, depth);
    ends.push_back(-at);
    const double left = depth - at;
    if (degression > 0.0) {
      stroke = std::max(stroke - degression, degression);
      next = left <= stroke                ? left
             : left <= 2.0 * degression    ? left / 2.0
             : left - stroke >= degression ? stroke
                                           : left - degression;
    } else if (degression < 0.0) {
      stroke = std::max(-stroke * degression, least);
      next = stroke <= left && left - stroke < least ? left / 2.0 : stroke;
    }
  }
  return ends;
}

TEST(SinumerikCycles, DeepHolesGetShallowerByStrokes) {
  int holes = 0;
  for (const double depth : {20.0, 25.0, 30.0, 37.0})
    for (const double first : {5.0, 8.0, 10.0})
      for (const double degression : {0.0, 1.0, 2.0, 3.0, 4.0, -0.5, -0.8})
        for (const double least : {1.0, 2.5}) {
          const std::string call =
              fmt::format("CYCLE83(20,0,2,-{},,-{},,{},0,0,1,1,0,{})", depth, first, degression, least);
          const Result ran = run("G17 G90 G0 X0 Y0 Z50\nF100\n" + call + "\nM30\n");
          std::vector<double> ends;
          for (const ir::Motion& m : ran.motions)
            if (m.kind == ir::MotionKind::linear) ends.push_back(m.end[2]);
          const std::vector<double> wanted = strokes_by_the_manual(depth, first, degression, least);
          ASSERT_EQ(ends.size(), wanted.size()) << call << "\n" << moves(ran);
          for (std::size_t i = 0; i < ends.size(); ++i) EXPECT_NEAR(ends[i], wanted[i], 1e-9) << call << " " << i;
          ++holes;
        }
  EXPECT_EQ(holes, 168);
}

// What is not given is a distance in mm, whatever the unit of the call is: 1 mm back to break chips, 0.6 mm above the
// last depth, the leads of metric threads.
TEST(SinumerikCycles, DistancesThatAreNotGivenAreMillimetres) {
  const auto ends_of = [](const std::string& call) {
    std::string out;
    for (const ir::Motion& m : run("G17 G90 G700 G0 X0 Y0 Z2\nS400 M3 F5\n" + call + "\nM30\n").motions)
      if (ir::is_move(m.kind) && m.place.line == 3) out += text::format_fixed(m.end[2], 1) + " ";
    return out;
  };
  EXPECT_EQ(ends_of("CYCLE83(1,0,0.1,-1,,,0.5,0,0,0,1,0)"), "2.5 -12.7 -11.7 -25.4 25.4 ");
  EXPECT_EQ(ends_of("CYCLE83(1,0,0.1,-1,,,0.5,0,0,0,1,1)"), "2.5 -12.7 2.5 -12.1 -25.4 25.4 ");
  EXPECT_EQ(ends_of("CYCLE84(1,0,0.1,-1,,0,3,,0.05,0,400,400,3,0,0,1,0.5)"), "2.5 -12.7 -11.7 -25.4 2.5 25.4 ");
  const Result size = run("G17 G90 G700 G0 X0 Y0 Z2\nCYCLE84(1,0,0.1,-1,,0,3,8,,0,400,400)\nM30\n");
  EXPECT_TRUE(size.trace.contains("Z-25.4000 F1.2500/rev")) << size.trace;
}

// A factor without a shortest stroke would never come to the depth.
TEST(SinumerikCycles, DeepHolesByAFactorEnd) {
  const Result ran = run("G17 G90 G0 X0 Y0 Z50\nF100\nCYCLE83(20,0,2,-30,,-10,,-0.5,0,0,1,1)\nM30\n");
  EXPECT_EQ(ran.result.ended, interpreter::Ended::alarm);
}

// PGZ, CYCLE84: VARI 1 breaks chips by VRT, 2 goes out of the hole and back in up to VRT above the last step; each step
// is DAM, and the last two are alike where at most 2 DAM are left. The spindle was turned by its
// position: without SDAC 3 or 4 it stands.
TEST(SinumerikCycles, TapsByStepsAndTheSpindleAfterThem) {
  const auto ends_of = [](const std::string& steps) {
    std::string out;
    for (const ir::Motion& m :
         run("G17 G90 G0 X0 Y0 Z50\nS400 M3\nCYCLE84(20,0,3,-12,,0,3,,1.5,0,400,400,3,0,0," + steps + ")\nM30\n")
             .motions)
      if (m.kind == ir::MotionKind::thread) out += fmt::format("{} ", m.end[2]);
    return out;
  };
  EXPECT_EQ(ends_of("0,5,1"), "-12 3 ");
  EXPECT_EQ(ends_of("1,5,2"), "-5 -3 -8.5 -6.5 -12 3 ");
  EXPECT_EQ(ends_of("1,5"), "-5 -4 -8.5 -7.5 -12 3 ");
  EXPECT_EQ(ends_of("2,5,2"), "-5 3 -3 -8.5 3 -6.5 -12 3 ");
  for (const auto& [sdac, state] : {std::pair("3", ir::SpindleState::clockwise),
                                    {"4", ir::SpindleState::counterclockwise},
                                    {"5", ir::SpindleState::stopped},
                                    {"0", ir::SpindleState::stopped},
                                    {"", ir::SpindleState::stopped}}) {
    const Result ran = run(std::string("G17 G90 G0 X0 Y0 Z50\nS400 M3\nCYCLE84(20,0,3,-12,,0,") + sdac +
                           ",,1.5,0,400,400)\nG0 X5\nM30\n");
    EXPECT_EQ(ran.motions[ran.motions.size() - 2].spindle, state) << sdac << "\n" << ran.trace;
  }
}

// PGZ, CYCLE81: of two depths that of DPR counts; a hole without depth is not drilled.
TEST(SinumerikCycles, ADepthBelowThePlaneGoesBeforeOneInCoordinates) {
  const auto drilled = [](const std::string& call) {
    std::string out;
    for (const ir::Motion& m : run("G17 G90 G94 G0 X0 Y0 Z50\nF100 S500 M3\n" + call + "\nM30\n").motions)
      if (m.kind == ir::MotionKind::linear) out += fmt::format("{} ", m.end[2]);
    return out;
  };
  EXPECT_EQ(drilled("CYCLE81(20,5,2,-12,10)"), "-5 ");
  EXPECT_EQ(drilled("CYCLE81(20,5,2)"), "0 ");
  EXPECT_EQ(drilled("CYCLE82(20,0,2)"), "");
  EXPECT_EQ(drilled("CYCLE83(20,0,2,,12,-5,7,0,0,0,1,1)"), "-7 -12 ");
}

// The modes of the operator's screen (PGA, "Programming cycles externally"): percents, dwells in turns, planes.
TEST(SinumerikCycles, ModesOfTheScreen) {
  const std::string begin = "G17 G90 G94 G0 X0 Y0 Z50\nF100 S600 M3\n";
  const Result percent = run(begin + "CYCLE83(10,0,2,,20,,5,100,0,0,90,1,0,0,1,0,1,0,1,11211111)\nM30\n");
  std::string cut;
  for (const ir::Motion& m : percent.motions)
    if (m.kind == ir::MotionKind::linear) cut += fmt::format("{} {}, ", m.end[2], m.feed);
  EXPECT_EQ(cut, "-5 90, -10 100, -15 100, -20 100, ");
  const Result turns = run(begin + "CYCLE82(10,0,2,-5,,3,0,1,22)\nM30\n");
  EXPECT_TRUE(turns.trace.contains("dwell P0.3000")) << turns.trace;
  const Result plane = run(begin + "CYCLE82(10,0,2,-5,,0,0,2,12)\nM30\n");
  EXPECT_TRUE(plane.trace.contains("linear X0.0000 Y-5.0000 Z50.0000")) << plane.trace;
  const Result shank = run(begin + "CYCLE82(10,0,2,-5,,0,10,1,12)\nM30\n");
  EXPECT_TRUE(shank.names("$P_TOOLR"));
  EXPECT_TRUE(shank.names("Z from a value that is not known"));
}

// PITA: 1 is mm, 2 threads an inch, 3 inch.
TEST(SinumerikCycles, TheUnitOfALead) {
  const auto lead_of = [](const std::string& unit, const std::string& values) {
    for (const ir::Motion& m :
         run("G17 G90 G94 " + unit + " G0 X0 Y0 Z2\nS400 M3\nCYCLE84(1,0,0.1,-0.5,,0,3,," + values + ")\nM30\n")
             .motions)
      if (m.kind == ir::MotionKind::thread) return m.feed;
    return 0.0;
  };
  EXPECT_NEAR(lead_of("G710", "20,0,400,400,0,2"), 1.27, 1e-9);
  EXPECT_NEAR(lead_of("G710", "0.05,0,400,400,0,3"), 1.27, 1e-9);
  EXPECT_NEAR(lead_of("G700", "20,0,400,400,0,2"), 1.27, 1e-9);
  EXPECT_NEAR(lead_of("G700", "1.5,0,400,400,0,1"), 1.5, 1e-9);
}

// PGZ, HOLES1: from the end that is nearer to where the tool stands.
TEST(SinumerikCycles, ARowBeginsAtTheNearerEnd) {
  const auto ends_of = [](const std::string& start) {
    std::string out;
    for (const ir::Motion& m : run("G17 G90 G0 " + start + " Z50\nHOLES1(0,0,90,10,10,3)\nM30\n").motions)
      if (m.kind == ir::MotionKind::rapid && m.place.line == 2) out += text::format_fixed(m.end[1], 0) + " ";
    return out;
  };
  EXPECT_EQ(ends_of("X0 Y0"), "10 20 30 ");
  EXPECT_EQ(ends_of("X0 Y40"), "30 20 10 ");
  EXPECT_EQ(ends_of("X0 Y20"), "10 20 30 ");
}

TEST(SinumerikCycles, TappingByLeadAndBySize) {
  const Result ran = run("G17 G90 G0 X0 Y0 Z50\nCYCLE84(20,0,3,-12,,0,3,,1.5,0,400,400)\nM30\n");
  EXPECT_TRUE(ran.trace.contains("thread X0.0000 Y0.0000 Z-12.0000 F1.5000/rev")) << ran.trace;
  const Result size = run("G17 G90 G0 X0 Y0 Z50\nCYCLE84(20,0,3,-12,,0,3,8,,0,400,400)\nM30\n");
  EXPECT_TRUE(size.trace.contains("thread X0.0000 Y0.0000 Z-12.0000 F1.2500/rev")) << size.trace;
}

// PGZ, "Tapping with compensating chuck": G33 with an encoder, G63 without, the spindle turned round between.
TEST(SinumerikCycles, TappingWithACompensatingChuck) {
  const Result ran = run("G17 G90 G94 G0 X0 Y0 Z50\nS400 M3\nCYCLE840(20,0,3,-12,,0,4,3,0,,1.5)\nM30\n");
  EXPECT_TRUE(
      ran.trace.contains("3 rapid X0.0000 Y0.0000 Z3.0000\n3 thread X0.0000 Y0.0000 Z-12.0000 F1.5000/rev\n"
                         "3 spindle ccw S400.0000/rpm\n3 thread X0.0000 Y0.0000 Z3.0000 F1.5000/rev\n"
                         "3 rapid X0.0000 Y0.0000 Z20.0000\n3 spindle cw S400.0000/rpm\n"))
      << ran.trace;
  const Result feed = run("G17 G90 G94 G0 X0 Y0 Z50\nS400 M3\nF600\nCYCLE840(20,0,3,-12,,0,0,5,1)\nM30\n");
  EXPECT_TRUE(feed.trace.contains("linear X0.0000 Y0.0000 Z-12.0000 F600.0000/min\n4 spindle ccw")) << feed.trace;
  EXPECT_EQ(alarm_of(run("G17 G90 G0 X0 Y0 Z50\nS400 M3\nCYCLE840(20,0,3,-12,,0,4,3,0)\nM30\n")), "61001");
}

TEST(SinumerikCycles, BoringCycles) {
  // CYCLE85: in by FFR, out by RFF; CYCLE86: lifted off by RPA, RPO, RPAP before it goes out, and back next to the
  // hole.
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

// MPIT 24 is M24, whose lead is 3 (ISO 261).
TEST(SinumerikCycles, ThreadsByTheirSize) {
  const std::string head = "G18 G90 G95 G0 X60 Z10 S500 M3\n";
  const Result ran = run(head + "CYCLE97(,24,0,-30,24,24,4,2,1.84,0,0,0,4,0,3,1)\nM30\n", {}, ir::MachineKind::lathe);
  EXPECT_TRUE(ran.trace.contains("thread X20.3200 Z-32.0000 F3.0000/rev")) << ran.trace;
  EXPECT_EQ(alarm_of(run(head + "CYCLE97(,,0,-30,24,24,4,2,1,0,0,0,4,0,3,1)\nM30\n", {}, ir::MachineKind::lathe)),
            "61001");
}

TEST(SinumerikCycles, AProgramOfTheUserGoesBefore) {
  const Texts called = {{"CYCLE81", "PROC CYCLE81(REAL A)\nR1=A\nRET\n"}};
  EXPECT_EQ(run("CYCLE81(7)\nM30\n", called).value("R1"), 7.0);
}

TEST(SinumerikCycles, OthersAreNamed) {
  const Result ran = run("G17 G90 G0 X0 Y0 Z0\nCYCLE90(10,0,1,-5,,28,25,2,100,2,0,0,0)\nG91 G0 X1\nM30\n");
  EXPECT_TRUE(ran.names("CYCLE90"));
  EXPECT_TRUE(ran.names("increments from a position that is not known"));
}

// --- modal calls (PGA, "Modal subprogram call (MCALL)")

TEST(SinumerikModalCalls, ACycleIsCalledAfterEachBlockThatMoves) {
  const Result one = run("G0 X0 Y0 Z10\nMCALL CYCLE81(10,0,2,-5)\nX10 Y10 F100\nM8\nX20\nMCALL\nX30\nM30\n");
  const Result other = run("G0 X0 Y0 Z10\n\nX10 Y10 F100\nCYCLE81(10,0,2,-5)\nM8\nX20\nCYCLE81(10,0,2,-5)\nX30\nM30\n");
  ASSERT_EQ(one.motions.size(), other.motions.size()) << one.trace;
  for (std::size_t i = 0; i < one.motions.size(); ++i) EXPECT_EQ(one.motions[i].end, other.motions[i].end) << i;
}

TEST(SinumerikModalCalls, PatternsAreDrilled) {
  const Result result = run("G0 X0 Y0 Z10 F100\nMCALL CYCLE81(10,0,2,-5)\nHOLES1(0,0,0,10,10,3)\nMCALL\nX0\nM30\n");
  std::string holes;
  for (const ir::Motion& motion : result.motions)
    if (motion.kind == ir::MotionKind::linear) holes += std::to_string(static_cast<int>(motion.end[0])) + " ";
  EXPECT_EQ(holes, "10 20 30 ");
}

// PGZ, CYCLE802: up to nine positions, each with its digit for absolute (1) or incremental (2).
TEST(SinumerikModalCalls, FreePositionsAreDrilled) {
  const std::string head = "G17 G90 G0 X0 Y0 Z50\nF100\nMCALL CYCLE81(20,0,2,-5)\n";
  const Result ran = run(head + "CYCLE802(111111111,111111111,10,20,30,40,,,,,,,,,,,,,,,0,0,1)\nMCALL\nG1 X1\nM30\n");
  EXPECT_TRUE(ran.trace.contains("rapid X10.0000 Y20.0000 Z50.0000\n")) << ran.trace;
  EXPECT_TRUE(ran.trace.contains("linear X10.0000 Y20.0000 Z-5.0000 F100.0000/min\n")) << ran.trace;
  EXPECT_TRUE(ran.trace.contains("linear X30.0000 Y40.0000 Z-5.0000 F100.0000/min\n")) << ran.trace;
  EXPECT_EQ(std::ranges::count(ran.motions, ir::MotionKind::linear, &ir::Motion::kind), 3);
  EXPECT_TRUE(run(head + "CYCLE802(211111111,111111111,10,20,30,40)\nMCALL\nM30\n").names("CYCLE802"));
}

TEST(SinumerikModalCalls, ArgumentsAreThoseOfTheModalCall) {
  const Texts called = {{"UP", "PROC UP(REAL A, STRING[9] B)\nR5=R5+A\nMSG(B)\nG0 Z=A\nRET\n"}};
  const Result result = run("R1=3 R5=0\nMCALL UP(R1,\"first\")\nR1=100\nG0 X1\nX2\nMCALL\nX3\nM30\n", called);
  EXPECT_EQ(result.value("R5"), 6.0);
}

TEST(SinumerikModalCalls, ASecondOneTakesThePlaceOfTheFirst) {
  const Texts called = {{"ONE", "R5=R5+1\nRET\n"}, {"TWO", "R5=R5+10\nRET\n"}};
  const Result two = run("R5=0\nMCALL ONE\nG0 X1\nMCALL TWO\nX2\nX3\nMCALL\nX4\nM30\n", called);
  EXPECT_EQ(two.value("R5"), 21.0);
  EXPECT_FALSE(two.names("a modal call (G66) inside another"));
  EXPECT_EQ(run("R5=0\nMCALL ONE\nG0 X1\nMCALL POCKET4(1,2)\nX2\nMCALL\nM30\n", called).value("R5"), 1.0);
}

TEST(SinumerikModalCalls, ACallThatLacksItsProgramIsAnAlarm) {
  EXPECT_EQ(alarm_of(run("MCALL NOT_THERE(1)\nG0 X1\nM30\n")), "14011");
  EXPECT_TRUE(run("MCALL POCKET3(1,2)\nG0 X1\nMCALL\nM30\n").names("POCKET3"));
}

// MCALL acts after each block that moves along the path, by polar words, too.
TEST(SinumerikCycles, AModalCallFollowsPolarPositions) {
  const Result ran =
      run("G17 G90 G94 F100\nG0 X0 Y0 Z50\nG111 X10 Y10\nMCALL CYCLE81(50,0,2,-5)\nAP=0 RP=20\nAP=90\nMCALL\nM30\n");
  EXPECT_TRUE(ran.trace.contains("linear X30.0000 Y10.0000 Z-5.0000")) << ran.trace;
  EXPECT_TRUE(ran.trace.contains("linear X10.0000 Y30.0000 Z-5.0000")) << ran.trace;
}

// Each PROC of a text has the parameters of its own head.
TEST(SinumerikPrograms, EachHasItsOwnParameters) {
  const Result ran =
      run("%_N_MAIN_MPF\nG17 G90 G71 G94\nG0 Y0\nSUBA(3)\nSUBB(4,5)\nSUBC(6)\nM30\n%_N_SUBA_SPF\nPROC SUBA(REAL "
          "RA)\nX=RA\nRET\n"
          "%_N_SUBB_SPF\nPROC SUBB(REAL QA, REAL QB)\nX=QA Y=QB\nRET\n%_N_SUBC_SPF\nPROC SUBC(REAL PA)\nX=PA\nRET\n");
  std::string places;
  for (const ir::Motion& m : ran.motions)
    if (ir::is_move(m.kind))
      places += std::to_string(static_cast<int>(m.end[0])) + " " + std::to_string(static_cast<int>(m.end[1])) + "\n";
  EXPECT_EQ(places, "0 0\n3 0\n4 5\n6 5\n");
}

}  // namespace
}  // namespace dripfeed::compile::test
