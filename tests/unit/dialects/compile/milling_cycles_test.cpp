// SINUMERIK's milling cycles, from the call to motions. The oracle of regions is milled_region.h, that of levels,
// approaches and alarms the Programming Manual Cycles (PGZ).
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "dialects/text/number.h"
#include "tests/unit/dialects/compile/milled_region.h"
#include "tests/unit/dialects/compile/sinumerik_run.h"

namespace dripfeed::compile::test {
namespace {

constexpr double kStep_mm = 0.1;
constexpr double kTolerance_mm = 0.01;

Result mill(const std::string& text, double radius_mm, bool is_known = true) {
  ir::Control control = test::control("sinumerik-840d", ir::MachineKind::mill);
  control.semantics.power_on_known = true;
  if (is_known) control.tool_radii = {{.tool = 1, .offset = 1, .radius_mm = radius_mm}};
  return run_on(control, text);
}

std::string head(const std::string& more = "") {
  return "G17 G90 G94 G54\nT1 M6\nD1\nS1000 M3 F77\n" + more + "G0 X0 Y0 Z100\n";
}

std::string n(double value) { return text::format_shortest(value); }

std::vector<ir::Motion> cuts(const Result& ran) {
  std::vector<ir::Motion> out;
  for (const ir::Motion& m : ran.motions)
    if (ir::is_move(m.kind) && m.kind != ir::MotionKind::rapid) out.push_back(m);
  return out;
}

// Where the tool is at that level all along a move.
std::vector<Spot> spots_at(const Result& ran, double level) {
  std::vector<Spot> out;
  for (const ir::Motion& m : cuts(ran)) {
    if (std::abs(m.start[2] - level) > 1e-6 || std::abs(m.end[2] - level) > 1e-6) continue;
    const std::vector<Spot> more = spots_of(m, kStep_mm);
    out.insert(out.end(), more.begin(), more.end());
  }
  return out;
}

// Where it is below the surface.
std::vector<Spot> spots_below(const Result& ran, double surface) {
  std::vector<Spot> out;
  for (const ir::Motion& m : ran.motions) {
    if (!ir::is_move(m.kind)) continue;
    for (const Spot& s : spots_of(m, kStep_mm))
      if (s.z < surface - 1e-6) out.push_back(s);
  }
  return out;
}

double lowest(const Result& ran) {
  double z = 1e9;
  for (const ir::Motion& m : ran.motions)
    if (ir::is_move(m.kind)) z = std::min(z, m.end[2]);
  return z;
}

std::vector<double> levels(const Result& ran) {
  std::vector<double> out;
  for (const ir::Motion& m : cuts(ran))
    if (m.start[2] == m.end[2] && (out.empty() || std::abs(out.back() - m.end[2]) > 1e-9)) out.push_back(m.end[2]);
  return out;
}

ir::Motion last_move(const Result& ran) {
  ir::Motion last;
  for (const ir::Motion& m : ran.motions)
    if (ir::is_move(m.kind)) last = m;
  return last;
}

const std::string kOrder = "the order in which ";

// --- POCKET3

struct Pocket {
  double length = 60.0;
  double width = 40.0;
  double corner = 8.0;
  double x = 50.0;
  double y = 40.0;
  double angle = 0.0;
  double depth = 17.5;
  double infeed = 4.0;
  double side = 0.0;
  double base = 0.0;
  int direction = 0;
  int kind = 11;
  double step = 0.0;
  double helix = 0.0;  // RAD1
  double turn = 0.0;   // DP1

