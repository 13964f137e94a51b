// The chords of a curve lie within its error, measured at points of the curve that the counts know nothing of; and what
// is refused instead of being counted.
#include "dialects/family/chord_counts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dialects/family/evaluate.h"
#include "dialects/family/read.h"

namespace dripfeed::family {
namespace {

BindResult bound_of(const std::string& machine, const std::string& steps) {
  const std::string text = "family test\nmachine " + machine +
                           "\nparam size length 20 mm in 0.1..500\nparam error length 0.01 mm in -1..10\nprogram test\n"
                           "  spindle 600 rpm cw\n  feed 100 mm/min\n" +
                           steps + "\nend\n";
  ReadFamilyResult read = read_family(text::Source("test", text));
  if (text::has_error(read.diagnostics)) return {{}, std::move(read.diagnostics)};
  return bind_family(std::make_shared<const Family>(std::move(read.family)), {});
}

std::string fault(const std::string& machine, const std::string& steps) {
  const BindResult bound = bound_of(machine, steps);
  return bound.diagnostics.empty() ? "" : bound.diagnostics.front().arguments.front();
}

std::vector<double> counts_of(const BoundFamily& bound) {
  const std::span<const double> found = list_in(bound.values, bound.family->chorded.front().counts);
  return {found.begin(), found.end()};
}

struct Point {
  double x, y;
};
double distance(Point p, Point a, Point b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double at = square == 0.0 ? 0.0 : std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0);
  return std::hypot(p.x - a.x - at * dx, p.y - a.y - at * dy);
}

// The farthest that the curve lies from its chords.
template <typename Curve>
double farthest(const Curve& at, double from, double to, const std::vector<double>& counts) {
  double most = 0.0;
  const double piece = (to - from) / static_cast<double>(counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i)
    for (int chord = 0; chord < static_cast<int>(counts[i]); ++chord) {
      const auto t = [&](double part) { return from + (static_cast<double>(i) + (chord + part) / counts[i]) * piece; };
      for (int sample = 1; sample < 20; ++sample)
        most = std::max(most, distance(at(t(sample / 20.0)), at(t(0.0)), at(t(1.0))));
    }
  return most;
}

double degrees(double value) { return value * std::numbers::pi / 180.0; }

TEST(ChordCounts, RandomCurvesLieWithinTheirError) {
  std::mt19937 random(7);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same curves in every run
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 300; ++i) {
    const double p = 1.0 + std::round(500.0 * unit(random)) / 10.0;
    const double q = std::round(400.0 * unit(random)) / 10.0;
    const double turns = 1.0 + std::round(3.0 * unit(random));
    const double bend = std::round(9.0 * unit(random)) / 10.0;
    const double from = std::round(-200.0 * unit(random));
    const double to = from + 10.0 + std::round(350.0 * unit(random));
    const double error_mm = (1.0 + std::round(100.0 * unit(random))) / 1000.0;
    const bool down = i % 2 == 1;
    const BindResult bound = bound_of(
        "mill",
        fmt::format("  cut along t from {} deg {}to {} deg  x {}*1 mm*cos(t) + {}*1 mm*exp(radians(t)/4)  "
                    "y {}*1 mm*sin({}*t)/(1 + {}*cos(t)/2)  within {} mm",
                    down ? to : from, down ? "down " : "", down ? from : to, p, q / 10.0, q, turns, bend, error_mm));
    ASSERT_TRUE(bound.diagnostics.empty()) << bound.diagnostics.front().arguments.front();
    const auto at = [&](double t) {
      return Point{p * std::cos(degrees(t)) + q / 10.0 * std::exp(degrees(t) / 4.0),
                   q * std::sin(turns * degrees(t)) / (1.0 + bend * std::cos(degrees(t)) / 2.0)};
    };
    const std::vector<double> counts = counts_of(bound.bound);
    const double found = farthest(at, down ? to : from, down ? from : to, counts);
    EXPECT_LE(found, error_mm + 1e-9) << "curve " << i;
  }
}

