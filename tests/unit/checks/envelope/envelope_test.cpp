// One fault a test, beside a near miss that must not be one.
#include "checks/envelope/envelope.h"

#include <vector>

#include <gtest/gtest.h>

namespace dripfeed::envelope {
namespace {

using enum ir::MotionKind;
using text::DiagnosticId;

checks::Machine lathe() {
  checks::Machine machine;
  machine.kind = ir::MachineKind::lathe;
  machine.axes.push_back({.axis = ir::Axis::x, .is_diameter = true, .min = -5, .max = 150});
  machine.axes.push_back({.axis = ir::Axis::z, .min = -20, .max = 400});
  machine.feed_limit_mm_min = 5000;
  machine.spindle_max_rpm = 3000;
  machine.tools.push_back({.number = 6, .nose_radius_mm = 0.8, .tip = 3});
  checks::WorkOffset g55{.number = 2};
  g55.zero[0] = 0;
  g55.zero[2] = 200;
  machine.work_offsets.push_back(g55);
  return machine;
}

ir::Motion move(ir::MotionKind kind, double from_x, double from_z, double x, double z) {
  ir::Motion motion;
  motion.kind = kind;
  motion.place = {0, 7, 6};
  motion.plane = ir::Plane::zx;
  motion.axes_commanded = 0b101;
  motion.start[0] = from_x;
  motion.start[2] = from_z;
  motion.end[0] = x;
  motion.end[2] = z;
  motion.feed = kind == rapid ? 0 : 100;
  return motion;
}

Report run(const std::vector<ir::Motion>& motions, std::int32_t work_offset = 2, double part_size_mm = 0) {
  Envelope check({.machine = lathe(), .work_offset = work_offset, .part_size_mm = part_size_mm});
  check.consume(motions);
  return check.finish();
}

TEST(Envelope, HalvesDiametersAndAddsTheWorkOffset) {
  const Report good = run({move(rapid, 0, 0, 300, 200)});  // 150 and 400: just there
  EXPECT_TRUE(good.findings.empty());
  EXPECT_DOUBLE_EQ(good.machine[0].high, 150);
  EXPECT_DOUBLE_EQ(good.machine[2].high, 400);
  EXPECT_DOUBLE_EQ(good.work[2].high, 200);
  const Report bad = run({move(rapid, 0, 0, 300.01, 200), move(rapid, 0, 0, 0, -220.5)});
  ASSERT_EQ(bad.findings.count(DiagnosticId::travel_exceeded), 2U);
  EXPECT_EQ(bad.findings.kept()[0].text, "X goes to 150.005 in machine coordinates, the travel is -5 to 150");
  EXPECT_EQ(bad.findings.kind(DiagnosticId::travel_exceeded)->worst.value, -20.5);
  EXPECT_EQ(bad.findings.kept()[0].place.line, 7U);
}

TEST(Envelope, SaysWhatItDoesNotKnowOfAnOffset) {
  const Report report = run({move(rapid, 0, 0, 9000, 9000)}, 1);
  EXPECT_TRUE(report.findings.empty());
  EXPECT_TRUE(report.machine[0].empty());
  bool said = false;
  for (const auto& one : report.not_checked.list()) {
    said = said || one.text == "work offset 1 is not known for X: its travel was not checked";
  }
  EXPECT_TRUE(said);
}

TEST(Envelope, FollowsTheOffsetAndMachineCoordinates) {
  ir::Motion offset;
  offset.kind = ir::MotionKind::offset;
  offset.number = 2;
  ir::Motion home = move(rapid, 0, 0, 300, 400);
  home.machine_coordinates = true;
  EXPECT_TRUE(run({offset, home}, 1).findings.empty());
  home.end[2] = 401;
  EXPECT_EQ(run({offset, home}, 1).findings.count(DiagnosticId::travel_exceeded), 1U);
}

TEST(Envelope, LooksAtTheTopOfAnArc) {
  // A half circle from x 280 to 280 (radius 140): its top is at 140 + 20.
  ir::Motion arc = move(arc_cw, 280, 0, 280, 40);
  arc.center = {0, 0, 20};
  const Report over = run({arc});
  ASSERT_EQ(over.findings.count(DiagnosticId::travel_exceeded), 1U);
  EXPECT_NEAR(over.findings.kept()[0].value, 160, 1e-9);
  arc.kind = arc_ccw;  // the other way it bends inwards
  EXPECT_TRUE(run({arc}).findings.empty());
}

TEST(Envelope, AsksForEqualRadii) {
  ir::Motion arc = move(arc_cw, 100, 0, 100, 40);
  arc.center = {0, 0, 20.005};
  EXPECT_TRUE(run({arc}).findings.empty());
  arc.center = {0, 0, 20.02};
  EXPECT_EQ(run({arc}).findings.count(DiagnosticId::arc_radius_mismatch), 1U);
}

TEST(Envelope, ChecksFeedsOfEachMode) {
  ir::Motion cut = move(linear, 100, 0, 100, -10);
  cut.feed = 5000;
  EXPECT_TRUE(run({cut}).findings.empty());
  cut.feed = 5001;
  EXPECT_EQ(run({cut}).findings.count(DiagnosticId::feed_too_high), 1U);
  cut.feed_mode = ir::FeedMode::per_rev;
  cut.spindle_rpm = 2000;
  cut.feed = 2.5;
  EXPECT_TRUE(run({cut}).findings.empty());
  cut.feed = 150;  // per minute was meant
  const Report wrong = run({cut});
  EXPECT_EQ(wrong.findings.count(DiagnosticId::feed_too_high), 1U);
  EXPECT_DOUBLE_EQ(wrong.feed_max_mm_min, 300000);
  cut.feed_mode = ir::FeedMode::inverse_time;
  cut.feed = 500;  // 10 mm in 1/500 min
  EXPECT_TRUE(run({cut}).findings.empty());
  cut.feed = 501;
  EXPECT_EQ(run({cut}).findings.count(DiagnosticId::feed_too_high), 1U);
}

TEST(Envelope, ChecksTheSpindleAndSurfaceSpeed) {
  ir::Motion cut = move(linear, 100, 0, 20, 0);
  cut.spindle = ir::SpindleState::clockwise;
  cut.spindle_rpm = 3001;
  EXPECT_EQ(run({cut}).findings.count(DiagnosticId::spindle_too_fast), 1U);
  cut.surface_speed_m_min = 180;  // 2865 rpm at diameter 20
  cut.spindle_rpm = 0;
  EXPECT_TRUE(run({cut}).findings.empty());
  cut.end[0] = 0;  // towards the centre
  EXPECT_EQ(run({cut}).findings.count(DiagnosticId::surface_speed_unlimited), 1U);
  cut.spindle_rpm = 2500;  // with a limit
  EXPECT_TRUE(run({cut}).findings.empty());
  cut.spindle_rpm = 3500;  // beyond the machine's
  EXPECT_EQ(run({cut}).findings.count(DiagnosticId::spindle_too_fast), 1U);
}

TEST(Envelope, MissesTools) {
  ir::Motion tool;
  tool.kind = ir::MotionKind::tool;
  tool.number = 6;
  EXPECT_TRUE(run({tool}).findings.empty());
  tool.number = 7;
  EXPECT_EQ(run({tool}).findings.count(DiagnosticId::tool_missing), 1U);
}

TEST(Envelope, SuspectsInchesWhereAFactorStands) {
  EXPECT_TRUE(run({move(linear, 100, 0, 100, -98)}, 2, 100).findings.empty());
  EXPECT_EQ(run({move(linear, 4, 0, 4, -3.9)}, 2, 100).findings.count(DiagnosticId::unit_suspicion), 1U);
  EXPECT_EQ(run({move(linear, 4, 0, 4, -3.9)}, 2, 0).findings.count(DiagnosticId::unit_suspicion), 0U);
}

TEST(Envelope, KeepsFewFindingsAndCountsAll) {
  const std::vector<ir::Motion> motions(1000, move(rapid, 0, 0, 400, 0));
  const Report report = run(motions);
  EXPECT_EQ(report.findings.count(DiagnosticId::travel_exceeded), 1000U);
  EXPECT_EQ(report.findings.kept().size(), checks::FindingList::kKept);
  EXPECT_EQ(report.moves, 1000U);
}

}  // namespace
}  // namespace dripfeed::envelope
