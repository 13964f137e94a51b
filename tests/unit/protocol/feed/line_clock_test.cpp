// Line time and credit, on a line whose character takes 1 ms.
#include "protocol/feed/line_clock.h"

#include <gtest/gtest.h>

namespace dripfeed::feed {
namespace {

using namespace std::chrono_literals;

// A character takes 1 ms, 4 may be unsent, latency 2 characters.
LineClock clock_of_milliseconds() { return LineClock(1ms, 4, 2); }

TEST(LineClock, RefillsWhenHalfIsLeft) {
  LineClock clock = clock_of_milliseconds();
  EXPECT_EQ(clock.credit(100ms), 4U);
  clock.handed(4, 100ms);
  EXPECT_EQ(clock.credit(100ms), 0U);
  EXPECT_EQ(clock.credit(101ms), 0U);
  EXPECT_EQ(clock.refill_at(), 102ms);
  EXPECT_EQ(clock.credit(102ms), 2U);
  EXPECT_EQ(clock.credit(102ms + 1us), 2U);  // a character that is half out counts as unsent
  EXPECT_EQ(clock.credit(104ms), 4U);
}

// What is written at a time is as much as the line can go without: a wake and a write cost the same for 1 or for 200.
TEST(LineClock, RefillsLateWhereMuchMayBeUnsent) {
  EXPECT_EQ(LineClock::left_at_refill(1ms, 8), 2U);
  EXPECT_EQ(LineClock::left_at_refill(1146us, 5), 2U);
  EXPECT_EQ(LineClock::left_at_refill(1146us, 3), 1U);  // never more than half
  EXPECT_EQ(LineClock::left_at_refill(87us, 200), 23U);
  EXPECT_EQ(LineClock::left_at_refill(10ms, 8), 1U);
  EXPECT_EQ(LineClock::left_at_refill(1ms, 1), 0U);
  LineClock clock(1ms, 8, 0);
  clock.handed(8, 100ms);
  EXPECT_EQ(clock.refill_at(), 106ms);
  EXPECT_EQ(clock.credit(105ms), 0U);
  EXPECT_EQ(clock.credit(106ms), 6U);
}

TEST(LineClock, AShortWriteKeepsTheRestOfItsCredit) {
  LineClock clock = clock_of_milliseconds();
  EXPECT_EQ(clock.credit(100ms), 4U);
  clock.handed(3, 100ms);
  EXPECT_EQ(clock.credit(100ms), 1U);
  EXPECT_EQ(clock.credit(100500us), 1U);
}

TEST(LineClock, LineTimeDoesNotDriftWithLateTicks) {
  LineClock clock = clock_of_milliseconds();
  clock.handed(4, 0ms);
  for (int i = 1; i <= 1000; ++i) clock.handed(2, Time(2ms * i + 300us));  // each refill 0.3 ms late
  EXPECT_EQ(clock.drained_at(), 2004ms + 2ms);
}

TEST(LineClock, ClocksWithTheLatencyAndNeverBack) {
  LineClock clock = clock_of_milliseconds();
  clock.handed(4, 100ms);
  EXPECT_EQ(clock.clocked(100ms), 0U);
  EXPECT_EQ(clock.clocked(102ms), 0U);
  EXPECT_EQ(clock.clocked(103ms), 1U);
  EXPECT_EQ(clock.clocked(105ms), 3U);
  clock.queue_reported(4, 105ms);
  EXPECT_EQ(clock.clocked(105ms), 3U);
  EXPECT_FALSE(clock.is_drained(106ms));
  EXPECT_EQ(clock.clocked(111ms), 4U);
  EXPECT_TRUE(clock.is_drained(111ms));
}

TEST(LineClock, AReportedQueueOnlySlows) {
  LineClock clock = clock_of_milliseconds();
  clock.handed(4, 100ms);
  clock.queue_reported(0, 101ms);  // a pty always says so
  EXPECT_EQ(clock.credit(101ms), 0U);
  clock.queue_reported(4, 102ms);
  EXPECT_EQ(clock.credit(102ms), 0U);
  EXPECT_EQ(clock.credit(104ms), 2U);
  clock.queue_reported(UINT64_MAX, 104ms);
  EXPECT_EQ(clock.credit(200ms), 0U);
}

TEST(LineClock, StandsStillWhilePaused) {
  LineClock clock = clock_of_milliseconds();
  clock.handed(4, 100ms);
  clock.pause(101ms);
  EXPECT_EQ(clock.credit(900ms), 0U);
  EXPECT_FALSE(clock.is_drained(900ms));
  EXPECT_EQ(clock.clocked(900ms), 0U);
  clock.pause(950ms);
  clock.go_on(1000ms);
  EXPECT_EQ(clock.drained_at(), 1005ms);
  clock.pause(2000ms);
  clock.go_on(3000ms);
  EXPECT_TRUE(clock.is_drained(3000ms));
}

TEST(LineClock, ANewJobCountsFromNothingAfterWhatIsStillOnTheLine) {
  LineClock clock = clock_of_milliseconds();
  clock.handed(4, 100ms);
  clock.restart();
  EXPECT_EQ(clock.handed(), 0U);
  EXPECT_EQ(clock.credit(101ms), 0U);
  clock.handed(1, 103ms);
  EXPECT_EQ(clock.clocked(106ms), 0U);
  EXPECT_EQ(clock.clocked(107ms), 1U);
}

}  // namespace
}  // namespace dripfeed::feed
