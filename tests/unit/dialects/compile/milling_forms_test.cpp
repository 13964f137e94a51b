// Slots, long holes, spigots and faces of SINUMERIK. The oracles are those of milling_cycles_test.cpp.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/unit/dialects/compile/milled_region.h"
#include "tests/unit/dialects/compile/sinumerik_run.h"

namespace dripfeed::compile::test {
namespace {

constexpr double kStep_mm = 0.1;

Result mill_form(const std::string& call, double radius_mm) {
  ir::Control control = test::control("sinumerik-840d", ir::MachineKind::mill);
  control.semantics.power_on_known = true;
  control.tool_radii = {{.tool = 1, .offset = 0, .radius_mm = radius_mm}};
  return run_on(control, "G17 G90 G94\nT1 M6\nS1000 M3 F77\nG0 X0 Y0 Z100\n" + call + "\nM30\n");
}

std::vector<Spot> cut_at(const Result& ran, double level) {
  std::vector<Spot> out;
  for (const ir::Motion& m : ran.motions) {
    if (!ir::is_move(m.kind) || m.kind == ir::MotionKind::rapid) continue;
    if (std::abs(m.start[2] - level) > 1e-6 || std::abs(m.end[2] - level) > 1e-6) continue;
    const std::vector<Spot> more = spots_of(m, kStep_mm);
    out.insert(out.end(), more.begin(), more.end());
  }
  return out;
}

double nearest_to(const RoundRectangle& form, const Result& ran, double below) {
  double nearest = 1e9;
  for (const ir::Motion& m : ran.motions) {
    if (!ir::is_move(m.kind)) continue;
    for (const Spot& s : spots_of(m, kStep_mm))
      if (s.z < below - 1e-6) nearest = std::min(nearest, form.distance(s));
  }
  return nearest;
}

// PGZ, SLOT1: each on a ray, from RAD outward.
std::vector<RoundRectangle> slots_on_rays(double length, double width, double allowance) {
  std::vector<RoundRectangle> out;
  for (const double angle : {45.0, 135.0, 225.0, 315.0}) {
    const double at = 20.0 + length / 2.0;
    out.push_back({.length = length - 2.0 * allowance,
                   .width = width - 2.0 * allowance,
                   .corner = width / 2.0 - allowance,
                   .x = 40.0 + at * std::cos(angle * M_PI / 180.0),
                   .y = 45.0 + at * std::sin(angle * M_PI / 180.0),
                   .angle_deg = angle});
  }
  return out;
}

TEST(MillingForms, SlotsOnACircle) {
  const auto check = [](const Result& ran, double allowance, double base) {
    const std::vector<RoundRectangle> slots = slots_on_rays(30.0, 15.0, allowance);
    for (const RoundRectangle& slot : slots)
      EXPECT_LE(uncovered_mm(slot, cut_at(ran, base), 5.0, 0.5, 0.0), 0.01) << slot.angle_deg;
    for (const ir::Motion& m : ran.motions) {
      if (!ir::is_move(m.kind)) continue;
      for (const Spot& s : spots_of(m, kStep_mm)) {
        if (s.z > -1e-6) continue;
        const bool is_inside =
            std::ranges::any_of(slots, [&](const RoundRectangle& slot) { return slot.distance(s) <= -5.0 + 1e-6; });
        ASSERT_TRUE(is_inside) << s.x << " " << s.y << " " << s.z;
      }
    }
  };
  check(mill_form("SLOT1(5,0,1,-23,,4,30,15,40,45,20,45,90,100,320,6,2,0.2,1)", 5.0), 0.2, -23.0);
  // Roughed and finished in one: at once where MIDF is 0.
  const Result whole = mill_form("SLOT1(5,0,1,,23,4,30,15,40,45,20,45,90,100,320,6,2,0.2,0,0,200)", 5.0);
  check(whole, 0.0, -23.0);
  EXPECT_TRUE(whole.trace.contains("F200.0000/min"));
  check(mill_form("SLOT1(5,0,1,,23,4,30,15,40,45,20,45,0,100,320,6,3,0,31,0,0,0,0,5)", 5.0), 0.0, -23.0);
  check(mill_form("SLOT1(5,0,1,,23,4,30,15,40,45,20,45,0,100,320,6,0,0,21,0,0,0,0.3,0,2)", 5.0), 0.0, -22.7);
  EXPECT_EQ(alarm_of(mill_form("SLOT1(5,0,1,,23,4,30,15,40,45,20,45,0,100,320,6,2,0,1)", 8.0)), "61105");
  EXPECT_EQ(alarm_of(mill_form("SLOT1(5,0,1,,23,4,30,15,40,45,20,45,0,100,320,6,2,0,3)", 5.0)), "61002");
  EXPECT_TRUE(mill_form("SLOT1(5,0,1,,23,4,30,15,40,45,20,45,0,100,320,6,2,0.2,0,0,200,900)", 5.0)
                  .names("SLOT1 with a speed of its own for finishing (SSF)"));
  // Where the tool stands in the plane afterwards is not documented.
  EXPECT_TRUE(mill_form("SLOT1(5,0,1,,23,4,30,15,40,45,20,45,0,100,320,6,2,0,1)\nG91 G0 X1", 5.0)
                  .names("increments from a position that is not known"));
}

// PGZ, SLOT2: down by FFD at one end; the path of the tool's centre lies within half of the width, less its radius, of
// an arc of AFSL degrees around CPA, CPO. What the manuals leave open is named.
TEST(MillingForms, SlotsOnAnArc) {
  const std::string call = "SLOT2(5,0,1,,23,3,70,15,60,60,42,0,120,100,320,6,2,0.2,";
  const Result ran = mill_form(call + "0,0,200)", 5.0);
  EXPECT_TRUE(ran.names("the order in which SLOT2 removes the material"));
  EXPECT_TRUE(ran.trace.contains("F200.0000/min"));
  double farthest = 0.0;
  std::size_t plunges = 0;
  for (const ir::Motion& m : ran.motions) {
    if (!ir::is_move(m.kind)) continue;
    plunges += m.kind == ir::MotionKind::linear && m.start[2] > m.end[2] && m.feed == 100.0 ? 1U : 0U;
    for (const Spot& s : spots_of(m, kStep_mm)) {
      if (s.z > -1e-6) continue;
      double turned = std::remainder(std::atan2(s.y - 60.0, s.x - 60.0) * 180.0 / M_PI - 35.0, 120.0) + 35.0;
      const double end = std::clamp(turned, 0.0, 70.0);
      turned *= M_PI / 180.0;
      const double out = std::hypot(s.x - 60.0, s.y - 60.0);
      farthest = std::max(farthest, std::hypot(out * std::cos(turned) - 42.0 * std::cos(end * M_PI / 180.0),
                                               out * std::sin(turned) - 42.0 * std::sin(end * M_PI / 180.0)));
    }
  }
  EXPECT_NEAR(farthest, 2.5, 1e-6);
  EXPECT_EQ(plunges, 15U);  // three times four of 5.75 mm, and one along the side
  // As the operator's screen writes it.
  EXPECT_TRUE(
      mill_form("SLOT2(20,10,5,,5,1,60,20,55,-43,30,30,90,400,500,10,0,0.1,1001,0,0,0,,0,1,2,100,1001,101)", 6.0)
          .names("the order in which SLOT2 removes the material"));
  EXPECT_EQ(alarm_of(mill_form(call + "0)", 8.0)), "61105");
  EXPECT_EQ(alarm_of(mill_form(call + "3)", 5.0)), "61002");
  const auto left = [&](const std::string& text, const std::string& why) {
    EXPECT_TRUE(mill_form(text, 5.0).names("SLOT2 " + why)) << text;
  };
  EXPECT_TRUE(mill_form(call + "0)", 3.0).names("SLOT2 by a tool that is narrower than half of the slot"));
  left(call + "11)", "with a path to the next slot (VARI) that is not straight");
  left(call + "101)", "with a kind (VARI) that is not known");
  left(call + "0,0,200,900)", "with a speed of its own for finishing (SSF)");
  left("SLOT2(5,0,1,,23,3,119,15,60,60,42,0,120,100,320,6,2,0,1)", "with slots that touch each other");
  left("SLOT2(5,0,1,,23,3,70,15,60,60,42,0,150,100,320,6,2,0,1)", "with slots that touch each other");
  left("SLOT2(5,0,1,,23,1,70,15,60,60,7,0,120,100,320,6,2,0,1)", "with slots that are wider than their circle");
  left("SLOT2(5,0,1,,23,2,360,15,60,60,42,0,120,100,320,6,2,0,1)", "with an angle (AFSL) that no slot has");
  left("SLOT2(5,0,1,,23,1,-70,15,60,60,42,0,120,100,320,6,2,0,1)", "with an angle (AFSL) that no slot has");
  left("SLOT2(5,0,1,,23,1.5,70,15,60,60,42,0,120,100,320,6,2,0,1)", "with a number of slots (NUM) that it has not");
}

// PGZ, LONGHOLE: as wide as the tool; in at both ends by turns, along by FFP1.
TEST(MillingForms, LongHoles) {
  const Result ran = mill_form("LONGHOLE(5,0,1,,23,4,30,40,45,20,45,90,100,320,6)", 5.0);
  for (const RoundRectangle& hole : slots_on_rays(30.0, 10.0, 0.0)) {
    EXPECT_LE(uncovered_mm(hole, cut_at(ran, -23.0), 5.0, 0.5, 0.1), 0.02) << hole.angle_deg;
    EXPECT_NEAR(nearest_to(hole, ran, 0.0), -5.0, 1e-6);
  }
  const auto plunges = std::ranges::count_if(ran.motions, [](const ir::Motion& m) {
    return m.kind == ir::MotionKind::linear && m.start[2] != m.end[2] && m.feed == 100.0;
  });
  EXPECT_EQ(plunges, 16);  // four of 5.75 mm in each
  EXPECT_EQ(alarm_of(mill_form("LONGHOLE(5,0,1,,23,4,9,40,45,20,45,90,100,320,6)", 5.0)), "61105");
}

// PGZ, CYCLE76: once around at each depth, on and off by a half circle from beyond the blank.
TEST(MillingForms, ARectangularSpigot) {
  const std::string call = "CYCLE76(10,0,2,-17.5,,60,40,15,80,60,10,11,";
  const RoundRectangle form{.length = 60.0, .width = 40.0, .corner = 15.0, .x = 80.0, .y = 60.0, .angle_deg = 10.0};
  const Result rough = mill_form(call + "0.5,0.3,900,800,0,1,80,50)", 10.0);
  EXPECT_NEAR(nearest_to(form, rough, 0.0), 10.5, 1e-6);
  const auto around = cut_at(rough, -17.2);
  double farthest = 0.0;  // of the wall from the path
  for (int degree = 0; degree < 360; ++degree) {
    const double a = degree * M_PI / 180.0;
    // The path at each angle: as far from the wall as the radius and the allowance.
    double nearest = 1e9;
    for (const Spot& s : around) {
      const Spot local = form.turned(s);
      const double off = std::remainder(std::atan2(local.y, local.x) - a, 2.0 * M_PI);
      if (std::abs(off) < 0.02) nearest = std::min(nearest, form.distance(s));
    }
    farthest = std::max(farthest, nearest);
  }
  EXPECT_NEAR(farthest, 10.5, 1e-6);
  // The tool comes down beyond the blank, which is 80 long.
  for (const ir::Motion& m : rough.motions)
    if (m.kind == ir::MotionKind::linear && m.start[2] != m.end[2]) {
      EXPECT_GE(form.turned({m.end[0], m.end[1], 0.0}).x, 40.0 + 10.0 + 2.0 - 1e-6);
    }
  EXPECT_NEAR(nearest_to(form, mill_form(call + "0.5,0.3,900,800,0,2,80,50)", 10.0), 0.0), 10.0, 1e-6);
  // Climb milling goes clockwise around it; on and off it turns in the other sense: four corners and two half circles a
  // depth.
  const auto has = [](const Result& ran, int direction) {
    return std::ranges::count(ran.motions, direction > 0 ? ir::MotionKind::arc_ccw : ir::MotionKind::arc_cw,
                              &ir::Motion::kind);
  };
  EXPECT_EQ(has(rough, -1), 8);
  EXPECT_EQ(has(rough, 1), 4);
  EXPECT_EQ(alarm_of(mill_form("CYCLE76(10,0,2,-5,,60,40,21,80,60,0,0,0,0,900,800,0,1,80,50)", 10.0)), "61113");
}

// PGZ, CYCLE77: PRAD is the diameter.
TEST(MillingForms, ACircularSpigot) {
  const Result ran = mill_form("CYCLE77(10,0,3,-20,,50,60,70,10,0.5,0,900,800,1,1,55)", 8.0);
  const RoundRectangle form{.length = 50.0, .width = 50.0, .corner = 25.0, .x = 60.0, .y = 70.0};
  EXPECT_NEAR(nearest_to(form, ran, 0.0), 8.5, 1e-6);
  for (const double level : {-10.0, -20.0}) {
    const RoundRectangle ring{.length = 67.0, .width = 67.0, .corner = 33.5, .x = 60.0, .y = 70.0};
    const std::vector<Spot> path = cut_at(ran, level);
    for (int degree = 0; degree < 360; ++degree) {
      const Spot on = {60.0 + 33.5 * std::cos(degree * M_PI / 180.0), 70.0 + 33.5 * std::sin(degree * M_PI / 180.0)};
      EXPECT_TRUE(std::ranges::any_of(path, [&](const Spot& s) { return std::hypot(s.x - on.x, s.y - on.y) < 0.4; }));
    }
    EXPECT_NEAR(ring.distance({93.5, 70.0}), 0.0, 1e-9);
  }
}

// CYCLE61 as the operator's screen writes it: each depth is faced, the tool goes down beyond the edge.
TEST(MillingForms, AFace) {
  const RoundRectangle form{.length = 100.0, .width = 60.0, .x = 50.0, .y = 30.0};
  for (const std::string kind : {"11", "21", "31", "41"}) {
    const Result ran = mill_form("CYCLE61(50,3,5,0,0,0,100,60,2,80,0.2,900," + kind + ",0,1,11010)", 10.0);
    EXPECT_LE(uncovered_mm(form, cut_at(ran, 0.2), 10.0, 1.0, 0.0), 0.01) << kind;
    EXPECT_LE(uncovered_mm(form, cut_at(ran, 1.6), 10.0, 1.0, 0.0), 0.01) << kind;
    EXPECT_TRUE(cut_at(ran, 0.0).empty());
    for (const ir::Motion& m : ran.motions) {
      const bool goes_down = ir::is_move(m.kind) && m.end[2] < m.start[2] - 1e-9 && m.end[2] < 3.0;
      const double beyond = goes_down ? form.distance({m.end[0], m.end[1], 0.0}) : 15.0;
      EXPECT_GE(beyond, 15.0 - 1e-6) << kind;
      EXPECT_TRUE(goes_down || m.kind != ir::MotionKind::rapid || m.end[2] >= 3.0) << kind;
    }
  }
  const Result finish = mill_form("CYCLE61(50,3,5,0,0,0,100,60,2,80,0.2,900,32,0,1,11010)", 10.0);
  EXPECT_LE(uncovered_mm(form, cut_at(finish, 0.0), 10.0, 1.0, 0.0), 0.01);
  EXPECT_EQ(alarm_of(mill_form("CYCLE61(50,3,5,0,0,0,0,60,2,80,0.2,900,32,0,1,10)", 10.0)), "61118");
  EXPECT_EQ(alarm_of(mill_form("CYCLE61(50,3,5,0,0,0,100,60,2,21,0,900,31,0,1,0)", 10.0)), "61111");
  EXPECT_TRUE(mill_form("CYCLE61(50,3,5,0,10,0,100,60,2,80,0,900,31,0,1,11010)", 10.0)
                  .names("CYCLE61 with a second corner (AMODE) that is not certain"));
  EXPECT_TRUE(mill_form("CYCLE61(50,3,5,0,0,0,100,60,2,80,0,900,31,1,1,11010)", 10.0)
                  .names("CYCLE61 with sides that it must not cross (LIM)"));
}

// CYCLE71, PGZ: a corner, lengths with signs, turned around the corner. FDP is where a cut ends beyond the face, FDP1
// how far the last one reaches beyond it.
TEST(MillingForms, AFaceFromACorner) {
  const double turned = 10.0 * M_PI / 180.0;
  const RoundRectangle form{.length = 60.0,
                            .width = 40.0,
                            .x = 100.0 - 30.0 * std::cos(turned) - 20.0 * std::sin(turned),
                            .y = 90.0 - 30.0 * std::sin(turned) + 20.0 * std::cos(turned),
                            .angle_deg = 10.0};
  for (const std::string kind : {"11", "21", "31", "41"}) {
    const Result ran = mill_form("CYCLE71(50,3,5,0,100,90,-60,40,10,2,12,7,0.2,900," + kind + ",4)", 10.0);
    const bool is_along = kind == "11" || kind == "31";
    double farthest_along = 0.0;
    double highest_across = -1e9;
    double lowest_across = 1e9;
    for (const double level : {0.2, 1.6}) {
      EXPECT_LE(uncovered_mm(form, cut_at(ran, level), 10.0, 1.0, 0.0), 0.01) << kind;
      for (const Spot& s : cut_at(ran, level)) {
        const Spot local = form.turned(s);
        farthest_along = std::max(farthest_along, is_along ? local.x : local.y);
        const double across = is_along ? local.y : local.x;
        highest_across = std::max(highest_across, across);
        lowest_across = std::min(lowest_across, across);
      }
    }
    EXPECT_NEAR(farthest_along, (is_along ? 30.0 : 20.0) + 10.0 + 7.0, 1e-6) << kind;
    EXPECT_NEAR(highest_across, (is_along ? 20.0 : 30.0) + 4.0 - 10.0, 1e-6) << kind;
    EXPECT_NEAR(lowest_across, (is_along ? -20.0 : -30.0) + 12.0 - 10.0, 1e-6) << kind;
    EXPECT_TRUE(cut_at(ran, 0.0).empty());
    for (const ir::Motion& m : ran.motions) {
      const bool goes_down = ir::is_move(m.kind) && m.end[2] < m.start[2] - 1e-9 && m.end[2] < 3.0;
      if (!goes_down) continue;
      EXPECT_GE(form.distance({m.end[0], m.end[1], 0.0}), 15.0 - 1e-6) << kind;
    }
  }
  const Result finish = mill_form("CYCLE71(50,3,5,0,100,90,-60,40,10,2,12,7,0.2,900,32)", 10.0);
  EXPECT_LE(uncovered_mm(form, cut_at(finish, 0.0), 10.0, 1.0, 0.0), 0.01);
  EXPECT_EQ(alarm_of(mill_form("CYCLE71(50,3,5,0,0,0,60,0,0,2,12,7,0,900,31,4)", 10.0)), "61118");
  EXPECT_EQ(alarm_of(mill_form("CYCLE71(50,3,5,0,0,0,60,40,0,2,21,7,0,900,31,4)", 10.0)), "61111");
  EXPECT_EQ(alarm_of(mill_form("CYCLE71(50,3,5,0,0,0,60,40,0,2,12,7,0,900,51,4)", 10.0)), "61002");
  EXPECT_EQ(alarm_of(mill_form("CYCLE71(50,3,5,60,0,0,60,40,0,2,12,7,0,900,31,4)", 10.0)), "61101");
  EXPECT_TRUE(mill_form("CYCLE71(50,3,5,0,0,0,60,40,0,2,12,7,0,900,131,4)", 10.0)
                  .names("CYCLE71 with a kind (VARI) that is not known"));
}

}  // namespace
}  // namespace dripfeed::compile::test
