// The hyperbolic roll of "macro for a hyperbolic surface": x = 2a·sqrt(1 + (z/b)²), a = 100, b = 202.4, z from -98 to
// 98, turned in chords of equal angle. What the checks measure is compared with closed forms of the chord and with a
// nose that is set down densely along the path.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "checks/accuracy/accuracy.h"
#include "checks/gouge/gouge.h"
#include "dialects/curves/conic.h"
#include "dialects/curves/deviation.h"
#include "dialects/curves/profile.h"

namespace dripfeed {
namespace {

constexpr double kA = 100.0;
constexpr double kB = 202.4;
constexpr double kEnd = 98.0;
constexpr double kDegree = std::numbers::pi / 180.0;
const curves::Conic kRoll{curves::ConicKind::hyperbola, kA, kB, {0, 0}};

curves::Profile nominal(double tolerance, double end = kEnd) {
  return {{{curves::curve_of(kRoll, {-end, end}), tolerance}}};
}

// Points at t = t0, t0 - step, …, -t0: the last step is shortened to hit the end.
std::vector<curves::Point> points(double step_deg, double end = kEnd) {
  const double half = std::atan(end / kB);
  std::vector<curves::Point> all;
  for (int k = 0;; ++k) {
    const double t = std::max(half - k * step_deg * kDegree, -half);
    all.push_back({kB * std::tan(t), kA / std::cos(t)});
    if (t <= -half) return all;
  }
}

std::vector<ir::Motion> motions(const std::vector<curves::Point>& path) {
  ir::Motion tool;
  tool.kind = ir::MotionKind::tool;
  tool.number = 6;
  std::vector<ir::Motion> all = {tool};
  for (std::size_t i = 1; i < path.size(); ++i) {
    ir::Motion cut;
    cut.kind = ir::MotionKind::linear;
    cut.plane = ir::Plane::zx;
    cut.place = {0, static_cast<std::uint32_t>(10 + i), i};
    cut.start[0] = 2 * path[i - 1].x;
    cut.start[2] = path[i - 1].z;
    cut.end[0] = 2 * path[i].x;
    cut.end[2] = path[i].z;
    all.push_back(cut);
  }
  return all;
}

accuracy::Report measure(const std::vector<curves::Point>& path, double nose_radius) {
  accuracy::Accuracy check(
      {.nominal = nominal(0.02, path.front().z), .tools = {{.number = 6, .nose_radius_mm = nose_radius, .tip = 3}}});
  check.consume(motions(path));
  return check.finish();
}

// Largest distance of the hyperbola from a chord between two of its points: where its tangent is parallel to the chord,
// z = b·u/sqrt(1 - u²) with u = m·b/a for the chord's slope m.
double chord_error(curves::Point p, curves::Point q) {
  const double m = (q.x - p.x) / (q.z - p.z);
  const double u = m * kB / kA;
  const double z = kB * u / std::sqrt(1 - u * u);
  const double gap = p.x + m * (z - p.z) - kA * std::sqrt(1 + z * z / (kB * kB));
  return gap / std::sqrt(1 + m * m);
}

double largest_chord_error(const std::vector<curves::Point>& path) {
  double largest = 0;
  for (std::size_t i = 1; i < path.size(); ++i) largest = std::max(largest, chord_error(path[i - 1], path[i]));
  return largest;
}

TEST(Roll, FineStepsMissByTwoTenthsOfAMicrometre) {
  const auto path = points(0.2);
  const accuracy::Report report = measure(path, 0.0);
  const double expected = largest_chord_error(path);
  EXPECT_NEAR(expected, 0.0002, 0.00005);
  EXPECT_NEAR(report.path.max_mm, expected, 2e-3 * expected);
  EXPECT_NEAR(report.figures().max_mm, report.path.max_mm, 1e-15);
  ASSERT_TRUE(report.chord_bound_mm);
  EXPECT_GE(*report.chord_bound_mm, expected);
  EXPECT_LE(*report.chord_bound_mm, 1.2 * expected);
  EXPECT_EQ(report.blocks, path.size() - 1);
  EXPECT_TRUE(report.covered);
  EXPECT_TRUE(report.findings.empty());
}

TEST(Roll, CoarseStepsMissByATenthOfAMillimetre) {
  const auto path = points(5.0, kB * std::tan(40 * kDegree));
  const accuracy::Report report = measure(path, 0.0);
  const double expected = largest_chord_error(path);
  EXPECT_NEAR(expected, 0.115, 0.001);
  EXPECT_NEAR(measure(points(5.0), 0.0).path.max_mm, 0.102, 0.001);  // less on the shorter roll
  EXPECT_NEAR(report.path.max_mm, expected, 2e-3 * expected);
  EXPECT_GE(*report.chord_bound_mm, expected);
  EXPECT_GT(report.path.lowest_mm, -1e-9);  // chords of a waist leave material, they never take too much
  EXPECT_GT(report.findings.count(text::DiagnosticId::deviation_beyond_tolerance), 0U);
  // A chord's deviation is a parabola: mean 2/3 and root mean square sqrt(8/15) of its height, averaged over all
  // chords.
  double length = 0, sum = 0, square = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double chord = curves::distance(path[i - 1], path[i]);
    const double height = chord_error(path[i - 1], path[i]);
    length += chord;
    sum += chord * height * 2 / 3;
    square += chord * height * height * 8 / 15;
  }
  EXPECT_NEAR(report.path.mean_mm, sum / length, 5e-3 * sum / length);
  EXPECT_NEAR(report.path.rmse_mm, std::sqrt(square / length), 5e-3 * std::sqrt(square / length));
}

// Lowest and highest (distance of the centre less the radius) along the path, for centres whose nearest point is on the
// nominal; nearest points by brute force.
curves::Range dense_nose(const std::vector<curves::Point>& path, double radius) {
  curves::Range seen{1e300, -1e300};
  for (std::size_t i = 1; i < path.size(); ++i) {
    for (int k = 0; k < 20; ++k) {
      const curves::Point tip = path[i - 1] + (k / 20.0) * (path[i] - path[i - 1]);
      const curves::Point center = tip + radius * curves::Point{1, 1};
      double low = center.z - 2 * radius, high = center.z + 2 * radius;
      const auto away = [&](double z) { return curves::distance(center, {z, kA * std::sqrt(1 + z * z / (kB * kB))}); };
      for (int step = 0; step < 100; ++step) {  // the distance has one minimum here
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        (away(a) < away(b) ? high : low) = away(a) < away(b) ? b : a;
      }
      if (low < -kEnd || low > kEnd) continue;
      seen = {std::min(seen.low, away(low) - radius), std::max(seen.high, away(low) - radius)};
    }
  }
  return seen;
}

TEST(Roll, ANoseWithoutCompensationIsOffByUpToTwoTenths) {
  const auto path = points(0.2);
  const accuracy::Report report = measure(path, 0.8);
  ASSERT_TRUE(report.surface);
  // On a slope of angle w the nose is off by r(cos w + sin w - 1), w counted towards the chuck.
  const auto off = [](double slope) {
    const double w = std::atan(slope);
    return 0.8 * (std::cos(w) - std::sin(w) - 1);
  };
  EXPECT_NEAR(report.surface->lowest_mm, off(kRoll.at(kEnd).slope), 2e-3);
  EXPECT_NEAR(report.surface->highest_mm, off(kRoll.at(-kEnd).slope), 4e-3);  // the tip ends before the nose does
  const curves::Range dense = dense_nose(path, 0.8);
  EXPECT_NEAR(report.surface->lowest_mm, dense.low, 5e-4);
  EXPECT_NEAR(report.surface->highest_mm, dense.high, 5e-4);
  EXPECT_NEAR(report.figures().max_mm, 0.19, 0.01);
  EXPECT_LT(report.path.max_mm, 0.0003);
}

TEST(Roll, TheNoseThatCutsTooDeepIsAGouge) {
  const auto path = points(0.2);
  gouge::Settings settings;
  settings.stock = gouge::Cylinder{2 * kA * std::sqrt(1 + kEnd * kEnd / (kB * kB)) + 4, -kEnd, kEnd};
  settings.nominal = nominal(0.02);
  settings.tools = {{.number = 6, .nose_radius_mm = 0.8, .tip = 3}};
  gouge::Gouge bare(settings);
  bare.consume(motions(path));
  const gouge::Report report = bare.finish();
  EXPECT_NEAR(report.deepest_cut_mm, -dense_nose(path, 0.8).low, 1e-3);
  EXPECT_GT(report.findings.count(text::DiagnosticId::cut_below_nominal), 50U);
  settings.tools[0].nose_radius_mm = 0.0;
  gouge::Gouge point(settings);
  point.consume(motions(path));
  EXPECT_TRUE(point.finish().findings.empty());
}

TEST(Roll, AnAdaptiveStepFromTheBoundStaysWithinIt) {
  // Steps along z by the bound of the second derivative: never beyond 0.01 mm, and hardly more chords than needed.
  std::vector<curves::Point> path = {{kEnd, kRoll.at(kEnd).x}};
  while (path.back().z > -kEnd) {
    const double second = kRoll.second_derivatives(std::max(-kEnd, path.back().z - 30), path.back().z).high;
    const double z = std::max(-kEnd, path.back().z - std::sqrt(8 * 0.01 / second));
    path.push_back({z, kRoll.at(z).x});
  }
  const accuracy::Report report = measure(path, 0.0);
  EXPECT_LE(*report.chord_bound_mm, 0.01 + 1e-12);
  EXPECT_LE(report.path.max_mm, *report.chord_bound_mm);
  EXPECT_GT(report.path.max_mm, 0.008);
}

}  // namespace
}  // namespace dripfeed
