// What a PLC reads of a line, word by word, and what it cannot read.
#include "server/app/out/status_registers.h"

#include <array>
#include <chrono>
#include <string>

#include <gtest/gtest.h>

namespace dripfeed::app {
namespace {

class FixedClock final : public Clock {
 public:
  [[nodiscard]] feed::Time now() const override { return std::chrono::seconds(65'536 + 42); }
  [[nodiscard]] std::int64_t wall_ms() const override { return 1; }
};

using Registers = std::array<std::uint16_t, StatusRegisters::kCount>;

TEST(StatusRegisters, ShowTheNewestReportOfTheMachine) {
  Events events;
  const FixedClock clock;
  StatusRegisters registers(events, clock, {{3, "lathe"}, {4, "mill-2"}});
  LineReport report;
  report.state = LineState::held;
  report.end = JobEnd::failed;
  report.stall = "held by DC3";
  report.job = 0x12345;
  report.total = 100'000;
  report.handed = 70'000;
  report.clocked = 69'999;
  report.confirmed = 1;
  report.known.from_line = 12;
  report.known.to_line = 0x10002;
  report.confirms = true;
  report.stop_wanted = true;
  report.changes = 1;
  events.progress("lathe", report);
  Registers all{};
  ASSERT_TRUE(registers.read(3, 0, all));
  EXPECT_EQ((std::array{all[0], all[1], all[2]}), (std::array<std::uint16_t, 3>{0xDF02, 1, 42}));
  EXPECT_EQ((std::array{all[3], all[4], all[5]}), (std::array<std::uint16_t, 3>{4, 2, 2}));
  const auto both = [&](std::size_t at) { return std::uint32_t{all[at]} << 16U | all[at + 1]; };
  EXPECT_EQ(both(6), 0x12345U);
  EXPECT_EQ(both(8), 100'000U);
  EXPECT_EQ(both(10), 70'000U);
  EXPECT_EQ(both(12), 69'999U);
  EXPECT_EQ(both(14), 1U);
  EXPECT_EQ(both(16), 12U);
  EXPECT_EQ(both(18), 0x10002U);
  EXPECT_EQ(all[20], 1U | 4U);
  EXPECT_EQ(all[21], 'l' * 256 + 'a');
  EXPECT_EQ(all[23], 'e' * 256);
  EXPECT_EQ(all[24], 0);

  report.stall = "a stall of another kind";
  report.total = std::uint64_t{1} << 40U;
  report.link_error = "gone";
  ++report.changes;
  events.progress("lathe", report);
  ASSERT_TRUE(registers.read(3, 0, all));
  EXPECT_EQ(all[4], 255);
  EXPECT_EQ(both(8), UINT32_MAX);
  EXPECT_EQ(all[20], 1U | 4U | 8U);
}

TEST(StatusRegisters, AMachineWithoutALineSaysSo) {
  Events events;
  const FixedClock clock;
  StatusRegisters registers(events, clock, {{4, "mill-2"}});
  std::array<std::uint16_t, 2> some{};
  ASSERT_TRUE(registers.read(4, 3, some));
  EXPECT_EQ(some[0], 0xFFFF);
  EXPECT_EQ(some[1], 0);
}

TEST(StatusRegisters, NothingElseCanBeRead) {
  Events events;
  const FixedClock clock;
  StatusRegisters registers(events, clock, {{4, "mill-2"}});
  EXPECT_TRUE(registers.has_unit(4));
  EXPECT_FALSE(registers.has_unit(0));
  EXPECT_FALSE(registers.has_unit(255));
  std::array<std::uint16_t, 1> one{};
  EXPECT_TRUE(registers.read(4, StatusRegisters::kCount - 1, one));
  EXPECT_FALSE(registers.read(4, StatusRegisters::kCount, one));
  EXPECT_FALSE(registers.read(4, 65535, one));
  EXPECT_FALSE(registers.read(5, 0, one));
}

}  // namespace
}  // namespace dripfeed::app
