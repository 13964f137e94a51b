// Merged blocks against polygons and circles that are computed here: how far both paths lie apart is measured along
// both, and never more than what is stated.
#include "dialects/compile/render/merged_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dialects/compile/render/optimized.h"
#include "dialects/text/number.h"
#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

constexpr std::string_view kMillHead = "G21 G90 G94 G17 G40\nT1 M6\nG54\nS1000 M3\nG0 X0. Y0. Z5.\nG1 Z-1. F100.\n";

std::string in_mm(double value) { return text::format_fixed(value, 3); }

struct Spot {
  double x = 0.0;
  double y = 0.0;
};
double distance_to(const Spot& p, const Spot& a, const Spot& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double t = square > 0.0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

// Places along all cuts, close together; arcs of the x-y plane are turned along.
std::vector<Spot> spots_of(const std::string& text) {
  std::vector<Spot> out;
  for (const ir::Motion& m : run_text(text, control("fanuc", ir::MachineKind::mill)).motions) {
    if (!ir::is_move(m.kind) || m.kind == ir::MotionKind::rapid) continue;
    const bool turns = m.kind != ir::MotionKind::linear;
    const int parts = turns ? 64 : 4;
    const double radius = std::hypot(m.center[0], m.center[1]);
    const Spot center{m.start[0] + m.center[0], m.start[1] + m.center[1]};
    const double begin = std::atan2(-m.center[1], -m.center[0]);
    double sweep = std::atan2(m.end[1] - center.y, m.end[0] - center.x) - begin;
    if (m.kind == ir::MotionKind::arc_ccw && sweep <= 0.0) sweep += 2.0 * std::numbers::pi;
    if (m.kind == ir::MotionKind::arc_cw && sweep >= 0.0) sweep -= 2.0 * std::numbers::pi;
    for (int i = 0; i <= parts; ++i) {
      const double t = static_cast<double>(i) / parts;
      if (turns)
        out.push_back(
            {center.x + radius * std::cos(begin + t * sweep), center.y + radius * std::sin(begin + t * sweep)});
      else
        out.push_back({m.start[0] + t * (m.end[0] - m.start[0]), m.start[1] + t * (m.end[1] - m.start[1])});
    }
  }
  return out;
}

// The farthest_spot that a place of `from` is from the path `to`.
double farthest_spot(const std::vector<Spot>& from, const std::vector<Spot>& to) {
  double out = 0.0;
  for (const Spot& p : from) {
    double near = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < to.size(); ++i) near = std::min(near, distance_to(p, to[i - 1], to[i]));
    out = std::max(out, near);
  }
  return out;
}

MergedBlocks merged_text(const std::string& text, const MergeWishes& wishes) {
  const ir::Control control = test::control("fanuc", ir::MachineKind::mill);
  ProgramLibrary library(control, {});
  return merge_blocks(text::Source("a.nc", text), control, library, wishes);
}

std::size_t line_count_of(const std::string& text) { return static_cast<std::size_t>(std::ranges::count(text, '\n')); }

TEST(MergedBlocks, BlocksOnOneLineAreOneBlock) {
  const std::string text = std::string(kMillHead) + "X1. Y1.\nX2. Y2.\nX3. Y3.\nX3. Y9.\nM30\n";
  const MergedBlocks made = merged_text(text, {.lines = true, .tolerance_mm = 0.001});
  EXPECT_EQ(made.obstacle, "");
  EXPECT_EQ(made.text, std::string(kMillHead) + "X3. Y3.\nX3. Y9.\nM30\n");
  EXPECT_EQ(made.origin_lines, (std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6, 9, 10, 11}));
  ASSERT_EQ(made.groups.size(), 1U);
  EXPECT_LT(made.most_mm, 1e-9);
}

TEST(MergedBlocks, AWavyLineStaysWithinTheToleranceThatIsProved) {
  std::string text(kMillHead);
  for (int i = 1; i <= 400; ++i) {
    const double x = 0.25 * i;
    text += fmt::format("X{} Y{}\n", in_mm(x), in_mm(8.0 * std::sin(0.11 * x) + 0.002 * std::sin(3.1 * x)));
  }
  text += "G0 Z5.\nM30\n";
  for (const double tolerance : {0.001, 0.01, 0.1}) {
    const MergedBlocks made = merged_text(text, {.lines = true, .tolerance_mm = tolerance});
    ASSERT_EQ(made.obstacle, "");
    const std::vector<Spot> old_path = spots_of(text);
    const std::vector<Spot> new_path = spots_of(made.text);
    const double off = std::max(farthest_spot(old_path, new_path), farthest_spot(new_path, old_path));
    EXPECT_LE(off, made.most_mm + 1e-9) << tolerance;
    EXPECT_GT(off, 0.7 * made.most_mm) << "the bound is far off";
    EXPECT_LE(made.most_mm, tolerance);
    EXPECT_LT(line_count_of(made.text), tolerance < 0.005 ? line_count_of(text) : line_count_of(text) / 3);
  }
}

