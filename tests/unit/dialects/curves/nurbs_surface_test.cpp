// NURBS surfaces against sums of Cox's and de Boor's functions, derivatives against differences, heights against points
// of the surface itself.
#include "dialects/curves/nurbs_surface.h"

#include <cmath>
#include <random>
#include <utility>

#include <gtest/gtest.h>

#include "tests/unit/dialects/curves/de_boor.h"

namespace dripfeed::curves {
namespace {

// Over a sheared and stretched net, so that x and y are not u and v.
NurbsSurface wavy(std::uint32_t seed, std::size_t order, std::size_t rows, std::size_t row) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  NurbsSurface out{.order = order, .row = row, .points = {}, .weights = {}, .knots_u = {}, .knots_v = {}};
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t k = 0; k < row; ++k) {
      const double a = 10.0 * static_cast<double>(i);
      const double b = 12.0 * static_cast<double>(k);
      out.points.push_back({a + 0.2 * b + part(random), b - 0.1 * a + part(random), 5.0 * part(random)});
      out.weights.push_back(1.0 + 0.3 * part(random));
    }
  const auto knots = [&](std::size_t points) {
    std::vector<double> made(order, 2.0);
    double at = 2.0;
    for (std::size_t i = order; i < points; ++i) made.push_back(at += 1.0 + 0.5 * part(random));
    made.insert(made.end(), order, at + 1.0);
    return made;
  };
  out.knots_u = knots(rows);
  out.knots_v = knots(row);
  return out;
}

SpacePoint by_sums(const NurbsSurface& s, double u, double v) {
  SpacePoint sum;
  double weight = 0.0;
  const std::size_t rows = s.points.size() / s.row;
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t k = 0; k < s.row; ++k) {
      const double share =
          basis(s.knots_u, i, s.order - 1, u) * basis(s.knots_v, k, s.order - 1, v) * s.weights[i * s.row + k];
      const SpacePoint& point = s.points[i * s.row + k];
      sum = {sum.x + share * point.x, sum.y + share * point.y, sum.z + share * point.z};
      weight += share;
    }
  return {sum.x / weight, sum.y / weight, sum.z / weight};
}

struct Form {
  std::size_t order, rows, row;
};
constexpr Form kForms[] = {{2, 2, 3}, {3, 4, 3}, {4, 4, 4}, {4, 7, 5}, {5, 6, 8}};

TEST(NurbsSurface, PointsAreTheSumsOfTheirFunctions) {
  std::mt19937 random(4);
  for (const Form& form : kForms) {
    const NurbsSurface s = wavy(7, form.order, form.rows, form.row);
    ASSERT_EQ(fault_of(s), "");
    std::uniform_real_distribution<double> u(s.knots_u.front(), s.knots_u.back());
    std::uniform_real_distribution<double> v(s.knots_v.front(), s.knots_v.back());
    for (int n = 0; n < 200; ++n) {
      const double at_u = n == 0 ? s.knots_u.back() : n == 1 ? s.knots_u.front() : u(random);
      const double at_v = n == 0 ? s.knots_v.back() : n == 2 ? s.knots_v.front() : v(random);
      const SurfacePoint found = point_of(s, at_u, at_v);
      const SpacePoint wanted = by_sums(s, at_u, at_v);
      EXPECT_NEAR(found.at.x, wanted.x, 1e-11);
      EXPECT_NEAR(found.at.y, wanted.y, 1e-11);
      EXPECT_NEAR(found.at.z, wanted.z, 1e-11);
    }
  }
}

