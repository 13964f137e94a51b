// What may be read from a link: a burst, then a rate; and who counts as one that floods.
#include "server/io/read_allowance.h"

#include <gtest/gtest.h>

namespace dripfeed::io {
namespace {

using namespace std::chrono_literals;

constexpr feed::Time kBegin = 100s;

// Takes all that is left every 5 ms; how much came.
std::int64_t drain(ReadAllowance& allowance, feed::Time from, feed::Time until) {
  std::int64_t read = 0;
  for (feed::Time now = from; now < until; now += 5ms) {
    const std::int64_t left = allowance.left(now);
    read += left;
    if (left > 0) allowance.took(static_cast<std::size_t>(left), now);
  }
  return read;
}

TEST(ReadAllowance, ABurstAndThenARate) {
  ReadAllowance allowance;
  EXPECT_EQ(allowance.left(kBegin), kReadsAtOnce_bytes);
  const std::int64_t read = drain(allowance, kBegin, kBegin + 1s);
  EXPECT_LE(read, kReadsAtOnce_bytes + kReadsPerSecond_bytes);
  EXPECT_GE(read, kReadsAtOnce_bytes + kReadsPerSecond_bytes * 95 / 100);
  EXPECT_EQ(allowance.left(kBegin + 1h), kReadsAtOnce_bytes) << "what was not used is not saved up";
}

TEST(ReadAllowance, WhoReadsTooMuchPaysItBack) {
  ReadAllowance allowance;
  allowance.took(kReadsAtOnce_bytes + 4096, kBegin);
  EXPECT_EQ(allowance.left(kBegin + 1ms), 0);
  EXPECT_GT(allowance.left(kBegin + 20ms), 0);
  EXPECT_TRUE(allowance.pressed(kBegin + 20ms));
  EXPECT_FALSE(allowance.pressed(kBegin + 600ms));
}

TEST(ReadAllowance, AFloodIsNamedAndForgottenLater) {
  ReadAllowance allowance;
  drain(allowance, kBegin, kBegin + 900ms);
  EXPECT_FALSE(allowance.flooded(kBegin + 900ms)) << "a network may have held that back";
  drain(allowance, kBegin + 900ms, kBegin + 1500ms);
  EXPECT_TRUE(allowance.flooded(kBegin + 1500ms));
  EXPECT_FALSE(allowance.flooded(kBegin + 15s));
}

TEST(ReadAllowance, TheFastestSerialLineIsNoFlood) {
  ReadAllowance allowance;
  for (feed::Time now = kBegin; now < kBegin + 10s; now += 10ms) {
    ASSERT_GT(allowance.left(now), 922);  // 921,600 baud
    allowance.took(922, now);
    ASSERT_FALSE(allowance.flooded(now));
  }
}

}  // namespace
}  // namespace dripfeed::io
