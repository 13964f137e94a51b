// Ticks are round, values land where they should, and nothing that is not finite gets into a document.
#include "checks/plot/plot.h"

#include <cmath>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "checks/plot/frame.h"

namespace dripfeed::plot {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Ticks, AreRoundAndFew) {
  EXPECT_THAT(ticks(0, 10, 6), ElementsAre(0, 2, 4, 6, 8, 10));
  EXPECT_THAT(ticks(-98, 98, 5), ElementsAre(-50, 0, 50));
  EXPECT_THAT(ticks(0.0011, 0.0029, 5), testing::Pointwise(testing::DoubleNear(1e-12), {0.0015, 0.002, 0.0025}));
  EXPECT_TRUE(ticks(1, 1, 5).empty());
  EXPECT_TRUE(ticks(0, kInfinity, 5).empty());
  EXPECT_TRUE(ticks(kNan, 1, 5).empty());
  EXPECT_TRUE(ticks(1e18, 1e18 + 256, 8).size() <= 8);
}

TEST(Frame, TakesTheBoundsOfWhatIsDrawn) {
  Plot plot;
  plot.series = {{"a", {{-5, 1}, {5, 3}, {kNan, 100}, {7, kInfinity}}}};
  const Frame frame(plot, {960, 480});
  EXPECT_EQ(frame.x().low, -5);
  EXPECT_EQ(frame.x().high, 5);
  EXPECT_LT(frame.y().low, 1);
  EXPECT_LT(frame.y().high, 3.2);
  EXPECT_DOUBLE_EQ(frame.x_px(-5), frame.left());
  EXPECT_DOUBLE_EQ(frame.x_px(5), frame.right());
  plot.y.high = 10;
  EXPECT_DOUBLE_EQ(Frame(plot, {960, 480}).y_px(10), frame.top());
}

TEST(Frame, HasAWidthAlways) {
  Plot plot;
  EXPECT_GT(Frame(plot, {}).x().high, Frame(plot, {}).x().low);
  plot.series = {{"a", {{1e12, 4}}}};
  const Frame frame(plot, {});
  EXPECT_GT(frame.x().high, frame.x().low);
  EXPECT_TRUE(std::isfinite(frame.x_px(1e12)));
}

TEST(Frame, KeepsOneScaleWhenAsked) {
  Plot plot;
  plot.equal_scale = true;
  plot.series = {{"square", {{0, 0}, {10, 10}}}};
  const Frame frame(plot, {960, 480});
  EXPECT_NEAR(frame.x_px(10) - frame.x_px(0), frame.y_px(0) - frame.y_px(10), 1e-9);
}

TEST(Svg, DrawsWhatItIsGiven) {
  Plot plot;
  plot.title = "feed & <speed>";
  plot.x.title = "time, s";
  plot.series = {{"feed", {{0, 0}, {1, 2}, {2, 0}}}, {"points", {{0.5, 1}, {kNan, 1}}, Mark::dots}};
  plot.areas = {{"stall", 0.2, 0.4}, {"stall", 0.6, 0.7}};
  plot.notes = {{{1, 2}, "top"}};
  const std::string drawn = svg(plot);
  EXPECT_THAT(drawn, HasSubstr("feed &amp; &lt;speed&gt;"));
  EXPECT_THAT(drawn, HasSubstr("time, s"));
  EXPECT_THAT(drawn, Not(HasSubstr("nan")));
  EXPECT_THAT(drawn, Not(HasSubstr("inf")));
  EXPECT_EQ(count(drawn, "<polyline"), 1U);
  EXPECT_EQ(count(drawn, "<circle"), 1U);
  EXPECT_EQ(count(drawn, ">stall<"), 1U);  // one row of the legend
  EXPECT_EQ(count(drawn, ">top<"), 1U);
}

TEST(Svg, AValueThatIsNotFiniteInterruptsALine) {
  Plot plot;
  plot.series = {{"a", {{0, 0}, {1, 1}, {2, kNan}, {3, 1}, {4, 0}}}};
  EXPECT_EQ(count(svg(plot), "<polyline"), 2U);
}

TEST(Svg, StepsHoldTheirValue) {
  Plot plot;
  plot.x = {"", 0, 1};
  plot.y = {"", 0, 1};
  plot.series = {{"", {{0, 0}, {1, 1}}, Mark::steps}};
  // Along the bottom to the end, then up.
  EXPECT_THAT(svg(plot), HasSubstr("84.00,428.00 84.00,428.00 770.00,428.00 770.00,40.00 "));
}

TEST(Svg, AMillionPointsKeepTheirPeaks) {
  Plot plot;
  Series series{"long", {}};
  for (int i = 0; i < 1'000'000; ++i) series.points.push_back({static_cast<double>(i), i == 777'777 ? 5.0 : 0.0});
  plot.series = {series};
  plot.y = {"", 0, 5};
  const std::string drawn = svg(plot);
  EXPECT_LT(drawn.size(), 100'000U);
  EXPECT_THAT(drawn, HasSubstr(",40.00 "));  // the peak
}

TEST(Svg, AMapMergesCellsOfOneShade) {
  Plot plot;
  plot.map = Map{"height", 0, 4, 0, 2, 4, 2, {1, 1, 1, 2, kNan, 1, 1, 1}};
  const std::string drawn = svg(plot);
  const std::string low = "fill=\"#262054\"";
  EXPECT_EQ(count(drawn, low), 3U);  // one run a row, and one step of the scale
  plot.map->values.pop_back();
  EXPECT_EQ(count(svg(plot), low), 0U);
}

}  // namespace
}  // namespace dripfeed::plot
