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

#include "dialects/compile/render/optimized.h"
#include "dialects/text/number.h"

namespace dripfeed {
namespace {

using seal_ring::kPrograms;
using seal_ring::points_of;
using seal_ring::text_of;

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

// The whole algorithm with names and jumps, made faster by every rule, against the paper's own third variant.
TEST(SealRing, TheOptimizerMakesTheFirstVariantFasterThanTheThird) {
  const ir::CostModel model = seal_ring::preset();
  const auto run = [&model](const char* name) {
    const compile::Dialect& dialect = *compile::find_dialect("sinumerik-840d");
    compile::OptimizeRequest request{
        .source = text_of(name), .control = dialect.control(ir::MachineKind::mill_turn, ir::GSystem::a), .cost = {}};
    request.cost = model;
    request.settings.rules.set(optimize::Rule::comments, true);
    request.settings.free = {{ir::Bank::r, 100, 199}};
    compile::OptimizeResult result = compile::optimize_text(request);
    EXPECT_EQ(result.obstacle + result.not_verified, "");
    return result;
  };
  const compile::OptimizeResult first = run(kPrograms[0]);
  const compile::OptimizeResult third = run(kPrograms[2]);
  ASSERT_TRUE(first.before && first.after && third.before);
  const auto point_ms = [](const compile::ComputeCost& cost) {
    return text::format_fixed(cost.total_ms / (4 * 72), 2);
  };
  fmt::print("ms a point by the model: variant 1 {}, made faster {}; variant 3 {}\n", point_ms(*first.before),
             point_ms(*first.after), point_ms(*third.before));
  double saved_ms = 0.0;
  for (const compile::RuleSaving& one : first.savings) {
    saved_ms += one.saved.ms;
    fmt::print("  {} saves {} ms a point\n", optimize::row_of(one.rule).name,
               text::format_fixed(one.saved.ms / (4 * 72), 2));
  }
  EXPECT_NEAR(saved_ms, first.before->total_ms - first.after->total_ms, 1e-6);
  EXPECT_LE(first.after->total_ms, third.before->total_ms);
  // By its interval as well: with every figure to the optimizer's disadvantage.
  const compile::Saving ahead = compile::saving_between(*third.before, *first.after, model);
  fmt::print("  less than variant 3: {} ms a point ({} to {})\n", text::format_fixed(ahead.ms / (4 * 72), 2),
             text::format_fixed(ahead.least_ms / (4 * 72), 2), text::format_fixed(ahead.most_ms / (4 * 72), 2));
  EXPECT_GT(ahead.least_ms, 0.0);
  EXPECT_LT(first.after->longest_ms, first.before->longest_ms / 2);
}

// With a tolerance the optimizer makes the table that the paper's fourth variant is written with.
TEST(SealRing, ATableMakesTheFirstVariantFasterThanTheFourth) {
  const ir::CostModel model = seal_ring::preset();
  const compile::Dialect& dialect = *compile::find_dialect("sinumerik-840d");
  ir::Control control = dialect.control(ir::MachineKind::mill_turn, ir::GSystem::a);
  for (ir::VariableRange& range : control.variables)
    if (range.bank == ir::Bank::r) range.last = std::max(range.last, 499U);
  compile::OptimizeRequest request{.source = text_of(kPrograms[0]), .control = control, .cost = model};
  request.settings.rules.set(optimize::Rule::comments, true);
  request.settings.rules.set(optimize::Rule::table, true);
  request.settings.free = {{ir::Bank::r, 100, 399}};
  request.settings.tolerance_mm = 0.01;  // of the diameter
  const compile::OptimizeResult made = compile::optimize_text(request);
  ASSERT_EQ(made.obstacle + made.not_verified + made.not_tabulated, "");
  compile::OptimizeRequest as_written{.source = text_of(kPrograms[3]), .control = control, .cost = model};
  const compile::OptimizeResult fourth = compile::optimize_text(as_written);
  ASSERT_TRUE(made.off_mm && made.after && fourth.before);
  EXPECT_LE(*made.off_mm, request.settings.tolerance_mm);

  const auto first = points_of(kPrograms[0]);
  const auto table = seal_ring::points_of_text(text::Source("made", made.text));
  double off = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i) off = std::max(off, std::fabs(table[i].end[0] - first[i].end[0]));
  EXPECT_NEAR(off, *made.off_mm, 1e-9);
  // A point after the tables are filled, in both.
  const auto point_ms = [&model](const std::vector<ir::Motion>& points) {
    double ms = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) ms += ir::compute_ms(model, points[i].compute);
    return ms / static_cast<double>(points.size() - 1);
  };
  const double made_ms = point_ms(table), fourth_ms = point_ms(points_of(kPrograms[3]));
  const compile::Saving ahead = compile::saving_between(*fourth.before, *made.after, model);
  fmt::print(
      "a table, {} mm of diameter off: {} ms a point, variant 4 {}; with the filling {} ms, variant 4 {}: {} to {} "
      "less\n",
      text::format_fixed(off, 6), text::format_fixed(made_ms, 2), text::format_fixed(fourth_ms, 2),
      text::format_fixed(made.after->total_ms, 0), text::format_fixed(fourth.before->total_ms, 0),
      text::format_fixed(ahead.least_ms, 0), text::format_fixed(ahead.most_ms, 0));
  EXPECT_LT(made_ms * model.spread, fourth_ms / model.spread);
  EXPECT_GT(ahead.least_ms, 0.0);
}

}  // namespace
}  // namespace dripfeed
