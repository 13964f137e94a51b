// Arcs in space against what defines them: the distance from the centre, the plane, the points that they go through.
#include "dialects/interpreter/motion/space_arc.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace dripfeed::test {
namespace {

using interpreter::arc_in_plane;
using interpreter::arc_through;
using interpreter::keeps_shapes;
using interpreter::Matrix;
using interpreter::SpaceArc;
using interpreter::Turn;
using interpreter::Vector;

void expect_near(const Vector& a, const Vector& b, double tolerance) {
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], tolerance) << i;
}
double distance(const Vector& a, const Vector& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

// (0 0 0), (5 0 5), (10 0 0): half a circle about (5 0 0) that stands on X.
TEST(SpaceArc, HalfACircleThatStands) {
  const auto arc = arc_through({5.0, 0.0, 5.0}, {10.0, 0.0, 0.0});
  ASSERT_TRUE(arc.has_value());
  expect_near(arc->center, {5.0, 0.0, 0.0}, 1e-12);
  EXPECT_NEAR(arc->sweep_rad, std::numbers::pi, 1e-12);
  expect_near(arc->at(0.0), {}, 1e-12);
  expect_near(arc->at(0.5), {5.0, 0.0, 5.0}, 1e-12);
  expect_near(arc->at(1.0), {10.0, 0.0, 0.0}, 1e-12);
  const Vector tangent = arc->end_tangent();
  EXPECT_LT(tangent[2], 0.0);
  EXPECT_NEAR(tangent[0], 0.0, 1e-12);
}

// The same three points, the short arc and the long one: what lies in between decides.
TEST(SpaceArc, ThePointInBetweenDecides) {
  const double h = std::sqrt(0.5);
  // A unit circle about the origin in the plane y = z, from (1 0 0); points at 60, 90 and 200 degrees.
  const auto on = [&](double degrees) {
    const double a = degrees / 180.0 * std::numbers::pi;
    return Vector{std::cos(a) - 1.0, std::sin(a) * h, std::sin(a) * h};
  };
  struct Case {
    double via_deg;
    double end_deg;
    double sweep_deg;
  };
  for (const Case& one : {Case{60.0, 90.0, 90.0}, Case{200.0, 90.0, 270.0}, Case{90.0, 200.0, 200.0},
                          Case{350.0, 200.0, 160.0}, Case{1.0, 359.0, 359.0}}) {
    const auto arc = arc_through(on(one.via_deg), on(one.end_deg));
    ASSERT_TRUE(arc.has_value());
    EXPECT_NEAR(arc->sweep_rad * 180.0 / std::numbers::pi, one.sweep_deg, 1e-9);
    expect_near(arc->center, {-1.0, 0.0, 0.0}, 1e-12);
    expect_near(arc->at(1.0), on(one.end_deg), 1e-12);
    double nearest = 1.0;
    for (int i = 0; i <= 36'000; ++i) nearest = std::min(nearest, distance(arc->at(i / 36'000.0), on(one.via_deg)));
    EXPECT_LT(nearest, 1e-4);
  }
}

TEST(SpaceArc, PointsOfALineAreNone) {
  EXPECT_FALSE(arc_through({1.0, 2.0, 3.0}, {2.0, 4.0, 6.0}).has_value());
  EXPECT_FALSE(arc_through({3.0, 6.0, 9.0}, {2.0, 4.0, 6.0}).has_value());
  EXPECT_FALSE(arc_through({}, {1.0, 0.0, 0.0}).has_value());
  EXPECT_FALSE(arc_through({1.0, 0.0, 0.0}, {}).has_value());
  EXPECT_FALSE(arc_through({1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}).has_value());
  EXPECT_TRUE(arc_through({1.0, 1e-6, 0.0}, {2.0, 0.0, 0.0}).has_value());
}

TEST(SpaceArc, AHelixInItsPlane) {
  // G18: Z X, the normal is Y. A quarter clockwise from (z, x) = (5, 0) round the origin, seen from +Y: to (0, -5).
  const SpaceArc arc =
      arc_in_plane(interpreter::axes_of(ir::Plane::zx), {-5.0, 0.0}, {-5.0, -5.0}, 3.0, Turn::clockwise);
  EXPECT_NEAR(arc.sweep_rad, std::numbers::pi / 2.0, 1e-12);
  expect_near(arc.at(1.0), {-5.0, 3.0, -5.0}, 1e-12);
  const double h = 5.0 * std::sqrt(0.5);
  expect_near(arc.at(0.5), {-h, 1.5, h - 5.0}, 1e-12);
  // Along -Z at its end, and rising 3 on a path of 5 pi / 2.
  const Vector tangent = arc.end_tangent();
  EXPECT_NEAR(tangent[0], 0.0, 1e-12);
  EXPECT_NEAR(tangent[1] / tangent[2], -3.0 / (2.5 * std::numbers::pi), 1e-12);
}

TEST(SpaceArc, ItsImage) {
  const SpaceArc arc =
      arc_in_plane(interpreter::axes_of(ir::Plane::xy), {0.0, 5.0}, {5.0, 5.0}, 1.0, Turn::counterclockwise);
  const Matrix m = interpreter::rotation_of({30.0, -20.0, 50.0});
  const SpaceArc turned = image_of(arc, m);
  for (const double t : {0.0, 0.25, 0.7, 1.0}) expect_near(turned.at(t), interpreter::multiply(m, arc.at(t)), 1e-12);
}

TEST(SpaceArc, MatricesThatKeepShapes) {
  using interpreter::diagonal_of;
  EXPECT_TRUE(keeps_shapes(interpreter::kIdentity));
  EXPECT_TRUE(keeps_shapes(interpreter::rotation_of({30.0, -20.0, 50.0})));
  EXPECT_TRUE(keeps_shapes(diagonal_of({-2.0, 2.0, 2.0})));
  EXPECT_FALSE(keeps_shapes(diagonal_of({2.0, 2.0, 1.0})));
  const Matrix turned = interpreter::rotation_of({0.0, 0.0, 45.0});
  EXPECT_FALSE(keeps_shapes(interpreter::multiply(turned, diagonal_of({2.0, 1.0, 1.0}))));
  EXPECT_FALSE(keeps_shapes(interpreter::multiply(diagonal_of({2.0, 1.0, 1.0}), turned)));
}

}  // namespace
}  // namespace dripfeed::test
