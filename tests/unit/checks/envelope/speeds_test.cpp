// One fault of speed a test, and a near miss that must not be one.
#include "checks/envelope/speeds.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/checks/envelope/machines.h"

namespace dripfeed::envelope {
namespace {

using enum ir::MotionKind;
using text::DiagnosticId;

TEST(Speeds, ChecksFeedsOfEachMode) {
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

// 1 mm with 0.5 more in each turn is 3 after 8 mm: that fast the thread ends.
TEST(Speeds, AThreadIsFastestWhereItsLeadIsLongest) {
  ir::Motion cut = move(thread, 100, 0, 100, -8);
  cut.feed_mode = ir::FeedMode::per_rev;
  cut.spindle_rpm = 1000;
  cut.feed = 1;
  cut.center[0] = 0.5;
  EXPECT_DOUBLE_EQ(run({cut}).feed_max_mm_min, 3000);
  cut.center[0] = -0.05;
  EXPECT_DOUBLE_EQ(run({cut}).feed_max_mm_min, 1000);
}

TEST(Speeds, ChecksTheSpindleAndSurfaceSpeed) {
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

TEST(Speeds, TheCentreHasNoEndOfSpeed) {
  ir::Motion cut = move(linear, 40, 0, -1.6, 0);
  cut.spindle = ir::SpindleState::clockwise;
  cut.surface_speed_m_min = 200;
  const Report report = run({cut});
  ASSERT_EQ(report.findings.count(DiagnosticId::surface_speed_unlimited), 1U);
  EXPECT_NEAR(report.findings.kept()[0].value, 200e3 / (3.14159265358979 * 0.01), 1) << "at a hundredth";
  cut.end[0] = 21.3;  // 2989 rpm
  EXPECT_TRUE(run({cut}).findings.empty());
  cut.end[0] = 21.2;  // 3003 rpm
  EXPECT_EQ(run({cut}).findings.count(DiagnosticId::surface_speed_unlimited), 1U);
  cut.kind = rapid;  // moves nothing off
  EXPECT_TRUE(run({cut}).findings.empty());
}

TEST(Speeds, AFeedOfTurnsIsLimitedByWhatTheSpindleCan) {
  ir::Motion cut = move(linear, 40, 0, 0.5, 0);
  cut.spindle = ir::SpindleState::clockwise;
  cut.surface_speed_m_min = 200;
  cut.spindle_rpm = 2500;  // its limit
  cut.feed_mode = ir::FeedMode::per_rev;
  cut.feed = 2.0;
  EXPECT_TRUE(run({cut}).findings.empty()) << "5000 mm/min at the limit of 2500 rpm";
  cut.feed = 2.001;
  EXPECT_EQ(run({cut}).findings.count(DiagnosticId::feed_too_high), 1U);
}

TEST(Speeds, ASlowSpindle) {
  ir::Motion on = event(spindle);
  on.spindle = ir::SpindleState::clockwise;
  on.spindle_rpm = 29;
  const Report slow = run({on});
  ASSERT_EQ(slow.findings.count(DiagnosticId::spindle_too_slow), 1U);
  EXPECT_EQ(slow.findings.kept()[0].text, "the spindle speed is 29 rpm, the machine's lowest is 30");
  on.spindle_rpm = 30;
  EXPECT_TRUE(run({on}).findings.empty());
  on.spindle_rpm = 29;
  on.spindle = ir::SpindleState::stopped;
  EXPECT_TRUE(run({on}).findings.empty());
  on.spindle = ir::SpindleState::clockwise;
  on.surface_speed_m_min = 100;
  EXPECT_TRUE(run({on}).findings.empty()) << "29 is a limit here";
}

TEST(Speeds, EachAxisHasItsShareOfTheFeed) {
  const Settings settings{.machine = mill()};  // X 3000, the machine 5000
  ir::Motion cut = move(linear, 0, 0, 30, -40);
  cut.feed = 5000;
  EXPECT_TRUE(run({cut}, settings).findings.empty()) << "3000 of it along X";
  cut = move(linear, 0, 0, 40, -30);
  cut.feed = 5000;
  const Report report = run({cut}, settings);
  ASSERT_EQ(report.findings.count(DiagnosticId::axis_feed_too_high), 1U);
  EXPECT_NEAR(report.findings.kept()[0].value, 4000, 1e-9);
  cut.axes_unknown = 1;
  EXPECT_TRUE(run({cut}, settings).findings.empty()) << "where X starts is not known";
  cut = move(linear, 0, 0, 0, 0);
  cut.feed = 5000;
  EXPECT_TRUE(run({cut}, settings).findings.empty()) << "no travel, no share";
}

}  // namespace
}  // namespace dripfeed::envelope
