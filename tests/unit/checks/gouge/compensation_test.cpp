// Led paths against closed forms: a square inside and outside, arcs, corners of each kind, approach and departure; and
// seeded contours whose axis must keep its distance.
#include "checks/gouge/compensation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string_view>

#include <gtest/gtest.h>

namespace dripfeed::gouge {
namespace {

using ir::CompSide;
using ir::MotionKind;

struct XY {
  double x, y;
};

class Path {
 public:
  explicit Path(XY at) : at_(at) {}
  Path& line(XY to, CompSide comp, MotionKind kind = MotionKind::linear) {
    ir::Motion m = begin(kind, comp);
    m.end = {to.x, to.y, z_};
    return add(m, to);
  }
  Path& arc(XY to, XY center, MotionKind kind, CompSide comp) {
    ir::Motion m = begin(kind, comp);
    m.end = {to.x, to.y, z_};
    m.center = {center.x - at_.x, center.y - at_.y, 0};
    return add(m, to);
  }
  Path& down(double z, CompSide comp) {
    ir::Motion m = begin(MotionKind::linear, comp);
    m.end[2] = z_ = z;
    return add(m, at_);
  }
  std::vector<ir::Motion> moves;

 private:
  [[nodiscard]] ir::Motion begin(MotionKind kind, CompSide comp) const {
    ir::Motion m;
    m.kind = kind;
    m.comp = comp;
    m.start = m.end = {at_.x, at_.y, z_};
    m.place.line = static_cast<std::uint32_t>(moves.size() + 1);
    return m;
  }
  Path& add(const ir::Motion& m, XY to) {
    moves.push_back(m);
    at_ = to;
    return *this;
  }
  XY at_;
  double z_ = 0.0;
};

struct Led {
  std::vector<ir::Motion> moves;
  checks::NotCheckedList notes;
};

Led lead(const Path& path, double radius, OuterCorner corner = OuterCorner::arc) {
  Led led;
  Compensation compensation(corner, led.notes);
  for (const ir::Motion& move : path.moves) compensation.add(move, radius);
  compensation.flush();
  led.moves.assign(compensation.known().begin(), compensation.known().end());
  for (const ir::Motion& move : led.moves) EXPECT_EQ(move.comp, CompSide::off);
  for (std::size_t i = 1; i < led.moves.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(led.moves[i].start[axis], led.moves[i - 1].end[axis], 1e-9) << "move " << i << " axis " << axis;
  }
  return led;
}

void expect_ends(const Led& led, const std::vector<XY>& wanted) {
  ASSERT_EQ(led.moves.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_NEAR(led.moves[i].end[0], wanted[i].x, 1e-9) << i;
    EXPECT_NEAR(led.moves[i].end[1], wanted[i].y, 1e-9) << i;
  }
}

bool reports(const Led& led, std::string_view part) {
  return std::ranges::any_of(led.notes.list(),
                             [&](const auto& one) { return one.text.find(part) != std::string::npos; });
}

constexpr CompSide kOff = CompSide::off;
constexpr CompSide kLeft = CompSide::left;
constexpr CompSide kRight = CompSide::right;

// Counterclockwise around a square of 20 from the middle of its lower side.
Path square(CompSide side) {
  Path path({0, -5});
  path.line({0, -10}, side).line({10, -10}, side).line({10, 10}, side).line({-10, 10}, side);
  path.line({-10, -10}, side).line({0, -10}, side).line({0, -5}, kOff);
  return path;
}

TEST(Compensation, InsideASquareTheCornersAreTrimmed) {
  const Led led = lead(square(kLeft), 3);
  expect_ends(led, {{0, -7}, {7, -7}, {7, 7}, {-7, 7}, {-7, -7}, {0, -7}, {0, -5}});
  EXPECT_TRUE(led.notes.empty());
}

TEST(Compensation, OutsideASquareTheCornersAreGoneAround) {
  const Led around = lead(square(kRight), 3);
  expect_ends(around, {{0, -13},
                       {10, -13},
                       {13, -10},
                       {13, 10},
                       {10, 13},
                       {-10, 13},
                       {-13, 10},
                       {-13, -10},
                       {-10, -13},
                       {0, -13},
                       {0, -5}});
  for (const std::size_t i : {2U, 4U, 6U, 8U}) {
    EXPECT_EQ(around.moves[i].kind, MotionKind::arc_ccw) << i;
    EXPECT_NEAR(std::hypot(around.moves[i].center[0], around.moves[i].center[1]), 3, 1e-9);
  }
  // To where the lines meet: a right angle just does.
  const Led straight = lead(square(kRight), 3, OuterCorner::straight);
  expect_ends(straight, {{0, -13},
                         {10, -13},
                         {13, -13},
                         {13, -10},
                         {13, 10},
                         {13, 13},
                         {10, 13},
                         {-10, 13},
                         {-13, 13},
                         {-13, 10},
                         {-13, -10},
                         {-13, -13},
                         {-10, -13},
                         {0, -13},
                         {0, -5}});
}

TEST(Compensation, ASharpCornerIsCutOffARadiusBeyondIt) {
  Path path({0, 0});
  path.line({0, 10}, kRight).line({20, 10}, kRight).line({0, 11}, kRight).line({0, 20}, kOff);
  const Led led = lead(path, 2, OuterCorner::straight);
  ASSERT_GE(led.moves.size(), 5U);
  EXPECT_NEAR(led.moves[2].end[0], 22, 1e-9);  // 2 beyond the corner along x, 2 next to it
  EXPECT_NEAR(led.moves[2].end[1], 8, 1e-9);
  for (const ir::Motion& m : led.moves) EXPECT_NE(m.kind, MotionKind::arc_ccw);
  // Back on its own path: half around the corner.
  Path back({0, 0});
  back.line({0, 10}, kRight).line({20, 10}, kRight).line({0, 10}, kRight).line({0, 20}, kOff);
  const Led half = lead(back, 2);
  ASSERT_EQ(half.moves.size(), 5U);
  EXPECT_EQ(half.moves[2].kind, MotionKind::arc_ccw);
  EXPECT_NEAR(half.moves[2].end[1], 12, 1e-9);
}

TEST(Compensation, ArcsKeepTheirCentreAndChangeTheirRadius) {
  for (const auto& [side, radius] : {std::pair(kLeft, 7.0), std::pair(kRight, 13.0)}) {
    Path path({0, 0});
    path.line({10, 0}, side).arc({10, 0}, {0, 0}, MotionKind::arc_ccw, side).line({5, 0}, kOff);
    const Led led = lead(path, 3);
    ASSERT_EQ(led.moves.size(), 3U);
    EXPECT_NEAR(led.moves[0].end[0], radius, 1e-9);
    EXPECT_NEAR(std::hypot(led.moves[1].center[0], led.moves[1].center[1]), radius, 1e-9);
    EXPECT_NEAR(led.moves[1].end[0], radius, 1e-9);
    EXPECT_NEAR(led.moves[1].end[1], 0, 1e-9);
  }
  Path tight({0, 0});
  tight.line({2, 0}, kLeft).arc({2, 0}, {0, 0}, MotionKind::arc_ccw, kLeft).line({1, 0}, kOff);
  EXPECT_TRUE(reports(lead(tight, 3), "tighter than the cutter"));
}

// A line along x into a circle around (0, 0) with radius 10, a hollow corner: the axis turns where both offsets meet.
TEST(Compensation, HollowCornersOfArcsAreTrimmedAtTheCrossing) {
  Path path({30, -3});
  path.line({25, 0}, kLeft).line({10, 0}, kLeft).arc({-10, 0}, {0, 0}, MotionKind::arc_cw, kLeft).line({-20, 0}, kOff);
  // Left of the path to -x is below; the arc runs below the centre, its left is outside: radius 12.
  const Led led = lead(path, 2);
  ASSERT_GE(led.moves.size(), 3U);
  EXPECT_NEAR(led.moves[1].end[1], -2, 1e-9);
  EXPECT_NEAR(led.moves[1].end[0], std::sqrt(144.0 - 4.0), 1e-9);
  EXPECT_NEAR(std::hypot(led.moves[2].end[0], led.moves[2].end[1]), 12, 1e-9);
  EXPECT_TRUE(led.notes.empty());
}

TEST(Compensation, DownMovesBetweenWaitForThePath) {
  Path path({0, 0});
  path.line({0, 10}, kRight).down(-5, kRight).line({20, 10}, kRight).down(3, kOff).line({40, 0}, kOff);
  const Led led = lead(path, 2);
  ASSERT_EQ(led.moves.size(), 5U);
  EXPECT_NEAR(led.moves[0].end[1], 8, 1e-9);
  EXPECT_EQ(led.moves[1].end[2], -5);
  EXPECT_NEAR(led.moves[1].end[1], 8, 1e-9);
  EXPECT_NEAR(led.moves[3].end[0], 20, 1e-9);  // up, still next to the path
  EXPECT_NEAR(led.moves[3].end[1], 8, 1e-9);
  EXPECT_NEAR(led.moves[4].end[0], 40, 1e-9);
  EXPECT_TRUE(led.notes.empty());
  Path twice({0, 0});
  twice.line({0, 10}, kRight).down(-5, kRight).down(-6, kRight).line({20, 10}, kRight).line({40, 0}, kOff);
  EXPECT_TRUE(reports(lead(twice, 2), "look beyond"));
}

TEST(Compensation, WhatTheControlWouldRefuseIsReported) {
  Path narrow({0, 0});  // a slot narrower than the cutter
  narrow.line({0, 5}, kLeft).line({10, 5}, kLeft).line({10, 7}, kLeft).line({0, 7}, kLeft).line({0, 20}, kOff);
  EXPECT_TRUE(reports(lead(narrow, 3), "shorter than the cutter needs"));
  Path by_arc({0, 0});
  by_arc.arc({10, 10}, {0, 10}, MotionKind::arc_ccw, kLeft).line({10, 30}, kLeft).line({0, 30}, kOff);
  EXPECT_TRUE(reports(lead(by_arc, 2), "begins with an arc"));
  Path off_by_arc({0, 0});
  off_by_arc.line({0, 5}, kLeft).line({10, 5}, kLeft).arc({20, 15}, {10, 15}, MotionKind::arc_ccw, kOff);
  EXPECT_TRUE(reports(lead(off_by_arc, 2), "ends with an arc"));
}

TEST(Compensation, OthersPassAsTheyAre) {
  checks::NotCheckedList notes;
  Compensation compensation(OuterCorner::arc, notes);
  EXPECT_TRUE(compensation.is_idle());
  Path path({0, 0});
  path.line({5, 5}, kOff);
  compensation.add(path.moves[0], 0);
  ASSERT_EQ(compensation.known().size(), 1U);
  EXPECT_EQ(compensation.known()[0].end[0], 5);
  EXPECT_TRUE(compensation.is_idle());
  ir::Motion unknown = path.moves[0];
  unknown.comp = kLeft;
  unknown.axes_unknown = 3;
  compensation.clear_known();
  compensation.add(unknown, 2);
  EXPECT_FALSE(compensation.is_idle());
  compensation.forget();
  ASSERT_EQ(compensation.known().size(), 1U);
  EXPECT_EQ(compensation.known()[0].axes_unknown, 3);
  EXPECT_TRUE(compensation.is_idle());
}

double distance_to(const ir::Motion& m, XY at) {
  const double dx = m.end[0] - m.start[0], dy = m.end[1] - m.start[1];
  const double t = std::clamp(((at.x - m.start[0]) * dx + (at.y - m.start[1]) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(at.x - m.start[0] - t * dx, at.y - m.start[1] - t * dy);
}

// Around the outside of star-shaped polygons, whose hollow corners are wide enough: the axis is never nearer than the
// radius to any side, and touches each.
TEST(Compensation, TheAxisKeepsItsDistance) {
  std::mt19937 random(4);
  for (int round = 0; round < 60; ++round) {
    std::vector<XY> corners;
    for (int i = 0; i < 9; ++i) {
      const double angle = 2 * std::numbers::pi * i / 9;
      const double r = std::uniform_real_distribution<double>(30, 45)(random);
      corners.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    const XY first{0.5 * (corners[8].x + corners[0].x), 0.5 * (corners[8].y + corners[0].y)};
    Path path({2 * first.x, 2 * first.y});
    path.line(first, kRight);
    for (const XY& corner : corners) path.line(corner, kRight);
    path.line(first, kRight).line({2 * first.x, 2 * first.y}, kOff);
    for (const OuterCorner corner : {OuterCorner::arc, OuterCorner::straight}) {
      const Led led = lead(path, 2, corner);
      EXPECT_TRUE(led.notes.empty());
      double nearest = 1e9;
      for (std::size_t i = 1; i + 1 < led.moves.size(); ++i) {
        if (led.moves[i].kind != MotionKind::linear) continue;
        for (int k = 0; k <= 20; ++k) {
          const auto at = [&](std::size_t axis) {
            return led.moves[i].start[axis] + k / 20.0 * (led.moves[i].end[axis] - led.moves[i].start[axis]);
          };
          for (std::size_t side = 1; side + 1 < path.moves.size(); ++side)
            nearest = std::min(nearest, distance_to(path.moves[side], {at(0), at(1)}));
        }
      }
      EXPECT_NEAR(nearest, 2, 1e-9) << round;
    }
  }
}

}  // namespace
}  // namespace dripfeed::gouge
