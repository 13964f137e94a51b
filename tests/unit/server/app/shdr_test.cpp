// The lines that an agent of MTConnect gets.
#include "server/app/out/shdr.h"

#include <vector>

#include <gtest/gtest.h>

namespace dripfeed::app {
namespace {

class StillClock final : public Clock {
 public:
  [[nodiscard]] feed::Time now() const override { return {}; }
  [[nodiscard]] std::int64_t wall_ms() const override { return 5; }
};

Observation seen(DataItem item, Observed observed, std::int64_t at_ms = 1'795'500'000'123) {
  return {.sequence = 1, .at_ms = at_ms, .machine = "lathe-1", .item = item, .observed = std::move(observed)};
}

TEST(Shdr, AnEventAMessageAndAConditionHaveTheirFields) {
  const std::vector<Observation> all{seen(DataItem::execution, {.value = "ACTIVE"}),
                                     seen(DataItem::line_state, {.value = "held, held by DC3"}),
                                     seen(DataItem::system, {.value = "Normal"}), seen(DataItem::mode, {})};
  EXPECT_EQ(ShdrText().lines(all),
            "2026-11-24T06:00:00.123Z|m_lathe_2D1_exec|ACTIVE\n"
            "2026-11-24T06:00:00.123Z|m_lathe_2D1_dnc||held, held by DC3\n"
            "2026-11-24T06:00:00.123Z|m_lathe_2D1_sys|NORMAL||||\n"
            "2026-11-24T06:00:00.123Z|m_lathe_2D1_mode|UNAVAILABLE\n");
}

TEST(Shdr, AFaultWithAnotherNumberEndsTheOneBefore) {
  ShdrText text;
  const auto lines = [&](Observed observed) {
    std::string all;
    for (const char c : text.lines(std::vector{seen(DataItem::system, std::move(observed), 0)})) all += c;
    return all;
  };
  const std::string key = "1970-01-01T00:00:00.000Z|m_lathe_2D1_sys|";
  EXPECT_EQ(lines({.value = "Fault", .text = "servo", .code = "417"}), key + "FAULT|417|||servo\n");
  EXPECT_EQ(lines({.value = "Fault", .text = "servo X", .code = "417"}), key + "FAULT|417|||servo X\n");
  EXPECT_EQ(lines({.value = "Fault", .text = "spindle", .code = "9001"}),
            key + "NORMAL|417|||\n" + key + "FAULT|9001|||spindle\n");
  EXPECT_EQ(lines({.value = "Normal"}), key + "NORMAL||||\n") << "all faults are over";
  EXPECT_EQ(lines({.value = "Warning", .text = "oil", .code = "1"}), key + "WARNING|1|||oil\n");
  EXPECT_EQ(lines({}), key + "UNAVAILABLE||||\n");
}

TEST(Shdr, NoTextLooksLikeAMarkOrALine) {
  const std::string line =
      ShdrText().lines(std::vector{seen(DataItem::system, {.value = "Fault", .text = "a|b\nc", .code = "1|2"}, 0)});
  EXPECT_EQ(line, "1970-01-01T00:00:00.000Z|m_lathe_2D1_sys|FAULT|1 2|||a b c\n");
}

TEST(Shdr, OnlyAPingIsAnswered) {
  const StillClock clock;
  const Observations none(clock, [] { return std::map<std::string, LineReport>(); });
  ShdrFeed feed(none);
  EXPECT_EQ(feed.answer("* PING\r\n"), "* PONG 10000\n");
  for (const char* const other : {"", "\n", "* device: x\n", "2026|m_exec|ACTIVE\n", "PING\n"})
    EXPECT_EQ(feed.answer(other), "") << other;
}

}  // namespace
}  // namespace dripfeed::app
