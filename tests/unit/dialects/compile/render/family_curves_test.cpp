// Curves by their parameter: their points against the closed form, in all dialects and both forms.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/render/family_run.h"

namespace dripfeed::compile::test {
namespace {

text::Source mill(const std::string& steps) {
  return {"test.family",
          "family test\nmachine mill\nparam r length 20 mm in 1..99\nparam n count 6 in 1..99\nprogram test\n"
          "  spindle 600 rpm cw\n  feed 100 mm/min\n" +
              steps + "end\n"};
}

double sine(double degrees) { return std::sin(degrees * std::numbers::pi / 180.0); }

TEST(FamilyCurves, EqualStepsHitBothEnds) {
  const auto found = one_trace(mill("  cut along t from 90 deg down to 0 deg  x r*cos(t)  y r*sin(t)  steps n\n"), {});
  ASSERT_EQ(found.size(), 7U);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double t = 90.0 - 15.0 * static_cast<double>(i);
    EXPECT_NEAR(found[i].end[0], 20.0 * sine(90.0 - t), 1e-3) << i;
    EXPECT_NEAR(found[i].end[1], 20.0 * sine(t), 1e-3) << i;
  }
}

// r*t²: every piece bends the same, h²/8·2r <= 0.01 with h = 1/8/count: two chords a piece.
TEST(FamilyCurves, ChordsOfAParabolaAreEqual) {
  const auto found =
      one_trace(mill("  cut along t from 0 to 1  x r*t^2  y 10 mm*t  within 0.02 mm\n  rapid z 5 mm\n"), {});
  ASSERT_EQ(found.size(), 18U);
  for (std::size_t i = 0; i < 17; ++i) {
    const double t = static_cast<double>(i) / 16.0;
    EXPECT_NEAR(found[i].end[0], 20.0 * t * t, 1e-3) << i;
    EXPECT_NEAR(found[i].end[1], 10.0 * t, 1e-3) << i;
  }
}

// The same name twice, inside a loop, and two lists of counts.
TEST(FamilyCurves, TwoCurvesHaveCountsOfTheirOwn) {
  const auto found = one_trace(mill("  for pass from 1 to 2 step 1\n"
                                    "    cut along t from 0 to 1  x r*t^2  y 10 mm*t  within 0.02 mm\n"
                                    "    cut along t from 1 down to 0  x 2*r*t^2  y 10 mm*t  within 0.0025 mm\n"
                                    "  end\n"),
                               {});
  ASSERT_EQ(found.size() % 2, 0U);
  const std::size_t pass = found.size() / 2;
  ASSERT_GT(pass, 17U + 17U) << "the second has the finer error";
  for (std::size_t i = 0; i < pass; ++i) EXPECT_NEAR(found[i].end[0], found[pass + i].end[0], 1e-9) << i;
  EXPECT_NEAR(found[16].end[0], 20.0, 1e-3);
  EXPECT_NEAR(found[17].end[0], 40.0, 1e-3);
  EXPECT_NEAR(found[pass - 1].end[0], 0.0, 1e-3);
}

// A family of these lists and a curve along them.
text::Source along_points(const std::string& lists, const std::string& curve) {
  return {"test.family", "family test\nmachine mill\nparam n count 6 in 1..99\n" + lists +
                             "program test\n  spindle 600 rpm cw\n  feed 100 mm/min\n  " + curve + "\nend\n"};
}

// (1-t)³a + 3t(1-t)²b + 3t²(1-t)c + t³d
TEST(FamilyCurves, PointsOfABezierCurve) {
  const auto found =
      one_trace(along_points("list xs = 0 mm, 10 mm, 30 mm, 40 mm\nlist ys = 0 mm, 24 mm, -8 mm, 5 mm\n"
                             "list zs = 0 mm, -1 mm, -1 mm, -4 mm\n",
                             "cut along bezier x xs y ys z zs steps n"));
  ASSERT_EQ(found.size(), 7U);
  const auto at = [](double t, double a, double b, double c, double d) {
    const double u = 1.0 - t;
    return u * u * u * a + 3.0 * t * u * u * b + 3.0 * t * t * u * c + t * t * t * d;
  };
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double t = static_cast<double>(i) / 6.0;
    EXPECT_NEAR(found[i].end[0], at(t, 0.0, 10.0, 30.0, 40.0), 1e-3) << i;
    EXPECT_NEAR(found[i].end[1], at(t, 0.0, 24.0, -8.0, 5.0), 1e-3) << i;
    EXPECT_NEAR(found[i].end[2], at(t, 0.0, -1.0, -1.0, -4.0), 1e-3) << i;
  }
}