TEST(MergedBlocks, ArcsOfOneCircleAreOneArc) {
  std::string text(kMillHead);
  text += "G1 X10. Y0.\n";
  Spot at{10.0, 0.0};
  for (int i = 1; i <= 5; ++i) {
    const Spot to{10.0 * std::cos(0.5 * i), 10.0 * std::sin(0.5 * i)};
    text += fmt::format("G3 X{} Y{} I{} J{}\n", in_mm(to.x), in_mm(to.y), in_mm(-at.x), in_mm(-at.y));
    at = {std::round(to.x * 1000.0) / 1000.0, std::round(to.y * 1000.0) / 1000.0};
  }
  text += "G1 Z5.\nM30\n";
  const MergedBlocks made = merged_text(text, {.arcs = true, .tolerance_mm = 0.005});
  ASSERT_EQ(made.obstacle, "");
  ASSERT_EQ(made.groups.size(), 1U);
  EXPECT_EQ(line_count_of(made.text) + 4, line_count_of(text));
  EXPECT_TRUE(made.text.contains(fmt::format("G3 X{} Y{} I-10.0000 J0.0000\n", in_mm(at.x), in_mm(at.y)))) << made.text;
  const std::vector<Spot> old_path = spots_of(text);
  const std::vector<Spot> new_path = spots_of(made.text);
  constexpr double kChord = 10.0 * 0.04 * 0.04 / 8.0;  // of the polygons that stand for the arcs here
  EXPECT_LE(std::max(farthest_spot(old_path, new_path), farthest_spot(new_path, old_path)), made.most_mm + kChord);
  EXPECT_LE(made.most_mm, 0.005);
}

TEST(MergedBlocks, NothingIsMergedThatDiffersInAnything) {
  const auto kept = [](const std::string& body) {
    const std::string text = std::string(kMillHead) + body + "M30\n";
    const MergedBlocks made = merged_text(text, {.lines = true, .arcs = true, .tolerance_mm = 0.001});
    return made.obstacle.empty() && made.groups.empty() && made.text == text;
  };
  EXPECT_TRUE(kept("X1.\nX2. F200.\n"));
  EXPECT_TRUE(kept("X1. M8\nX2. M9\n"));
  EXPECT_TRUE(kept("X1.\nX2. (HERE)\n"));
  EXPECT_TRUE(kept("X1.\n/X2.\n"));
  EXPECT_TRUE(kept("X1.\nX0.5\n"));       // it turns back
  EXPECT_TRUE(kept("X1.\nX2. Y0.01\n"));  // it leaves the line
  EXPECT_TRUE(kept("G91\nX1.\nX1.\n"));   // increments count from the block before
  EXPECT_TRUE(kept("G41 D1 X1.\nX2.\nX3.\nG40 X4.\n"));
  EXPECT_TRUE(kept("X1. Y1.\nX2.\n"));
  EXPECT_FALSE(kept("X1.\nX2.\n"));
}

TEST(MergedBlocks, ProgramsThatJumpOrCallAreLeft) {
  for (const std::string body : {"GOTO 10\nN10 X1.\nX2.\n", "M98 P5\nX1.\nX2.\n", "#1=5.\nX#1\nX6.\nX7.\n"}) {
    const std::string text = std::string(kMillHead) + body + "M30\n";
    const MergedBlocks made = merged_text(text, {.lines = true, .tolerance_mm = 0.01});
    EXPECT_NE(made.obstacle, "") << body;
    EXPECT_EQ(made.text, text);
  }
}

TEST(MergedBlocks, OptimizingStatesTheProvedDistance) {
  const ir::Control control = test::control("fanuc", ir::MachineKind::mill);
  OptimizeRequest request{
      .source = text::Source("a.nc", std::string(kMillHead) + "X1. Y1.\nX2. Y2.001\nX3. Y3.\nM30\n"),
      .control = control,
      .cost = control.cost};
  request.settings.rules.set(optimize::Rule::lines, true);
  EXPECT_EQ(optimize_text(request).text, request.source.text()) << "without a tolerance";
  request.settings.tolerance_mm = 0.01;
  const OptimizeResult made = optimize_text(request);
  EXPECT_EQ(made.text, std::string(kMillHead) + "X3. Y3.\nM30\n");
  ASSERT_TRUE(made.off_mm);
  EXPECT_NEAR(*made.off_mm, 0.001 / std::numbers::sqrt2, 1e-6);
  ASSERT_TRUE(made.before && made.after);
  EXPECT_EQ(made.after->moves + 2, made.before->moves);
}

}  // namespace
}  // namespace dripfeed::compile::test
