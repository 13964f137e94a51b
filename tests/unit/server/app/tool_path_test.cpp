// The path of a tool as points: what is drawn, what is not, and that nothing is drawn at a guess.
#include "server/app/checks/tool_path.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/server/app/whole_shop.h"

namespace dripfeed::app {
namespace {

ToolPath path_of(const std::string& text, std::size_t most_points = ToolPath::kMostPoints,
                 const std::string& dialect = "fanuc") {
  const auto opened = open_text({.dialect = dialect, .text = text}, test::PlainDocuments());
  PathRecorder recorder(false, most_points);
  Followed followed = follow((*opened)->examination, recorder);
  ToolPath path = recorder.finish(followed.run);
  path.report = std::move(followed.report);
  return path;
}

std::vector<std::string_view> kinds_of(const ToolPath& path) {
  std::vector<std::string_view> names;
  for (const PathKind kind : path.kinds) names.push_back(kPathKindNames[static_cast<std::size_t>(kind)]);
  return names;
}

const NotDrawnMoves& not_drawn(const ToolPath& path, NotDrawn why) {
  return path.not_drawn[static_cast<std::size_t>(why)];
}

TEST(ToolPath, APlainProgramIsItsPoints) {
  const ToolPath path =
      path_of("%\nO1\nG21 G90 G94 G17 G54\nG0 X0 Y0 Z5.\nG1 Z-1. F100.\nX10. F200.\nG0 Z5.\nM30\n%\n");
  EXPECT_EQ(path.points_mm, (std::vector<float>{0, 0, 5, 0, 0, -1, 10, 0, -1, 10, 0, 5}));
  EXPECT_EQ(kinds_of(path), (std::vector<std::string_view>{"begin", "cut_per_min", "cut_per_min", "rapid"}));
  EXPECT_EQ(path.lines, (std::vector<std::uint32_t>{4, 5, 6, 7}));
  EXPECT_EQ(path.feeds, (std::vector<float>{0, 100, 200, 0}));
  EXPECT_EQ(path.segments, 3U);
  EXPECT_DOUBLE_EQ(path.cut_mm, 16.0);
  EXPECT_DOUBLE_EQ(path.rapid_mm, 6.0);
  EXPECT_EQ(path.low_mm, (std::array<double, 3>{0, 0, -1}));
  EXPECT_EQ(path.high_mm, (std::array<double, 3>{10, 0, 5}));
  EXPECT_EQ(not_drawn(path, NotDrawn::unknown_place).count, 1U) << "the approach comes from nowhere that is known";
  EXPECT_EQ(path.work_offsets, (std::set<std::int32_t>{1}));
  EXPECT_TRUE(path.report.ran);
  EXPECT_FALSE(path.is_cut_off);
}

// X and Y are known before Z is: the moves until then are left out and counted, not drawn at some height.
TEST(ToolPath, WhatComesBeforeAKnownPlaceIsNotDrawn) {
  const ToolPath path = path_of("%\nO1\nG21 G90 G94 G17 G54\nG0 X0 Y0\nX10.\nZ5.\nG1 Z-1. F100.\nM30\n%\n");
  EXPECT_EQ(path.points_mm, (std::vector<float>{10, 0, 5, 10, 0, -1}));
  EXPECT_EQ(not_drawn(path, NotDrawn::unknown_place).count, 3U);
  EXPECT_EQ(not_drawn(path, NotDrawn::unknown_place).first_line, 4U);
}

// An axis that a program never names does not hide the rest.
TEST(ToolPath, AnAxisThatIsNeverNamedIsZero) {
  const ToolPath path = path_of("%\nO1\nG21 G90 G94 G17 G54\nG0 X0 Y0\nG1 X10. F100.\nM30\n%\n");
  EXPECT_EQ(path.points_mm, (std::vector<float>{0, 0, 0, 10, 0, 0}));
}

TEST(ToolPath, AnArcIsChordsThatLieNearIt) {
  const ToolPath path = path_of("%\nO1\nG21 G90 G94 G17 G54\nG0 X50. Y0 Z0\nG2 X50. Y0 I-50. J0 F100.\nM30\n%\n");
  ASSERT_GT(path.segments, 50U);
  EXPECT_NEAR(path.cut_mm, 100.0 * std::numbers::pi, 0.05);
  for (std::size_t i = 1; i + 1 < path.kinds.size(); ++i) {
    const double x = 0.5 * (path.points_mm[3 * i] + path.points_mm[3 * i + 3]);
    const double y = 0.5 * (path.points_mm[3 * i + 1] + path.points_mm[3 * i + 4]);
    EXPECT_NEAR(std::hypot(x, y), 50.0, 1.01 * ToolPath::kArcError_mm);
  }
  EXPECT_EQ(path.points_mm[0], path.points_mm[path.points_mm.size() - 3]) << "it closes";
}

// Y is not known, and never named: a lathe's arcs are arcs all the same.
TEST(ToolPath, AnArcOfALatheIsAnArc) {
  const auto opened = open_text(
      {.dialect = "fanuc", .text = "%\nO1\nG21 G18 G54\nG0 X100. Z0\nG1 Z-10. F0.2\nG2 X140. Z-30. R20.\nM30\n%\n"},
      test::PlainDocuments());
  (*opened)->examination.control = compile::find_dialect("fanuc")->control(ir::MachineKind::lathe, ir::GSystem::a);
  PathRecorder recorder(true);
  const Followed followed = follow((*opened)->examination, recorder);
  const ToolPath path = recorder.finish(followed.run);
  ASSERT_GT(path.segments, 10U);
  EXPECT_EQ(path.high_mm, (std::array<double, 3>{70, 0, 0})) << "radii";
  EXPECT_NEAR(path.cut_mm, 10.0 + 10.0 * std::numbers::pi, 0.05);
  EXPECT_EQ(not_drawn(path, NotDrawn::unknown_place).count, 1U);
}

TEST(ToolPath, MovesInMachineCoordinatesAndUnknownOffsetsBreakThePath) {
  const ToolPath path =
      path_of("%\nO1\nG21 G90 G94 G17 G54\nG0 X0 Y0 Z5.\nG53 G0 Z0\nG55 G0 X20. Y0 Z5.\nG1 Z-1. F100.\nM30\n%\n");
  EXPECT_EQ(path.points_mm, (std::vector<float>{20, 0, 5, 20, 0, -1}));
  EXPECT_EQ(not_drawn(path, NotDrawn::machine_coordinates).count, 1U);
  EXPECT_EQ(not_drawn(path, NotDrawn::machine_coordinates).first_line, 5U);
  EXPECT_EQ(path.work_offsets, (std::set<std::int32_t>{1, 2}));
}

TEST(ToolPath, WhereValuesAreNotKnownItSaysSo) {
  const ToolPath path =
      path_of("%\nO1\nG21 G90 G94 G17 G54\nG0 X0 Y0 Z5.\nX1.\nIF[#500 GT 1] GOTO 9\nX#501\nN9 M30\n%\n");
  EXPECT_FALSE(path.report.checks.not_checked.list().empty());
  EXPECT_EQ(path.points_mm.size(), 6U);
}

TEST(ToolPath, ALongPathIsCutOffAndSaysSo) {
  std::string text = "%\nO1\nG21 G90 G94 G17 G54\nG0 X0 Y0 Z0\nG1 F100.\n";
  for (int i = 1; i < 100; ++i) text += "X" + std::to_string(i) + ".\n";
  const ToolPath path = path_of(text + "M30\n%\n", 10);
  EXPECT_TRUE(path.is_cut_off);
  EXPECT_EQ(path.kinds.size(), 9U) << "the approach's place takes one";
}

TEST(ToolPath, ATextWithErrorsHasNone) {
  const ToolPath path = path_of("%\nO1\nG1 X[10. F100.\nM30\n%\n");
  EXPECT_TRUE(path.kinds.empty());
  EXPECT_FALSE(path.report.ran);
  ASSERT_FALSE(path.report.checks.not_checked.list().empty());
}

TEST(ToolPath, ASectionOfTheSameTextKeepsItsLines) {
  const ToolPath path = path_of("%\nO1\nG21 G90 G94 G17 G54\nG0 X0 Y0 Z5.\nM98 P2\nM30\nO2\nG1 X7. F100.\nM99\n%\n");
  ASSERT_EQ(path.lines.size(), 2U);
  EXPECT_EQ(path.lines[1], 8U);
}

}  // namespace
}  // namespace dripfeed::app
