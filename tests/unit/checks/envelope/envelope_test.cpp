// One fault a test, and a near miss that must not be one.
#include "checks/envelope/envelope.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/checks/envelope/machines.h"

namespace dripfeed::envelope {
namespace {

using enum ir::MotionKind;
using text::DiagnosticId;

TEST(Envelope, HalvesDiametersAndAddsTheWorkOffset) {
  const Report good = run({move(rapid, 0, 0, 300, 200)});  // 150 and 400: just there
  EXPECT_TRUE(good.findings.empty());
  EXPECT_DOUBLE_EQ(good.machine[0].high, 150);
  EXPECT_DOUBLE_EQ(good.machine[2].high, 400);
  EXPECT_DOUBLE_EQ(good.work[2].high, 200);
  const Report bad = run({move(rapid, 0, 0, 300.01, 200), move(rapid, 0, 0, 0, -220.5)});
  ASSERT_EQ(bad.findings.count(DiagnosticId::travel_exceeded), 2U);
  EXPECT_EQ(bad.findings.kept()[0].text, "X moves to 150.005 in machine coordinates, the travel is -5 to 150");
  EXPECT_EQ(bad.findings.kind(DiagnosticId::travel_exceeded)->worst.value, -20.5);
  EXPECT_EQ(bad.findings.kept()[0].place.line, 7U);
}

TEST(Envelope, SaysWhatItDoesNotKnowOfAnOffset) {
  const Report report = run({move(rapid, 0, 0, 9000, 9000)}, 1);
  EXPECT_TRUE(report.findings.empty());
  EXPECT_TRUE(report.machine[0].empty());
  EXPECT_TRUE(reports(report, "work offset 1 is not known for X: its travel was not checked"));
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
  arc.kind = arc_ccw;  // in the other direction it bends inwards
  EXPECT_TRUE(run({arc}).findings.empty());
}

TEST(Envelope, AHelixReachesItsSidesAndItsEnds) {
  ir::Motion helix = move(arc_ccw, 10, 0, -10, -60);
  helix.plane = ir::Plane::xy;
  helix.center = {-10, 0, 0};
  const Settings settings{.machine = mill()};
  const Report good = run({helix}, settings);
  EXPECT_TRUE(good.findings.has(text::Severity::error)) << "Z ends at -510";
  EXPECT_EQ(good.findings.count(DiagnosticId::travel_exceeded), 1U);
  EXPECT_DOUBLE_EQ(good.machine[1].high, 210) << "the side of the half circle";
  EXPECT_DOUBLE_EQ(good.machine[2].low, -510);
  helix.end[2] = -50;
  EXPECT_TRUE(run({helix}, settings).findings.empty());
  helix.start[0] = 310;  // radius 310: from y 0 up to 310, which is 510 in machine coordinates
  helix.end[0] = -310;
  helix.center = {-310, 0, 0};
  const Report wide = run({helix}, settings);
  EXPECT_EQ(wide.findings.count(DiagnosticId::travel_exceeded), 2U) << "x ends at -110, y reaches 510 in between";
  EXPECT_DOUBLE_EQ(wide.machine[1].high, 510);
  helix.kind = arc_cw;
  EXPECT_DOUBLE_EQ(run({helix}, settings).machine[1].low, -110);
}

TEST(Envelope, AFullCircleReachesAllItsSides) {
  ir::Motion circle = move(arc_cw, 0, 0, 0, 0);
  circle.plane = ir::Plane::xy;
  circle.center = {50, 0, 0};
  const Report report = run({circle}, Settings{.machine = mill()});
  EXPECT_DOUBLE_EQ(report.machine[0].low, 200);
  EXPECT_DOUBLE_EQ(report.machine[0].high, 300);
  EXPECT_DOUBLE_EQ(report.machine[1].low, 150);
  EXPECT_DOUBLE_EQ(report.machine[1].high, 250);
  circle.center = {0, 0, 0};  // no circle at all
  EXPECT_EQ(run({circle}, Settings{.machine = mill()}).moves, 1U);
}

// Axes that run one by one bend off the line, and stay between the ends along each axis.
TEST(Envelope, ABentRapidStaysInTheBoxOfItsEnds) {
  const Settings settings{.machine = mill()};
  EXPECT_TRUE(run({move(rapid, 0, 0, 600, 450)}, settings).findings.empty());
  EXPECT_EQ(run({move(rapid, 0, 0, 600.001, 450)}, settings).findings.count(DiagnosticId::travel_exceeded), 1U);
}

TEST(Envelope, SaysWhatTheProfileHasNoAxisFor) {
  ir::Motion turn = move(rapid, 0, 0, 0, 0);
  turn.axes_commanded |= 1U << 3U;
  turn.end[3] = 90;
  const Report report = run({turn});
  EXPECT_TRUE(reports(report, "the machine's profile has no axis A: its moves were not checked"));
  EXPECT_FALSE(
      reports(run({move(rapid, 0, 0, 0, 0)}), "the machine's profile has no axis A: its moves were not checked"));
}

TEST(Envelope, SaysTheTravelThatIsNotKnownOfWhatMoves) {
  Settings settings{.machine = mill()};
  settings.machine.axes.push_back({.axis = ir::Axis::c});
  constexpr std::string_view kReported = "the travel of C is not known";
  const ir::Motion straight = move(rapid, 0, 0, 10, 0);
  EXPECT_FALSE(reports(run({}, settings), kReported));
  EXPECT_FALSE(reports(run({straight}, settings), kReported));
  ir::Motion turn = move(rapid, 10, 0, 10, 0);
  turn.axes_commanded |= 1U << 5U;
  turn.end[5] = 90;
  const Report report = run({straight, turn, turn}, settings);
  EXPECT_TRUE(reports(report, kReported));
  EXPECT_EQ(std::ranges::count(report.not_checked.list(), kReported, &checks::NotChecked::text), 1);
  EXPECT_TRUE(report.findings.empty());
}

TEST(Envelope, AsksForEqualRadii) {
  ir::Motion arc = move(arc_cw, 100, 0, 100, 40);
  arc.center = {0, 0, 20.005};
  EXPECT_TRUE(run({arc}).findings.empty());
  arc.center = {0, 0, 20.02};
  EXPECT_EQ(run({arc}).findings.count(DiagnosticId::arc_radius_mismatch), 1U);
}

TEST(Envelope, MissesTools) {
  EXPECT_TRUE(run({event(tool, 6)}).findings.empty());
  EXPECT_EQ(run({event(tool, 8)}).findings.count(DiagnosticId::tool_missing), 1U);
  ir::Motion named = event(tool);
  named.text = 0;
  EXPECT_TRUE(run({named}).findings.empty()) << "one by a name that is not known is reported by the run";
}

TEST(Envelope, ACutNeedsATool) {
  const ir::Motion cut = move(linear, 100, 0, 100, -10);
  const auto notes = [](const std::vector<ir::Motion>& motions) {
    Envelope check({.machine = lathe(), .work_offset = 2});
    check.consume(motions);
    return check.finish().findings.count(DiagnosticId::tool_not_called);
  };
  EXPECT_EQ(notes({cut, cut}), 1U) << "said once";
  EXPECT_EQ(notes({event(tool, 0), cut}), 1U) << "T0 takes the tool away";
  EXPECT_EQ(notes({event(tool, 6), cut}), 0U);
  EXPECT_EQ(notes({move(rapid, 100, 0, 100, -10)}), 0U);
  ir::Motion named = event(tool);
  named.text = 0;
  EXPECT_EQ(notes({named, cut}), 0U);
}

TEST(Envelope, ACutNeedsASpindleThatTurns) {
  const auto standing = [](const std::vector<ir::Motion>& motions) {
    return run(motions).findings.count(DiagnosticId::spindle_not_turning);
  };
  ir::Motion on = event(spindle);
  on.spindle = ir::SpindleState::clockwise;
  on.spindle_rpm = 500;
  ir::Motion turning = move(linear, 100, 0, 100, -10);
  turning.spindle = ir::SpindleState::clockwise;
  const ir::Motion still = move(linear, 100, -10, 100, -20);
  EXPECT_EQ(standing({on, turning}), 0U);
  EXPECT_EQ(standing({on, turning, event(spindle), still, still}), 1U) << "said once until it turns again";
  EXPECT_EQ(standing({on, turning, event(spindle), still, on, turning, event(spindle), still}), 2U);
  EXPECT_EQ(standing({on, turning, event(spindle), move(rapid, 100, -10, 120, 0)}), 0U);
  EXPECT_EQ(standing({on, turning, event(spindle), move(thread, 100, -10, 100, -20)}), 0U) << "a tap brings its turns";
  const Report never = run({still});
  EXPECT_EQ(never.findings.count(DiagnosticId::spindle_not_turning), 0U);
  EXPECT_TRUE(reports(never, "no spindle is started before the first cut: whether it turns is not known"));
}

TEST(Envelope, MovesThatAreNoNumbersAreFindings) {
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto bad = [](const ir::Motion& motion) {
    return run({motion}).findings.count(DiagnosticId::value_not_finite);
  };
  ir::Motion cut = move(linear, 100, 0, 100, -10);
  EXPECT_EQ(bad(cut), 0U);
  cut.end[2] = nan;
  EXPECT_EQ(bad(cut), 1U);
  cut = move(linear, 100, inf, 100, -10);
  EXPECT_EQ(bad(cut), 1U);
  cut = move(linear, 100, 0, 100, -10);
  cut.feed = inf;
  EXPECT_EQ(bad(cut), 1U);
  cut = move(arc_cw, 100, 0, 100, -10);
  cut.center[0] = nan;
  EXPECT_EQ(bad(cut), 1U);
  cut = move(linear, 100, 0, 1e308, 1e308);  // a number, if a large one
  EXPECT_EQ(bad(cut), 0U);
  EXPECT_GT(run({cut}).findings.count(DiagnosticId::travel_exceeded), 0U);
}

TEST(Envelope, SuspectsInchesWhereAFactorStands) {
  EXPECT_TRUE(run({move(linear, 100, 0, 100, -98)}, 2, 100).findings.empty());
  EXPECT_EQ(run({move(linear, 4, 0, 4, -3.9)}, 2, 100).findings.count(DiagnosticId::unit_suspicion), 1U);
  EXPECT_EQ(run({move(linear, 4, 0, 4, -3.9)}, 2, 0).findings.count(DiagnosticId::unit_suspicion), 0U);
}

// Millimetres that are read as inches are too long for any place on the table; what is too long by little is not.
TEST(Envelope, SuspectsAPathThatNoOffsetCanMakeFit) {
  const Settings settings{.machine = mill()};
  const auto suspects = [&](double length) {
    return run({move(linear, 0, 0, length, -1)}, settings).findings.count(DiagnosticId::unit_suspicion);
  };
  EXPECT_EQ(suspects(100 * 25.4), 1U);
  EXPECT_EQ(suspects(1000), 0U) << "beyond the travel, and not by inches";
  EXPECT_EQ(suspects(800 * 25.4 + 1), 0U) << "in inches it would not fit either";
  EXPECT_EQ(run({move(linear, 0, 0, 100 * 25.4, -1)}).findings.count(DiagnosticId::unit_suspicion), 1U);
}

TEST(Envelope, SuspectsInchesAtTheFarthestCut) {
  ir::Motion far = move(linear, 4, 0, 4, -2540);
  far.place.line = 12;
  const Report report = run({move(linear, 4, 0, 4, -3), far, move(linear, 4, -2540, 4, -1)}, 2, 100);
  ASSERT_EQ(report.findings.count(DiagnosticId::unit_suspicion) > 0, true);
  EXPECT_EQ(report.findings.kind(DiagnosticId::unit_suspicion)->worst.place.line, 12U);
}

TEST(Envelope, KeepsFewFindingsAndCountsAll) {
  std::vector<ir::Motion> motions;
  for (int n = 0; n < 1000; ++n) motions.push_back(move(rapid, 0, 0, 400 + n, 0));
  const Report report = run(motions);
  EXPECT_EQ(report.findings.count(DiagnosticId::travel_exceeded), 1000U);
  EXPECT_EQ(report.findings.kept().size(), checks::FindingList::kKept);
  EXPECT_EQ(report.moves, 1000U);
}

TEST(Envelope, KeepsEqualFindingsOnce) {
  const Report report = run(std::vector<ir::Motion>(1000, move(rapid, 0, 0, 400, 0)));
  EXPECT_EQ(report.findings.count(DiagnosticId::travel_exceeded), 1000U);
  EXPECT_EQ(report.findings.kept().size(), 1U);
}

}  // namespace
}  // namespace dripfeed::envelope