TEST(NurbsSurface, DerivativesAreDifferences) {
  for (const Form& form : kForms) {
    const NurbsSurface s = wavy(11, form.order, form.rows, form.row);
    const double u = 0.5 * (s.knots_u.front() + s.knots_u.back()) + 0.013;
    const double v = 0.5 * (s.knots_v.front() + s.knots_v.back()) + 0.017;
    constexpr double kStep = 1e-6;
    const SurfacePoint here = point_of(s, u, v);
    const SpacePoint to_u = point_of(s, u + kStep, v).at;
    const SpacePoint to_v = point_of(s, u, v + kStep).at;
    EXPECT_NEAR(here.along_u.x, (to_u.x - here.at.x) / kStep, 1e-4);
    EXPECT_NEAR(here.along_u.z, (to_u.z - here.at.z) / kStep, 1e-4);
    EXPECT_NEAR(here.along_v.y, (to_v.y - here.at.y) / kStep, 1e-4);
    EXPECT_NEAR(here.along_v.z, (to_v.z - here.at.z) / kStep, 1e-4);
  }
}

TEST(NurbsSurface, EveryPointOfItHasItsHeight) {
  std::mt19937 random(9);
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const Form& form = kForms[seed % std::size(kForms)];
    const NurbsSurface s = wavy(seed, form.order, form.rows, form.row);
    const HeightField field = heights_of(s, 0.1);
    std::uniform_real_distribution<double> u(s.knots_u.front(), s.knots_u.back());
    std::uniform_real_distribution<double> v(s.knots_v.front(), s.knots_v.back());
    for (int n = 0; n < 100; ++n) {
      const SpacePoint at =
          point_of(s, n < 20 ? s.knots_u.front() : u(random), n > 80 ? s.knots_v.back() : v(random)).at;
      ASSERT_TRUE(field.x.contains(at.x) && field.y(at.x).contains(at.y));
      EXPECT_NEAR(field.z(at.x, at.y), at.z, 1e-7) << "surface " << seed << " x " << at.x << " y " << at.y;
    }
  }
}

TEST(NurbsSurface, HasNoHeightOutsideIt) {
  const NurbsSurface s = wavy(3, 4, 5, 5);
  const HeightField field = heights_of(s, 0.1);
  EXPECT_FALSE(std::isfinite(field.z(field.x.high, field.y(0.0).low)));
  EXPECT_FALSE(surface_at({&field, 1}, field.x.high + 1.0, 0.0));
}

TEST(NurbsSurface, KnotsThatAreLeftOutAreUniform) {
  NurbsSurface s = wavy(5, 3, 5, 4);
  s.knots_u.clear();
  s.knots_v.clear();
  ASSERT_EQ(fault_of(s), "");
  const HeightField field = heights_of(s, 0.1);
  s.knots_u = {0, 0, 0, 1, 2, 3, 3, 3};
  s.knots_v = {0, 0, 0, 1, 2, 2, 2};
  const SpacePoint at = point_of(s, 1.3, 0.7).at;
  EXPECT_NEAR(field.z(at.x, at.y), at.z, 1e-7);
}

TEST(NurbsSurface, FaultsHaveTheirSentence) {
  const NurbsSurface good = wavy(1, 4, 5, 6);
  const auto fault = [&](auto change) {
    NurbsSurface s = good;
    change(s);
    return fault_of(s);
  };
  EXPECT_EQ(fault([](NurbsSurface& s) { s.row = 4; }), "the points are not whole rows");
  EXPECT_EQ(fault([](NurbsSurface& s) { s.row = 10; }),
            "across the rows: a surface needs at least as many points as its order");
  EXPECT_EQ(fault([](NurbsSurface& s) { s.weights[2] = 0.0; }), "weights must be above 0");
  EXPECT_EQ(fault([](NurbsSurface& s) { s.weights.pop_back(); }), "there must be a weight a point");
  EXPECT_EQ(fault([](NurbsSurface& s) { s.knots_u.pop_back(); }),
            "across the rows: there must be as many knots as points and order");
  EXPECT_EQ(fault([](NurbsSurface& s) { s.knots_v[5] = -1.0; }), "along a row: knots must not decrease");
  EXPECT_EQ(fault([](NurbsSurface& s) { s.order = 1; }), "the order must be 2 to 16");
  const auto turn = [](NurbsSurface& s) {
    for (SpacePoint& point : s.points) std::swap(point.x, point.y);
  };
  EXPECT_TRUE(fault(turn).starts_with("it does not face up at x")) << fault(turn);
}

}  // namespace
}  // namespace dripfeed::curves
