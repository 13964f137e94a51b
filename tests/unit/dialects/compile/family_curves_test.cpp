// Curves by their parameter: their points against the closed form, in all dialects and both forms.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/family_run.h"

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

}  // namespace
}  // namespace dripfeed::compile::test
