// Where the slide is: work offset and tool length, and what is reported where one of them is not known.
#include "checks/envelope/travel.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/checks/envelope/machines.h"

namespace dripfeed::envelope {
namespace {

using enum ir::MotionKind;
using text::DiagnosticId;

ir::Motion with_length(double z, ir::LengthOffset offset, int number) {
  ir::Motion motion = move(rapid, 0, 400, 0, z);
  motion.plane = ir::Plane::xy;
  motion.length_offset = offset;
  motion.length_offset_number = static_cast<std::uint16_t>(number);
  return motion;
}
constexpr auto kPlus = ir::LengthOffset::plus;
constexpr auto kMinus = ir::LengthOffset::minus;

Report on_mill(const std::vector<ir::Motion>& motions) { return run(motions, Settings{.machine = mill()}); }

// The work zero lies at -450: without a tool the spindle reaches from -50 to 450 above it.
TEST(Travel, TheLengthLiftsTheSpindle) {
  EXPECT_EQ(on_mill({with_length(-60, ir::LengthOffset::off, 0)}).findings.count(DiagnosticId::travel_exceeded), 1U);
  const Report lifted = on_mill({with_length(-60, kPlus, 1)});
  EXPECT_TRUE(lifted.findings.empty()) << "offset 1 is 100 long: -410";
  EXPECT_DOUBLE_EQ(lifted.machine[2].low, -410);
  EXPECT_TRUE(on_mill({with_length(350, kPlus, 1)}).findings.empty()) << "just at the top";
  const Report high = on_mill({with_length(350.001, kPlus, 1)});
  ASSERT_EQ(high.findings.count(DiagnosticId::travel_exceeded), 1U);
  EXPECT_NEAR(high.findings.kept()[0].value, 0.001, 1e-9);
  EXPECT_EQ(high.findings.kept()[0].place.line, 7U);
  EXPECT_TRUE(on_mill({with_length(390, kPlus, 2)}).findings.empty()) << "offset 2 is 60 long";
  EXPECT_EQ(on_mill({with_length(390, kPlus, 11)}).findings.count(DiagnosticId::travel_exceeded), 1U);
  EXPECT_TRUE(on_mill({with_length(390, kPlus, 0)}).findings.empty()) << "H0 is none";
}

TEST(Travel, G44TakesTheLengthAway) {
  EXPECT_TRUE(on_mill({with_length(50, kMinus, 1)}).findings.empty());
  EXPECT_EQ(on_mill({with_length(49.9, kMinus, 1)}).findings.count(DiagnosticId::travel_exceeded), 1U);
}

TEST(Travel, MachineCoordinatesAreTheSpindles) {
  ir::Motion home = with_length(0, kPlus, 1);
  home.machine_coordinates = true;
  EXPECT_TRUE(on_mill({home}).findings.empty());
  Settings edges{.machine = mill(), .d_selects_edge = true};
  edges.machine.tools[0].offset = 1;
  EXPECT_EQ(run({home}, edges).findings.count(DiagnosticId::travel_exceeded), 1U) << "SUPA keeps D";
  home.length_offset = ir::LengthOffset::off;
  EXPECT_TRUE(run({home}, edges).findings.empty());
}

TEST(Travel, ALengthThatIsNotKnownIsReported) {
  const Report low = on_mill({with_length(-60, kPlus, 4)});
  EXPECT_EQ(low.findings.count(DiagnosticId::travel_exceeded), 0U) << "it may be long enough";
  ASSERT_EQ(low.findings.count(DiagnosticId::travel_uncertain), 1U);
  EXPECT_EQ(low.findings.kept()[0].text,
            "Z moves to -510 in machine coordinates without the tool length of offset 4, which is not known; the "
            "travel is -500 to 0");
  EXPECT_TRUE(low.machine[2].empty());
  EXPECT_TRUE(reports(low, "the tool length of offset 4 is not known: the travel of Z was checked without it"));
  EXPECT_EQ(on_mill({with_length(451, kPlus, 4)}).findings.count(DiagnosticId::travel_exceeded), 1U)
      << "any tool makes it worse";
  EXPECT_EQ(on_mill({with_length(451, kMinus, 4)}).findings.count(DiagnosticId::travel_uncertain), 1U);
  EXPECT_TRUE(on_mill({with_length(0, kPlus, 4)}).findings.empty());
  EXPECT_TRUE(reports(on_mill({with_length(0, kPlus, 99)}),
                      "the tool length of offset 99 is not known: the travel of Z was checked without it"));
}

TEST(Travel, ALengthThatTheProgramChangesIsNotKnown) {
  ir::Motion set = with_length(-60, kPlus, 1);
  set.gaps = ir::kLengthsChanged;
  EXPECT_EQ(on_mill({set}).findings.count(DiagnosticId::travel_uncertain), 1U);
}

TEST(Travel, AnEdgeIsOfTheToolInTheSpindle) {
  Settings settings{.machine = mill(), .d_selects_edge = true};
  settings.machine.tools = {{.number = 1, .offset = 1, .length_mm = 100},
                            {.number = 1, .offset = 2, .length_mm = 60},
                            {.number = 5, .offset = 1, .length_mm = 20}};
  const auto top = [&](int tool_number, int edge) {
    const Report report = run({event(tool, tool_number), with_length(0, kPlus, edge)}, settings);
    return report.machine[2].empty() ? 0.0 : report.machine[2].high + 450;
  };
  EXPECT_DOUBLE_EQ(top(1, 1), 100);
  EXPECT_DOUBLE_EQ(top(1, 2), 60);
  EXPECT_DOUBLE_EQ(top(1, 0), 100) << "no D: the first edge";
  EXPECT_DOUBLE_EQ(top(5, 1), 20);
  EXPECT_TRUE(reports(run({event(tool, 1), with_length(0, kPlus, 0)}, settings),
                      "tool 1 is called without D: its edge 1 is taken to be in effect"));
  EXPECT_DOUBLE_EQ(top(5, 2), 0) << "not known";
  ir::Motion across = with_length(0, kPlus, 1);
  across.plane = ir::Plane::zx;  // G18: the tool lies along Y
  across.axes_commanded = 0b111;
  const Report report = run({event(tool, 1), across}, settings);
  EXPECT_DOUBLE_EQ(report.machine[2].high, -450);
  EXPECT_DOUBLE_EQ(report.machine[1].high, 300);
}

TEST(Travel, OfALatheTheLengthHasTwoParts) {
  ir::Motion cut = move(rapid, 0, 0, 220, 0);
  cut.length_offset = kPlus;
  cut.length_offset_number = 6;
  const Report good = run({cut});
  EXPECT_TRUE(good.findings.empty()) << "110 and 40 are 150";
  EXPECT_DOUBLE_EQ(good.machine[2].high, 175);
  cut.end[0] = 220.01;
  EXPECT_EQ(run({cut}).findings.count(DiagnosticId::travel_exceeded), 1U);
  cut.length_offset_number = 7;  // not measured
  cut.end[0] = 302;
  const Report unknown = run({cut});
  EXPECT_EQ(unknown.findings.count(DiagnosticId::travel_exceeded), 0U);
  EXPECT_EQ(unknown.findings.count(DiagnosticId::travel_uncertain), 1U);
  EXPECT_TRUE(reports(unknown, "the tool length of offset 7 is not known: the travel of Z was checked without it"));
}

TEST(Travel, TheOriginStandsForOffsetsWithoutValues) {
  Settings settings{.machine = lathe(), .work_offset = 1};
  settings.machine.origin[2] = 300;
  const Report report = run({move(rapid, 0, 0, 300, 100)}, settings);
  EXPECT_TRUE(report.findings.empty());
  EXPECT_DOUBLE_EQ(report.machine[2].high, 400);
  EXPECT_TRUE(reports(report, "work offset 1 is not known for X: its travel was not checked"));
  EXPECT_EQ(run({move(rapid, 0, 0, 300, 100.01)}, settings).findings.count(DiagnosticId::travel_exceeded), 1U);
  settings.work_offset = 2;
  EXPECT_DOUBLE_EQ(run({move(rapid, 0, 0, 300, 100)}, settings).machine[2].high, 300) << "its own value counts";
}

TEST(Travel, AnOffsetThatNoOneNamedIsReported) {
  EXPECT_TRUE(reports(run({move(rapid, 0, 0, 10, 10)}), "no work offset is named: 2 is taken to be in effect"));
  EXPECT_FALSE(reports(run({event(offset, 2), move(rapid, 0, 0, 10, 10)}),
                       "no work offset is named: 2 is taken to be in effect"));
}

TEST(Travel, WhatTheProgramChangesIsNotClaimed) {
  ir::Motion far = move(rapid, 0, 0, 9000, 9000);
  far.gaps = ir::kZerosChanged;
  const Report changed = run({far});
  EXPECT_TRUE(changed.findings.empty());
  EXPECT_TRUE(changed.machine[0].empty());
  EXPECT_TRUE(changed.lost_place);
  EXPECT_FALSE(run({move(rapid, 0, 0, 10, 10)}).lost_place);
  EXPECT_TRUE(
      reports(changed, "the program changes coordinates or work offsets: the travel of X was not checked from there"));
  far.machine_coordinates = true;
  EXPECT_EQ(run({far}).findings.count(DiagnosticId::travel_exceeded), 2U);
}

TEST(Travel, WhatKinematicsDecideIsNotClaimed) {
  ir::Motion far = move(rapid, 0, 0, 9000, 9000);
  far.gaps = ir::kFrameLost;
  const Report swivelled = run({far});
  EXPECT_TRUE(swivelled.findings.empty());
  EXPECT_TRUE(swivelled.machine[0].empty());
  EXPECT_TRUE(swivelled.lost_place);
  EXPECT_TRUE(reports(swivelled,
                      "a plane is swivelled or a transformation is on, which the machine's kinematics decide: the "
                      "travel of X was not checked from there"));
  far.machine_coordinates = true;
  EXPECT_EQ(run({far}).findings.count(DiagnosticId::travel_exceeded), 2U);
}

TEST(Travel, AnIncrementFromAnUnknownPlaceIsNotClaimed) {
  ir::Motion step = move(rapid, 0, 0, 9000, 9000);
  step.gaps = ir::kEndUnknown;
  step.axes_unknown = 0b001;
  const Report report = run({step});
  EXPECT_EQ(report.findings.count(DiagnosticId::travel_exceeded), 1U) << "Z is known";
  EXPECT_EQ(report.findings.kept()[0].text.substr(0, 1), "Z");
  EXPECT_TRUE(reports(
      report, "X is at a position that is not known, and an increment moves it: its travel was not checked there"));
  step.gaps = 0;  // an absolute word: only its start is not known
  EXPECT_EQ(run({step}).findings.count(DiagnosticId::travel_exceeded), 2U);
}

}  // namespace
}  // namespace dripfeed::envelope
