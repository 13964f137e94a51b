// The seal ring of the paper as four programs: G. Nikiel, "Optimization of execution speed of the CNC parametric part
// programs", chapter 3. The listings of variants 1, 3 and 4 are the paper's; what it leaves out (set-up, loops, the
// nearer of the two points) and its equations 4 and 6 were written from the others: the line P + t·N, and w1 = Nx² +
// Ny² + A·Nz², w2 = 2·(Px·Nx + Py·Ny + A·Pz·Nz) + B·Nz, w3 = Px² + Py² + A·Pz² + B·Pz + C.
#include "tests/numeric/seal_ring.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dialects/text/number.h"

namespace dripfeed {
namespace {

using seal_ring::kPrograms;
using seal_ring::points_of;

TEST(SealRing, ThePointsLieOnTheTiltedCone) {
  const double degree = std::numbers::pi / 180;
  for (const ir::Motion& point : points_of(kPrograms[0])) {
    const double radius = point.end[0] / 2;
    const double angle = point.end[5] * degree;
    const double x = radius * std::cos(angle), y = radius * std::sin(angle), z = point.end[2] + 5;
    const double tilted_x = x * std::cos(4 * degree) - z * std::sin(4 * degree);
    const double tilted_z = x * std::sin(4 * degree) + z * std::cos(4 * degree);
    EXPECT_NEAR(std::hypot(tilted_x, y), 30 + (10 - tilted_z) * std::tan(15 * degree), 1e-9);
  }
}

TEST(SealRing, TheFirstThreeVariantsMakeTheSameMoves) {
  const auto first = points_of(kPrograms[0]);
  for (const char* name : {kPrograms[1], kPrograms[2]}) {
    const auto other = points_of(name);
    for (std::size_t i = 0; i < first.size(); ++i) {
      for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis)
        ASSERT_NEAR(other[i].end[axis], first[i].end[axis], 1e-9) << name << ' ' << i;
    }
  }
  // Thales between the ends of the table: the same at the ends, and what it costs between.
  const auto table = points_of(kPrograms[3]);
  double worst = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const double off = std::fabs(table[i].end[0] - first[i].end[0]) / 2;
    const bool is_end = i < 72 || i >= 216;
    EXPECT_LE(off, is_end ? 1e-9 : 0.01) << i;
    worst = std::max(worst, off);
  }
  fmt::print("variant 4 is off by {} mm of radius at the most\n", text::format_fixed(worst, 6));
  EXPECT_GT(worst, 1e-6);  // a section of a tilted cone is no straight line
}

}  // namespace
}  // namespace dripfeed