  [[nodiscard]] std::string call() const {
    return fmt::format("POCKET3(20,0,2,{},{},{},{},{},{},{},{},{},{},300,100,{},{},{},0,0,0,{},{})\n", n(-depth),
                       n(length), n(width), n(corner), n(x), n(y), n(angle), n(infeed), n(side), n(base), direction,
                       kind, n(step), n(helix), n(turn));
  }
  [[nodiscard]] RoundRectangle region(double allowance, double radius) const {
    return {.length = length - 2.0 * allowance,
            .width = width - 2.0 * allowance,
            .corner = std::max(corner - allowance, radius),
            .x = x,
            .y = y,
            .angle_deg = angle};
  }
};

void check_pocket(const Result& ran, const RoundRectangle& region, double radius, double base, double grid) {
  EXPECT_TRUE(ran.result.diagnostics.empty());
  EXPECT_NEAR(lowest(ran), base, 1e-9);
  for (const Spot& s : spots_below(ran, 0.0)) ASSERT_LE(region.distance(s), -radius + 1e-6) << s.x << " " << s.y;
  EXPECT_LE(uncovered_mm(region, spots_at(ran, base), radius, grid, 0.0), kTolerance_mm);
}

TEST(MillingCycles, APocketIsEmptiedAndNothingElse) {
  const Pocket pocket;
  const Result ran = mill(head() + pocket.call() + "M30\n", 5.0);
  check_pocket(ran, pocket.region(0.0, 5.0), 5.0, -17.5, 0.4);
  EXPECT_EQ(levels(ran), (std::vector<double>{-3.5, -7.0, -10.5, -14.0, -17.5}));
  EXPECT_TRUE(ran.names(kOrder + "POCKET3 removes the material"));
  EXPECT_EQ(ran.result.not_interpreted.size(), 1U);
}

// PGZ: to the retraction plane, over the centre, to the safety clearance; at the end back over the centre.
TEST(MillingCycles, APocketBeginsAndEndsOverItsCentre) {
  const Result ran = mill(head() + Pocket{.infeed = 0.0}.call() + "M30\n", 5.0);
  const std::size_t up = ran.trace.find("rapid X0.0000 Y0.0000 Z20.0000");
  const std::size_t first = ran.trace.find("rapid X50.0000 Y40.0000 Z20.0000");
  const std::size_t second = ran.trace.find("rapid X50.0000 Y40.0000 Z2.0000");
  const std::size_t third = ran.trace.find("linear X50.0000 Y40.0000 Z-17.5000 F100.0000/min");
  EXPECT_LT(up, first) << ran.trace;
  EXPECT_LT(first, second) << ran.trace;
  EXPECT_LT(second, third) << ran.trace;
  EXPECT_NE(third, std::string::npos) << ran.trace;
  const ir::Motion last = last_move(ran);
  EXPECT_EQ(last.kind, ir::MotionKind::rapid);
  EXPECT_EQ(last.end[0], 50.0);
  EXPECT_EQ(last.end[1], 40.0);
  EXPECT_EQ(last.end[2], 20.0);
}

// Each of the forms, steps, allowances and entries, and turned: nothing beyond the wall, and all within it.
TEST(MillingCycles, PocketsOfAllFormsAreEmptied) {
  std::mt19937 random(7);
  const auto between = [&](double low, double high) {
    return std::round(std::uniform_real_distribution(low, high)(random) * 100.0) / 100.0;
  };
  for (int trial = 0; trial < 60; ++trial) {
    const double radius = between(1.5, 5.0);
    Pocket p{.length = between(2.2 * radius + 1.0, 45.0), .width = between(2.2 * radius + 1.0, 45.0)};
    const double half = std::min(p.length, p.width) / 2.0;
    p.corner = trial % 4 == 0 ? 0.0 : trial % 4 == 1 ? std::floor(half * 100.0) / 100.0 : between(0.0, half - 0.01);
    p.angle = between(-90.0, 90.0);
    p.depth = between(1.0, 8.0);
    p.infeed = between(0.8, 4.0);
    p.side = trial % 3 == 0 ? 0.0 : between(0.05, std::min(0.5, half - radius - 0.05));
    p.base = trial % 3 == 0 ? 0.0 : between(0.05, 0.5);
    p.direction = trial % 4;
    p.kind = 1 + 10 * (trial % 4);
    p.step = trial % 2 == 0 ? 0.0 : between(0.3 * radius, 2.0 * radius);
    p.helix = trial % 4 == 2 ? between(0.5, 3.0 * radius) : 3.0;
    p.turn = between(0.5, 2.0);
    const Result ran = mill(head() + p.call() + "M30\n", radius);
    SCOPED_TRACE(p.call() + n(radius));
    check_pocket(ran, p.region(p.side, radius), radius, p.base - p.depth, 0.5);
  }
}

// Rings with sharp corners, as far apart as the tool is wide: nothing is left on the diagonals.
TEST(MillingCycles, CornersOfRingsLeaveNothingBetweenThem) {
  const Pocket pocket{.length = 59.0, .width = 59.0, .corner = 0.0, .depth = 1.0, .step = 10.0};
  const Result ran = mill(head() + pocket.call() + "M30\n", 5.0);
  check_pocket(ran, pocket.region(0.0, 5.0), 5.0, -1.0, 0.2);
}

TEST(MillingCycles, FinishingReachesTheWallAndTheBase) {
  const Pocket pocket{.side = 0.4, .base = 0.3, .kind = 12};
  const Result ran = mill(head() + pocket.call() + "M30\n", 5.0);
  check_pocket(ran, pocket.region(0.0, 5.0), 5.0, -17.5, 0.5);
  // Once around at each depth above the allowance of the base, then the base.
  const std::vector<double> at = levels(ran);
  ASSERT_EQ(at.size(), 6U);
  EXPECT_NEAR(at[0], -3.44, 1e-9);
  EXPECT_NEAR(at[4], -17.2, 1e-9);
  EXPECT_NEAR(at[5], -17.5, 1e-9);
  const Pocket wall{.side = 0.4, .base = 0.0, .kind = 12};
  const Result side = mill(head() + wall.call() + "M30\n", 5.0);
  double nearest = 1e9;
  for (const Spot& s : spots_at(side, -17.5)) nearest = std::min(nearest, -wall.region(0.0, 5.0).distance(s));
  EXPECT_NEAR(nearest, 5.0, 1e-6);
}

// Climb milling with the spindle clockwise leaves the wall on the right: counterclockwise in a pocket.
TEST(MillingCycles, TheDirectionIsThatOfTheSpindleOrStated) {
  const auto has = [](const Result& ran, ir::MotionKind kind) {
    return std::ranges::any_of(ran.motions, [&](const ir::Motion& m) { return m.kind == kind; });
  };
  struct Row {
    int direction;
    std::string spindle;
    bool ccw;
  };
  for (const Row& row : {Row{0, "M3\n", true}, Row{1, "M3\n", false}, Row{0, "M4\n", false}, Row{1, "M4\n", true},
                         Row{2, "M3\n", false}, Row{3, "M3\n", true}, Row{3, "M5\n", true}}) {
    const Result ran = mill(head(row.spindle) + Pocket{.direction = row.direction}.call() + "M30\n", 5.0);
    EXPECT_EQ(has(ran, ir::MotionKind::arc_ccw), row.ccw) << row.direction << row.spindle;
    EXPECT_EQ(has(ran, ir::MotionKind::arc_cw), !row.ccw) << row.direction << row.spindle;
  }
  EXPECT_EQ(alarm_of(mill(head("M5\n") + Pocket{}.call() + "M30\n", 5.0)), "61102");
}

TEST(MillingCycles, AlarmsOfAPocket) {
  const auto alarm = [](const Pocket& pocket, double radius = 5.0) {
    return alarm_of(mill(head() + pocket.call() + "M30\n", radius));
  };
  EXPECT_EQ(alarm({}, 20.5), "61105");
  EXPECT_EQ(alarm({}, 20.0), "");
  EXPECT_EQ(alarm({.depth = -1.0}), "61101");
  EXPECT_EQ(alarm({.direction = 4}), "61109");
  EXPECT_EQ(alarm({.base = 4.1}), "61110");
  EXPECT_EQ(alarm({.base = 4.0}), "");
  EXPECT_EQ(alarm({.step = 10.1}), "61111");
  EXPECT_EQ(alarm({.step = 10.0}), "");
  EXPECT_EQ(alarm({.corner = 20.5}), "61113");
  EXPECT_EQ(alarm({.kind = 13}), "61002");
  EXPECT_EQ(alarm({.kind = 41}), "61002");
  EXPECT_EQ(alarm({.kind = 21}), "61108");
  EXPECT_EQ(alarm({.kind = 21, .helix = 2.0, .turn = 1.0}), "");
  EXPECT_EQ(alarm_of(mill("G17 G90 G94\nT1 M6\nD0\nS1 M3 F1\n" + Pocket{}.call() + "M30\n", 5.0)), "61000");
}

TEST(MillingCycles, WithoutTheToolsRadiusNothingIsKnown) {
  const Result ran = mill(head() + Pocket{}.call() + "G91 G0 X1\nM30\n", 5.0, false);
  EXPECT_TRUE(ran.names("POCKET3 by a tool whose radius is not known"));
  EXPECT_TRUE(ran.names("increments from a position that is not known"));
  EXPECT_TRUE(mill("G17 G90 G94\nT=\"MILL\" M6\nS1 M3 F1\n" + Pocket{}.call() + "M30\n", 5.0)
                  .names("POCKET3 by a tool whose radius is not known"));
  // The next tool is only prepared: which one is in the spindle, and whether its offsets are on, no block states.
  EXPECT_TRUE(mill("G17 G90 G94\nT1\nS1 M3 F1\n" + Pocket{}.call() + "M30\n", 5.0)
                  .names("POCKET3 by a tool whose radius is not known"));
  EXPECT_TRUE(mill(head("G41\n") + Pocket{}.call() + "M30\n", 5.0).names("POCKET3 under cutter compensation"));
}

// The modes, the feed and the frame are those from before.
TEST(MillingCycles, TheStateAfterwardsIsTheOneBefore) {
  const Result ran = mill(head() + "G91\nG1 X10\n" + Pocket{}.call() + "X10\nZ1\nM30\n", 5.0);
  EXPECT_TRUE(ran.trace.contains("linear X60.0000 Y40.0000 Z20.0000 F77.0000/min")) << ran.trace;
  EXPECT_TRUE(ran.trace.contains("linear X60.0000 Y40.0000 Z21.0000 F77.0000/min"));
  const Result inch = mill(
      head() + "G70\n" +
          Pocket{.length = 3.0, .width = 2.0, .corner = 0.5, .x = 1.0, .y = 1.0, .depth = 0.1, .infeed = 0.0}.call() +
          "M30\n",
      5.0);
  check_pocket(inch, {.length = 76.2, .width = 50.8, .corner = 12.7, .x = 25.4, .y = 25.4}, 5.0, -2.54, 0.5);
}

// Frames move, turn and mirror what is milled.
TEST(MillingCycles, FramesTakeThePocketWithThem) {
  const Pocket pocket{.length = 30.0, .width = 20.0, .corner = 6.0, .x = 10.0, .y = 5.0, .angle = 20.0, .depth = 2.0};
  const Result turned = mill(head("TRANS X100 Y50 Z-3\nAROT RPL=30\n") + pocket.call() + "M30\n", 4.0);
  RoundRectangle region = pocket.region(0.0, 4.0);
  region.x = 100.0 + 10.0 * std::cos(M_PI / 6.0) - 5.0 * std::sin(M_PI / 6.0);
  region.y = 50.0 + 10.0 * std::sin(M_PI / 6.0) + 5.0 * std::cos(M_PI / 6.0);
  region.angle_deg = 50.0;
  EXPECT_NEAR(lowest(turned), -5.0, 1e-9);
  for (const Spot& s : spots_below(turned, -3.0)) ASSERT_LE(region.distance(s), -4.0 + 1e-6);
  EXPECT_LE(uncovered_mm(region, spots_at(turned, -5.0), 4.0, 0.4, 0.0), kTolerance_mm);
  const Result mirrored = mill(head("MIRROR X0\n") + pocket.call() + "M30\n", 4.0);
  region = pocket.region(0.0, 4.0);
  region.x = -10.0;
  region.angle_deg = -20.0;
  check_pocket(mirrored, region, 4.0, -2.0, 0.4);
  EXPECT_TRUE(mill(head("SCALE X2\n") + pocket.call() + "M30\n", 4.0)
                  .names("POCKET3 under a frame that tilts or stretches it"));
}

TEST(MillingCycles, OtherPlanesAndDirectionsOfDepth) {
  const Result zx = mill("G18 G90 G94\nT1 M6\nS1000 M3\nG0 X0 Y100 Z0\n" + Pocket{}.call() + "M30\n", 5.0);
  EXPECT_TRUE(zx.trace.contains("rapid X40.0000 Y2.0000 Z50.0000")) << zx.trace;
  EXPECT_TRUE(zx.trace.contains("linear X40.0000 Y-3.5000 Z50.0000 F100.0000/min"));
  const Result upward = mill(head() + "POCKET3(-20,0,2,10,60,40,8,50,40,0,5,0,0,300,100,0,11)\nM30\n", 5.0);
  EXPECT_TRUE(upward.trace.contains("linear X50.0000 Y40.0000 Z5.0000 F100.0000/min")) << upward.trace;
  EXPECT_TRUE(upward.trace.contains("linear X50.0000 Y40.0000 Z10.0000 F100.0000/min"));
}

// The list as the operator's screen writes it: a depth by distance, widths in percent, a plane.
TEST(MillingCycles, APocketOfTheOperatorsScreen) {
  const std::string call = "POCKET3(20,0,2,6,60,40,8,50,40,0,3,0,0,300,100,0,21,50,0,0,0,3,1,0,1,2,10100,1,111)\n";
  const Result ran = mill(head() + call + "M30\n", 5.0);
  check_pocket(ran, Pocket{}.region(0.0, 5.0), 5.0, -6.0, 0.5);
  const auto with = [&](const std::string& modes) {
    return mill(head() + "POCKET3(20,0,2,6,60,40,8,50,40,0,3,0,0,300,100,0,11,50,0,0,0,0,0,0,0,0," + modes + ")\nM30\n",
                5.0);
  };
  EXPECT_EQ(with("100,1,111").result.not_interpreted.size(), 1U);
  EXPECT_TRUE(with("11100,1,111").names("POCKET3 from a corner (GMODE)"));
  EXPECT_TRUE(with("20100,1,111").names("POCKET3 for what another tool has left (GMODE)"));
  EXPECT_TRUE(with("100,2,111").names("POCKET3 in another plane (DMODE) than the one in effect"));
  EXPECT_TRUE(with("100,1,112").names("POCKET3 with a kind of depth (AMODE) that is not known"));
}

TEST(MillingCycles, AProgramOfTheShopsOwnGoesBefore) {
  ir::Control control = test::control("sinumerik-840d", ir::MachineKind::mill);
  const Result ran = run_on(control, "POCKET3(7)\nM30\n", {{"POCKET3", "PROC POCKET3(REAL A)\nR1=A\nRET\n"}});
  EXPECT_EQ(ran.value("R1"), 7.0);
}

// --- POCKET4

TEST(MillingCycles, ARoundPocket) {
  const Result ran = mill(head() + "POCKET4(30,0,2,-9,25,30,60,4,0.5,0.2,300,100,3,21,0,0,0,2,1)\nM30\n", 5.0);
  const RoundRectangle region{.length = 49.0, .width = 49.0, .corner = 24.5, .x = 30.0, .y = 60.0};
  check_pocket(ran, region, 5.0, -8.8, 0.5);
  EXPECT_EQ(alarm_of(mill(head() + "POCKET4(30,0,2,-9,4,30,60,4,0,0,300,100,3,11)\nM30\n", 5.0)), "61105");
}

// Their values stand in another order; the pockets are those of the later cycles, in straight down.
TEST(MillingCycles, OlderPocketsAreThoseOfTheLaterCycles) {
  struct Row {
    std::string older;
    std::string later;
  };
  for (const Row& row :
       {Row{"POCKET1(50,0,1,-5,,40,30,7,20,10,15,100,300,2,2,0.2,1)",
            "POCKET3(50,0,1,-5,40,30,7,20,10,15,2,0.2,0,300,100,2,11)"},
        Row{"POCKET1(50,2,1,,7,40,30,7,20,10,15,100,300,2,3,0.2,1)",
            "POCKET3(50,2,1,-5,40,30,7,20,10,15,2,0.2,0,300,100,3,11)"},
        Row{"POCKET2(50,0,1,-5,,16,20,10,100,300,2,2,0.2,1)", "POCKET4(50,0,1,-5,16,20,10,2,0.2,0,300,100,2,11)"}}) {
    const Result older = mill(head() + row.older + "\nM30\n", 5.0);
    EXPECT_FALSE(moves(older).empty()) << row.older;
    EXPECT_EQ(moves(older), moves(mill(head() + row.later + "\nM30\n", 5.0))) << row.older;
  }
  // All of it: the side at once, by its own feed.
  const Result whole = mill(head() + "POCKET1(50,0,1,-5,,40,30,7,20,10,0,100,300,2,2,0.2,0,5,250)\nM30\n", 5.0);
  EXPECT_TRUE(std::ranges::any_of(cuts(whole), [](const ir::Motion& m) { return m.feed == 250.0; }));
  for (const char* more : {"3", "0,5,250,900"}) {
    const std::string call = "POCKET1(50,0,1,-5,,40,30,7,20,10,0,100,300,2,2,0.2," + std::string(more) + ")";
    EXPECT_TRUE(moves(mill(head() + call + "\nM30\n", 5.0)).find("Z-5") == std::string::npos) << call;
  }
}

}  // namespace
}  // namespace dripfeed::compile::test