// A circle has the same bend everywhere, so that the count is known: the sagitta of a chord over h is r*(1 - cos(h/2)).
TEST(ChordCounts, ACircleTakesAsManyChordsAsItsSagittaWants) {
  const BindResult bound =
      bound_of("mill", "  cut along t from 0 deg to 360 deg  x size*cos(t)  y size*sin(t)  within error");
  ASSERT_TRUE(bound.diagnostics.empty());
  const double by_sagitta = 2.0 * std::numbers::pi / (2.0 * std::acos(1.0 - 0.01 / 20.0));
  double sum = 0.0;
  for (const double count : counts_of(bound.bound)) sum += count;
  EXPECT_GE(sum, by_sagitta);
  EXPECT_LE(sum, 1.1 * by_sagitta + kCurvePieces);
}

TEST(ChordCounts, AStraightLineTakesOneChordAPiece) {
  const BindResult bound = bound_of("mill", "  cut along t from 0 mm to 9 mm  x t  y 2*t + size  within error");
  ASSERT_TRUE(bound.diagnostics.empty());
  EXPECT_EQ(counts_of(bound.bound), std::vector<double>(kCurvePieces, 1.0));
}

TEST(ChordCounts, XOfALatheCountsAsRadius) {
  const auto sum = [](const std::string& machine) {
    const BindResult bound = bound_of(machine, "  cut along t from 0 mm to 100 mm  x 2*t*t/size  z t  within error");
    EXPECT_TRUE(bound.diagnostics.empty());
    double out = 0.0;
    for (const double count : counts_of(bound.bound)) out += count;
    return out;
  };
  EXPECT_LT(sum("lathe, x is diameter"), sum("lathe, x is radius"));
}

TEST(ChordCounts, WhatCannotBeProvedIsRefused) {
  const std::string circle = "  cut along t from 0 deg to 90 deg  x size*cos(t)  y size*sin(t)  ";
  EXPECT_EQ(fault("mill", circle + "within 0 mm"), "the error of a curve is 0");
  EXPECT_EQ(fault("mill", circle + "within error - 1 mm"), "the error of a curve is -0.99");
  EXPECT_THAT(fault("mill", "  cut along t from -1 mm to 1 mm  x t  y abs(t)  within error"),
              testing::StartsWith("how far this"));
  EXPECT_THAT(fault("mill", "  cut along t from 0 deg to 90 deg  x size*tan(t)  y size  within error"),
              testing::StartsWith("how far"));
  EXPECT_THAT(fault("mill", "  let here = size\n  cut along t from 0 mm to 1 mm  x t*t/size  y t + here  within error"),
              testing::StartsWith("the chords of a curve are counted before"));
  EXPECT_THAT(fault("mill", circle + "within 0.0000000001 mm"),
              testing::EndsWith("more than 100,000 chords for its error"));
}

TEST(ChordCounts, WhatIsNoCurveIsRefused) {
  const std::string line = "  cut along t from 0 mm to 1 mm  ";
  EXPECT_EQ(fault("mill", line + "x by t  steps 4"), "the points of a curve are not steps: axes without 'by'");
  EXPECT_EQ(fault("mill", line + "x t  a 3 deg  within error"),
            "an error is a length, and this curve turns an axis: use 'steps'");
  EXPECT_EQ(fault("mill", "  skip cut along t from 0 mm to 1 mm  x t  steps 4"),
            "a curve is many blocks: only a single move may be skipped");
  EXPECT_EQ(fault("mill", line + "x t"), "expected steps or within before the end of the line");
}

