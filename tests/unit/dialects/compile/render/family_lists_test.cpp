// Numbers of a list that the program sets: read only after that.
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/render/family_run.h"

namespace dripfeed::compile::test {
namespace {

std::string faults_of(const std::string& steps, RenderMode mode) {
  const text::Source family = with("list kept of length 4\n", steps);
  const RenderResult result = rendered(family, "fanuc", mode, {});
  EXPECT_EQ(result.text.empty(), text::has_error(result.diagnostics));
  return messages_of(result.diagnostics, family);
}

TEST(FamilyLists, ANumberThatIsReadBeforeItIsSetIsAnError) {
  for (const RenderMode mode : {RenderMode::macro, RenderMode::explicit_blocks}) {
    for (const char* steps :
         {"  cut x kept[2]\n", "  set kept[1] = 3 mm\n  cut x 1 mm\n  cut x kept[2]\n",
          "  for n from 0 to 2 step 1\n    set kept[n] = n*1 mm\n  end\n  for q from 0 to 3 step 1\n"
          "    cut x kept[q]\n  end\n",
          "  for one in kept\n    cut x one\n  end\n"}) {
      const std::string found = faults_of(steps, mode);
      EXPECT_TRUE(found.contains("a list that the program has not set")) << steps << found;
      EXPECT_FALSE(found.contains(":1:1:")) << found;
    }
    EXPECT_EQ(faults_of("  for n from 0 to 3 step 1\n    set kept[n] = n*1 mm\n  end\n  for q from 0 to 3 step 1\n"
                        "    cut x kept[q]\n  end\n",
                        mode),
              "");
    EXPECT_EQ(faults_of("  set kept[3] = 3 mm\n  cut x kept[3]\n", mode), "");
    // What is not come to is not read.
    EXPECT_EQ(faults_of("  let n = 1\n  cut x 1 mm\n  if n > 2\n    cut x kept[3]\n  end\n", mode), "");
  }
}

// numpy.interp of the same points, written out.
double along(const std::vector<double>& xs, const std::vector<double>& ys, double x) {
  if (x <= xs.front()) return ys.front();
  for (std::size_t i = 1; i < xs.size(); ++i)
    if (x <= xs[i]) return ys[i - 1] + (x - xs[i - 1]) / (xs[i] - xs[i - 1]) * (ys[i] - ys[i - 1]);
  return ys.back();
}

TEST(FamilyLists, InterpolationGoesFromPointToPoint) {
  const std::vector<double> xs = {-7, -2, 0.5, 4, 30};
  const std::vector<double> ys = {3, -1, 8, 8, 2.5};
  const std::string lists =
      "param xs list of length -7 mm, -2 mm, 0.5 mm, 4 mm, 30 mm in -50..50 count 2..9\n"
      "list ys = 3 mm, -1 mm, 8 mm, 8 mm, 2.5 mm\n";
  const std::vector<ir::Motion> moves =
      one_trace(with(lists, "  for q from -10 mm to 35 mm step 1.5 mm\n    cut x q y interpolate(xs, ys, q)\n  end\n"));
  ASSERT_EQ(moves.size(), 31U);
  for (const ir::Motion& one : moves) EXPECT_NEAR(one.end[1], along(xs, ys, one.end[0]), kTolerance) << one.end[0];
  // On the points, in a function, in conditions that are asked again, and computed before the program.
  const std::vector<ir::Motion> others = one_trace(with(
      lists + "list ks = 0, 1, 2\nlist vs = 5 mm, 10 mm, 0 mm\nfunction at(q length) = interpolate(xs, ys, q)*2\n"
              "let first = at(-4.5 mm)\nrequire at(0.5 mm) = 16 mm\n",
      "  let q = -7 mm\n  while interpolate(xs, ys, q) < 8 mm\n    cut x q y at(q)\n    set q = q + 2.5 mm\n  end\n"
      "  if interpolate(xs, ys, max(q, 30 mm)) = 2.5 mm\n    cut x xs[1] y interpolate(xs, ys, xs[1])\n  end\n"
      "  cut x first y interpolate(ks, vs, 1.5)\n"));
  const std::vector<std::pair<double, double>> wanted = {{-7, 6}, {-4.5, 2}, {-2, -2}, {-2, -1}, {2, 5}};
  ASSERT_EQ(others.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_NEAR(others[i].end[0], wanted[i].first, kTolerance) << i;
    EXPECT_NEAR(others[i].end[1], wanted[i].second, kTolerance) << i;
  }
}

TEST(FamilyLists, InterpolationTakesPointsThatIncreaseAndStay) {
  const auto found = [](const std::string& lists, const std::string& steps) {
    const text::Source family = with(lists, steps);
    return messages_of(rendered(family, "fanuc", RenderMode::macro, {}).diagnostics, family);
  };
  const std::string step = "  let q = 1 mm\n  cut x interpolate(xs, ys, q)\n";
  EXPECT_EQ(found("list xs = 0 mm, 1 mm\nlist ys = 5 mm, 6 mm\n", step), "");
  EXPECT_TRUE(found("list xs = 0 mm, 0 mm\nlist ys = 5 mm, 6 mm\n", step).contains("xs must increase: 0 follows 0"));
  EXPECT_TRUE(
      found("list xs = 0 mm, 1 mm\nlist ys = 5 mm, 6 mm, 7 mm\n", step).contains("xs has 2 numbers and ys has 3"));
  EXPECT_TRUE(found("list xs = 0 mm\nlist ys = 5 mm\n", step).contains("two or more"));
  EXPECT_TRUE(
      found("list xs = 0 mm, 1 mm\nlist ys = 5 mm, 6 mm\n", step + "  set ys[0] = 1 mm\n").contains("changes ys"));
  EXPECT_TRUE(found("list xs = 0 deg, 1 deg\nlist ys = 5 mm, 6 mm\n", step).contains("family-wrong-unit"));
  EXPECT_TRUE(found("list ys = 5 mm, 6 mm\nlet xs = 1 mm\n", step).contains("the name of a list"));
  EXPECT_TRUE(
      found("list xs = 1 mm, 0 mm\nlist ys = 5 mm, 6 mm\nlet first = interpolate(xs, ys, 0.5 mm)\n", "  cut x first\n")
          .contains("xs must increase"));
  const std::string nominal =
      "list xs = 0 mm, 1 mm\nlist ys = 5 mm, 6 mm\nfunction at(q length) = interpolate(xs, ys, q)\n";
  EXPECT_TRUE(found(nominal + "nominal curve for t in 0 mm .. 1 mm x t y at(t) tolerance 0.01 mm\n", step)
                  .contains("a nominal is not an interpolation"));
  EXPECT_EQ(found(nominal + "nominal curve for t in 0 mm .. 1 mm x t y at(0.5 mm) tolerance 0.01 mm\n", step), "");
}

}  // namespace
}  // namespace dripfeed::compile::test