// A whole circle as a NURBS curve of order 3, whose inner knots stand twice: the radius and the chords' sagitta are
// known.
TEST(FamilyCurves, CircleOfConicsWithinAnError) {
  const std::string lists =
      "const half = 0.5*sqrt(2)\n"
      "list xs = 20 mm, 20 mm, 0 mm, -20 mm, -20 mm, -20 mm, 0 mm, 20 mm, 20 mm\n"
      "list ys = 0 mm, 20 mm, 20 mm, 20 mm, 0 mm, -20 mm, -20 mm, -20 mm, 0 mm\n"
      "list ws = 1, half, 1, half, 1, half, 1, half, 1\n"
      "list knots_ = 0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4\n";
  const auto found =
      one_trace(along_points(lists, "cut along nurbs order 3 x xs y ys weights ws knots knots_ within 0.01 mm"));
  double turned = 0.0;
  for (std::size_t i = 1; i < found.size(); ++i) {
    const double x = found[i].end[0];
    const double y = found[i].end[1];
    EXPECT_NEAR(std::hypot(x, y), 20.0, 1e-3) << i;
    const double before_x = found[i - 1].end[0];
    const double before_y = found[i - 1].end[1];
    EXPECT_LE(20.0 - std::hypot(x + before_x, y + before_y) / 2.0, 0.01 + 1e-3) << i;
    turned += std::atan2(before_x * y - before_y * x, before_x * x + before_y * y);
  }
  EXPECT_NEAR(turned, 2.0 * std::numbers::pi, 1e-3);
  const double fewest = std::numbers::pi / std::acos(1.0 - 0.01 / 20.0);
  EXPECT_GE(static_cast<double>(found.size() - 1), fewest);
  EXPECT_LE(static_cast<double>(found.size() - 1), 1.2 * fewest + 16.0);
  const auto equal =
      one_trace(along_points(lists, "cut along nurbs order 3 x xs y ys weights ws knots knots_ steps 8"));
  ASSERT_EQ(equal.size(), 9U);
  for (std::size_t i = 0; i < equal.size(); ++i) {
    const double angle = 45.0 * static_cast<double>(i);
    EXPECT_NEAR(equal[i].end[0], 20.0 * sine(90.0 - angle), 1e-3) << i;
    EXPECT_NEAR(equal[i].end[1], 20.0 * sine(angle), 1e-3) << i;
  }
}

// Clamped and uniform knots, and a list parameter: the quadratic through three points of one span, then of two.
TEST(FamilyCurves, KnotsThatAreLeftOut) {
  const std::string lists =
      "param corners list of points x y (0 mm, 0 mm), (10 mm, 20 mm), (20 mm, 0 mm) in -50..50 count 3..9\n";
  const std::string curve = "cut along nurbs order 3 x corners.x y corners.y steps 4";
  const auto one = one_trace(along_points(lists, curve));
  ASSERT_EQ(one.size(), 5U);
  for (std::size_t i = 0; i < one.size(); ++i) {
    const double t = static_cast<double>(i) / 4.0;
    EXPECT_NEAR(one[i].end[0], 20.0 * t, 1e-3) << i;
    EXPECT_NEAR(one[i].end[1], 40.0 * t * (1.0 - t), 1e-3) << i;
  }
  const auto two = one_trace(along_points(lists, curve),
                             {{"corners", "(0 mm, 0 mm), (10 mm, 20 mm), (20 mm, 0 mm), (30 mm, 20 mm)"}});
  ASSERT_EQ(two.size(), 5U);
  // Between both spans the curve is in the middle of the inner points.
  EXPECT_NEAR(two[2].end[0], 15.0, 1e-3);
  EXPECT_NEAR(two[2].end[1], 10.0, 1e-3);
  EXPECT_NEAR(two[4].end[0], 30.0, 1e-3);
}

}  // namespace
}  // namespace dripfeed::compile::test
