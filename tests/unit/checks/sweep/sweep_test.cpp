// Parameter spaces whose region is known.
#include "checks/sweep/sweep.h"

#include <cmath>
#include <stop_token>
#include <string>

#include <gtest/gtest.h>

namespace dripfeed::sweep {
namespace {

std::vector<Parameter> three() {
  return {{"length", "mm", 10, 100, 50, false}, {"width", "mm", 0, 10, 2, false}, {"count", "", 1, 40, 4, true}};
}

// Fails beyond 80 in length and above 12 in count.
Trial simple(std::span<const double> v) {
  if (v[0] > 80) return {false, "travel", "too long"};
  if (v[2] > 12) return {false, "limit", "too many"};
  return {true, {}, {}};
}

TEST(Sweep, BisectionFindsWhereEachSideEnds) {
  const Report report = sweep(three(), simple, {});
  ASSERT_EQ(report.ranges.size(), 3U);
  EXPECT_FALSE(report.ranges[0].low.is_bounded);
  EXPECT_EQ(report.ranges[0].low.reach, 10);
  EXPECT_TRUE(report.ranges[0].high.is_bounded);
  EXPECT_NEAR(report.ranges[0].high.reach, 80, 1e-3);
  EXPECT_LE(report.ranges[0].high.reach, 80);
  EXPECT_GT(report.ranges[0].high.fails_at, 80);
  EXPECT_EQ(report.ranges[0].high.check, "travel");
  EXPECT_FALSE(report.ranges[1].high.is_bounded);
  EXPECT_EQ(report.ranges[2].high.reach, 12);
  EXPECT_EQ(report.ranges[2].high.fails_at, 13);
  EXPECT_EQ(report.corners.tried, 8U);
  EXPECT_EQ(report.corners.passed, 2U);
  EXPECT_EQ(report.samples.tried, 100U);
  EXPECT_GT(report.samples.passed, 5U);
  EXPECT_LT(report.samples.passed, 45U);
}

TEST(Sweep, TheSmallestFailureChangesOneParameterByTheLeast) {
  const Report report = sweep(three(), simple, {});
  ASSERT_TRUE(report.smallest_failure);
  EXPECT_EQ(report.smallest_failure->changed, std::vector<std::size_t>{2});  // 9 of 39, and 30 of 90 for the length
  EXPECT_EQ(report.smallest_failure->values[2], 13);
  EXPECT_EQ(report.smallest_failure->trial.check, "limit");
}

TEST(Sweep, AFailureOfTwoTogetherIsShrunkToThem) {
  const auto both = [](std::span<const double> v) {
    return v[0] > 80 && v[1] > 6 ? Trial{false, "gouge", "both"} : Trial{true, {}, {}};
  };
  const Report report = sweep(three(), both, {});
  for (const ParameterRange& range : report.ranges) EXPECT_FALSE(range.low.is_bounded || range.high.is_bounded);
  ASSERT_TRUE(report.smallest_failure);
  EXPECT_EQ(report.smallest_failure->changed, (std::vector<std::size_t>{0, 1}));
  EXPECT_NEAR(report.smallest_failure->values[0], 80, 0.01);
  EXPECT_NEAR(report.smallest_failure->values[1], 6, 0.01);
}

TEST(Sweep, IsTheSameForASeedAndAnyNumberOfThreads) {
  Settings settings{.seed = 7, .samples = 60, .most_corners = 4};
  const Report one = sweep(three(), simple, settings);
  settings.threads = 4;
  const Report four = sweep(three(), simple, settings);
  EXPECT_EQ(one.corners.passed, four.corners.passed);
  EXPECT_EQ(one.samples.passed, four.samples.passed);
  EXPECT_EQ(one.smallest_failure->values, four.smallest_failure->values);
  EXPECT_EQ(one.trials, four.trials);
  EXPECT_EQ(one.corners.tried, 4U);
  EXPECT_EQ(plot::svg(region_plot(one)), plot::svg(region_plot(four)));
}

TEST(Sweep, EndsWhereTheStandardFails) {
  const Report report = sweep(three(), [](std::span<const double>) { return Trial{false, "run", "never"}; }, {});
  EXPECT_TRUE(report.ranges.empty());
  EXPECT_EQ(report.trials, 1U);
  EXPECT_TRUE(report.smallest_failure->changed.empty());
}

TEST(Sweep, IsBounded) {
  std::vector<Parameter> many;
  for (int i = 0; i < 30; ++i) many.push_back({"p" + std::to_string(i), "mm", 0, 1e9, 5e8, false});
  const Report report =
      sweep(many, [](std::span<const double> v) { return Trial{std::fmod(v[0] + v[29], 3.0) < 2.0, "odd", ""}; }, {});
  EXPECT_LE(report.trials, 1 + 60 * (1 + kBisections) + 64 + 100 + kShrunk * 30 * (1 + kBisections));
  EXPECT_EQ(sweep({}, [](std::span<const double>) { return Trial{true, {}, {}}; }, {}).trials, 1U);
  const Report stuck =
      sweep({{"fixed", "", 3, 3, 3, false}}, [](std::span<const double>) { return Trial{true, {}, {}}; }, {});
  EXPECT_FALSE(stuck.ranges[0].high.is_bounded);
}

TEST(Sweep, StopsWhenAsked) {
  std::stop_source source;
  int tries = 0;
  const auto attempt = [&](std::span<const double> values) {
    if (++tries == 5) source.request_stop();
    return simple(values);
  };
  const Report report = sweep(three(), attempt, {.samples = 1000, .stop = source.get_token()});
  EXPECT_EQ(tries, 5);
  EXPECT_EQ(report.trials, 5U);
}

TEST(Sweep, ThePlotNamesWhatBounds) {
  const std::string drawn = plot::svg(region_plot(sweep(three(), simple, {})));
  EXPECT_NE(drawn.find(">travel<"), std::string::npos);
  EXPECT_NE(drawn.find(">count<"), std::string::npos);
}

}  // namespace
}  // namespace dripfeed::sweep
