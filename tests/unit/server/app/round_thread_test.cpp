// Rounds on a thread of their own: woken, waited for, stopped, and not ended by what a round throws; and the measure of
// what threads that serve lines wait for a lock.
#include "server/app/base/round_thread.h"

#include <atomic>
#include <stdexcept>

#include <gtest/gtest.h>

namespace dripfeed::app {
namespace {

using namespace std::chrono_literals;

constexpr auto kNever = std::chrono::milliseconds(std::chrono::hours(1));

TEST(RoundThread, SettleWaitsForARoundThatBeganAfterIt) {
  std::atomic<int> value = 0;
  std::atomic<int> seen = 0;
  RoundThread thread("test", kNever, Urgency::usual, [&] { seen = value.load(); });
  for (int i = 1; i <= 100; ++i) {
    value = i;
    ASSERT_TRUE(thread.wait_for_round(10s));
    ASSERT_EQ(seen, i);
  }
}

TEST(RoundThread, WhoeverSettlesWaitsNoLongerThanStated) {
  std::atomic<bool> go = false;
  RoundThread thread("test", kNever, Urgency::usual, [&] { go.wait(false); });
  EXPECT_FALSE(thread.wait_for_round(20ms)) << "the round hangs, as on a disk that does not answer";
  go = true;
  go.notify_all();
  EXPECT_TRUE(thread.wait_for_round(10s));
}

TEST(RoundThread, WhatARoundThrowsEndsThatRoundOnly) {
  std::atomic<int> rounds = 0;
  RoundThread thread("test", kNever, Urgency::usual, [&] {
    if (++rounds % 2 == 1) throw std::bad_alloc();
  });
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(thread.wait_for_round(10s));
  EXPECT_GE(rounds, 10);
}

TEST(RoundThread, StopMakesOneLastRound) {
  std::atomic<int> left = 1;
  RoundThread thread("test", kNever, Urgency::usual, [&] { left = 0; });
  ASSERT_TRUE(thread.wait_for_round(10s));
  left = 1;
  thread.stop();
  EXPECT_EQ(left, 0);
  EXPECT_FALSE(thread.wait_for_round(10ms)) << "there are no rounds any more";
}

// Holds the mutex for a while, on another thread, and takes it here as a thread that serves lines.
void wait_for(LineMutex& mutex, std::chrono::milliseconds held) {
  std::atomic<bool> is_held = false;
  std::thread holder([&] {
    const std::lock_guard lock(mutex);
    is_held = true;
    is_held.notify_all();
    std::this_thread::sleep_for(held);
  });
  is_held.wait(false);
  std::thread line([&] {
    LineWaits::serve_lines_here();
    const std::lock_guard lock(mutex);
  });
  line.join();
  holder.join();
}

TEST(LineMutex, MeasuresWhatALineWaited) {
  LineMutex mutex("a test");
  wait_for(mutex, 30ms);
  EXPECT_GE(LineWaits::longest(), 20ms);
}

TEST(LineMutexDeathTest, EndsTheProcessByNameWhereALimitIsSet) {
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  ::setenv("DRIPFEED_LOCK_LIMIT_MS", "5", 1);
  LineMutex mutex("a lock over slow work");
  EXPECT_DEATH(wait_for(mutex, 100ms), "waited .* us for the lock of a lock over slow work");
  ::unsetenv("DRIPFEED_LOCK_LIMIT_MS");
}

}  // namespace
}  // namespace dripfeed::app
