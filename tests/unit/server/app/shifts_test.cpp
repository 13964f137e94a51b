// Shifts of a shop in Berlin, where a night of March has seven hours of a shift and one of October nine.
#include "server/app/jobs/shifts.h"

#include <cstdlib>
#include <ctime>

#include <gtest/gtest.h>

namespace dripfeed::app {
namespace {

constexpr std::int64_t kHour_ms = 3600 * 1000;
constexpr std::int64_t kOctober_ms = 1'729'893'600'000;  // 2024-10-26 00:00
constexpr std::int64_t kMarch_ms = 1'711'753'200'000;    // 2024-03-30 00:00

class ShiftsTest : public ::testing::Test {
 protected:
  ShiftsTest() {
    ::setenv("TZ", "Europe/Berlin", 1);
    ::tzset();
  }
  ~ShiftsTest() override {
    ::unsetenv("TZ");
    ::tzset();
  }
};

TEST_F(ShiftsTest, TheNightBelongsToTheDayOnWhichItBegan) {
  const Shifts shifts;
  const LocalTime early = shifts.shift_of(kOctober_ms + 6 * kHour_ms);
  EXPECT_EQ(early.name, "2024-10-26 06:00");
  EXPECT_EQ(early.from_ms, kOctober_ms + 6 * kHour_ms);
  EXPECT_EQ(early.to_ms, kOctober_ms + 14 * kHour_ms);
  EXPECT_EQ(shifts.shift_of(early.to_ms - 1).name, early.name);
  EXPECT_EQ(shifts.shift_of(early.to_ms).name, "2024-10-26 14:00");
  EXPECT_EQ(shifts.shift_of(kOctober_ms + 5 * kHour_ms).name, "2024-10-25 22:00");
}

TEST_F(ShiftsTest, TheClockThatIsChangedMakesOneLongerOrShorter) {
  const Shifts shifts;
  const LocalTime autumn = shifts.shift_of(kOctober_ms + 26 * kHour_ms);
  EXPECT_EQ(autumn.name, "2024-10-26 22:00");
  EXPECT_EQ(autumn.to_ms - autumn.from_ms, 9 * kHour_ms);
  EXPECT_EQ(shifts.shift_of(autumn.to_ms).name, "2024-10-27 06:00");
  const LocalTime spring = shifts.shift_of(kMarch_ms + 26 * kHour_ms);
  EXPECT_EQ(spring.name, "2024-03-30 22:00");
  EXPECT_EQ(spring.to_ms - spring.from_ms, 7 * kHour_ms);
}

TEST_F(ShiftsTest, OneBeginIsADayAndMidnightIsOne) {
  const auto one = Shifts::of(std::vector<std::string>{"00:00"});
  ASSERT_TRUE(one);
  const LocalTime shift = one->shift_of(kOctober_ms + 3 * kHour_ms);
  EXPECT_EQ(shift.name, "2024-10-26 00:00");
  EXPECT_EQ(shift.to_ms, day_of(kOctober_ms).to_ms);
  const auto two = Shifts::of(std::vector<std::string>{"18:30", "06:30"});
  ASSERT_TRUE(two);
  EXPECT_EQ(two->shift_of(kOctober_ms + 20 * kHour_ms).name, "2024-10-26 18:30");
}

TEST_F(ShiftsTest, WhatIsNoTimeOfDayIsRefused) {
  for (const char* const wrong : {"6:00", "24:00", "06:60", "06.00", "0600", "", "-1:00", "+6:00"})
    EXPECT_FALSE(Shifts::of(std::vector<std::string>{wrong})) << wrong;
  const auto twice = Shifts::of(std::vector<std::string>{"06:00", "06:00"});
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error(), "two shifts begin at the same time");
}

TEST_F(ShiftsTest, EachDayFollowsTheOneBefore) {
  std::int64_t at_ms = kOctober_ms;
  for (int i = 0; i < 5; ++i) {
    const LocalTime day = day_of(at_ms);
    EXPECT_EQ(day.from_ms, at_ms);
    EXPECT_EQ(day.to_ms - day.from_ms, (i == 1 ? 25 : 24) * kHour_ms) << i;
    at_ms = day.to_ms;
  }
}

}  // namespace
}  // namespace dripfeed::app