// A circle of radius 20 in four conics: 8 equal steps are chords with a sagitta of 1.522 mm, 3 lie over its knots and
// have one of 10 mm.
TEST(ChordCounts, EqualStepsAreHeldToTheirError) {
  const auto fault_of_circle = [](const std::string& before, const std::string& steps, const std::string& after = "") {
    const std::string text =
        "family test\nmachine mill\nparam n count 8 in 1..99\nconst half = 0.5*sqrt(2)\n"
        "list xs = 20 mm, 20 mm, 0 mm, -20 mm, -20 mm, -20 mm, 0 mm, 20 mm, 20 mm\n"
        "list ys = 0 mm, 20 mm, 20 mm, 20 mm, 0 mm, -20 mm, -20 mm, -20 mm, 0 mm\n"
        "list ws = 1, half, 1, half, 1, half, 1, half, 1\nlist ks = 0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4\nprogram test\n"
        "  spindle 600 rpm cw\n  feed 100 mm/min\n" +
        before + "  cut along nurbs order 3 x xs y ys weights ws knots ks " + steps + "\n" + after + "end\n";
    ReadFamilyResult read = read_family(text::Source("test", text));
    if (text::has_error(read.diagnostics)) return read.diagnostics.front().arguments.front();
    const BindResult bound = bind_family(std::make_shared<const Family>(std::move(read.family)), {});
    return bound.diagnostics.empty() ? "" : bound.diagnostics.front().arguments.front();
  };
  EXPECT_EQ(fault_of_circle("", "steps n within 1.7 mm"), "");
  EXPECT_THAT(fault_of_circle("", "steps n within 1.52 mm"),
              testing::StartsWith("8 equal steps within 1.52 mm (the curve lies up to 1.55"));
  EXPECT_EQ(fault_of_circle("", "steps 3 within 10.5 mm"), "");
  EXPECT_THAT(fault_of_circle("", "steps 3 within 9.99 mm"), testing::StartsWith("3 equal steps within 9.99 mm"));
  EXPECT_EQ(fault_of_circle("", "steps 99 within 0.012 mm"), "");
  EXPECT_EQ(fault_of_circle("  if n > 20\n", "steps 3 within 1 mm", "  end\n"), "") << "not cut with these values";
  EXPECT_THAT(fault_of_circle("  let more = n\n  set more = more + 1\n", "steps more within 1 mm"),
              testing::StartsWith("the steps of a curve and how far"));
}

// Random cubic curves of three axes with weights, some inner knots twice: measured by a recursion of its own.
TEST(ChordCounts, CurvesByPointsLieWithinTheirError) {
  std::mt19937 random(11);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same curves in every run
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const std::vector<double> knots = {0, 0, 0, 0, 1, 2.5, 2.5, 4, 4, 4, 4};
  for (int i = 0; i < 100; ++i) {
    std::vector<double> at[4];
    std::string lists;
    for (int axis = 0; axis < 4; ++axis) {
      lists += fmt::format("list {} = ", std::string_view("xyzw").substr(static_cast<std::size_t>(axis), 1) == "w"
                                             ? std::string("ws")
                                             : fmt::format("p{}", "xyz"[axis]));
      for (int n = 0; n < 7; ++n) {
        const double value =
            axis == 3 ? (1.0 + std::round(30.0 * unit(random))) / 10.0 : std::round(400.0 * unit(random)) / 10.0;
        at[axis].push_back(value);
        lists += fmt::format("{}{}{}", n == 0 ? "" : ", ", value, axis == 3 ? "" : " mm");
      }
      lists += "\n";
    }
    const double error_mm = (1.0 + std::round(50.0 * unit(random))) / 1000.0;
    const std::string text =
        "family test\nmachine mill\n" + lists + "list ks = 0, 0, 0, 0, 1, 2.5, 2.5, 4, 4, 4, 4\nprogram test\n" +
        fmt::format(
            "  feed 100 mm/min\n  cut along nurbs order 4 x px y py z pz weights ws knots ks within {} mm\nend\n",
            error_mm);
    ReadFamilyResult read = read_family(text::Source("test", text));
    ASSERT_FALSE(text::has_error(read.diagnostics)) << read.diagnostics.front().arguments.front();
    const BindResult bound = bind_family(std::make_shared<const Family>(std::move(read.family)), {});
    ASSERT_TRUE(bound.diagnostics.empty()) << bound.diagnostics.front().arguments.front();
    // Cox and de Boor's basis, by its definition.
    const auto basis = [&](auto& self, std::size_t n, int degree, double t) -> double {
      if (degree == 0)
        return knots[n] <= t && (t < knots[n + 1] || (t == 4.0 && knots[n + 1] == 4.0 && knots[n] < 4.0)) ? 1.0 : 0.0;
      const auto share = [](double a, double b) { return b == 0.0 ? 0.0 : a / b; };
      const auto high = n + static_cast<std::size_t>(degree);
      return share(t - knots[n], knots[high] - knots[n]) * self(self, n, degree - 1, t) +
             share(knots[high + 1] - t, knots[high + 1] - knots[n + 1]) * self(self, n + 1, degree - 1, t);
    };
    const auto point = [&](double t) {
      double sum[4] = {};
      for (std::size_t n = 0; n < 7; ++n) {
        const double b = basis(basis, n, 3, t) * at[3][n];
        for (int axis = 0; axis < 3; ++axis) sum[axis] += b * at[axis][n];
        sum[3] += b;
      }
      return std::array<double, 3>{sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3]};
    };
    const std::span<const double> counts = list_in(bound.bound.values, bound.bound.family->point_curves.front().counts);
    ASSERT_EQ(counts.size(), 16U);
    for (std::size_t row = 0; row < counts.size(); ++row) {
      const double low = knots[3 + row / 4];
      const double width = (knots[4 + row / 4] - low) / 4.0;
      EXPECT_EQ(counts[row] == 0.0, width == 0.0) << row;
      for (int chord = 0; chord < static_cast<int>(counts[row]); ++chord) {
        const auto t = [&](double part) {
          return low + width * (static_cast<double>(row % 4) + (chord + part) / counts[row]);
        };
        const auto a = point(t(0.0));
        const auto b = point(t(1.0) - 1e-12);
        for (const double part : {0.2, 0.4, 0.5, 0.6, 0.8}) {
          const auto p = point(t(part));
          double along = 0.0;
          double square = 0.0;
          for (std::size_t k = 0; k < 3; ++k) {
            along += (p[k] - a[k]) * (b[k] - a[k]);
            square += (b[k] - a[k]) * (b[k] - a[k]);
          }
          double away = 0.0;
          for (std::size_t k = 0; k < 3; ++k) away = std::hypot(away, p[k] - a[k] - along / square * (b[k] - a[k]));
          EXPECT_LE(away, error_mm + 1e-9) << "curve " << i << " piece " << row;
        }
      }
    }
  }
}

TEST(ChordCounts, FaultsOfCurvesByPoints) {
  const auto fault_of_points = [](const std::string& lists, const std::string& steps) {
    ReadFamilyResult read = read_family(text::Source(
        "test", "family test\nmachine mill\n" + lists + "program test\n  feed 100 mm/min\n" + steps + "\nend\n"));
    if (text::has_error(read.diagnostics)) return read.diagnostics.front().arguments.front();
    const BindResult bound = bind_family(std::make_shared<const Family>(std::move(read.family)), {});
    return bound.diagnostics.empty() ? std::string() : bound.diagnostics.front().arguments.front();
  };
  const std::string lists =
      "list xs = 0 mm, 9 mm, 20 mm\nlist ys = 0 mm, 9 mm\nlist zs = 0 mm, 9 mm, 1 mm\nlist ws = 1, 0, 1\n";
  EXPECT_THAT(fault_of_points(lists, "  cut along bezier x xs y ys steps 9"), testing::HasSubstr("as many points"));
  EXPECT_THAT(fault_of_points(lists, "  cut along bezier x xs y zs weights ws steps 9"), "weights must be above 0");
  EXPECT_THAT(fault_of_points(lists, "  cut along nurbs order 4 x xs y zs steps 9"),
              testing::StartsWith("a curve needs at least"));
  EXPECT_THAT(fault_of_points(lists, "  set xs[1] = 3 mm\n  cut along bezier x xs y zs within 0.1 mm"),
              testing::StartsWith("the program changes a list"));
  EXPECT_THAT(fault_of_points(lists, "  cut along bezier x xs y zs within 0 mm"), "the error of a curve is 0");
  EXPECT_THAT(fault_of_points(lists, "  cut along bezier x xs x zs steps 9"), testing::HasSubstr("already"));
  EXPECT_THAT(fault_of_points(lists, "  cut along bezier x xs steps 9"), testing::HasSubstr("two axes or three"));
  EXPECT_THAT(fault_of_points(lists, "  cut along bezier x ws y xs steps 9"), testing::Not(testing::IsEmpty()));
  EXPECT_EQ(fault_of_points(lists, "  cut along bezier x xs y zs steps 9"), "");
}

}  // namespace
}  // namespace dripfeed::family
