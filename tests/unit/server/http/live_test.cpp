// Live events as a stream: framing, resuming, a reset where the ring is too short, and progress that comes in its
// newest form at most five times a second.
#include "server/http/live.h"

#include <chrono>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace dripfeed::http {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::Not;

app::Event alarm(std::string text) {
  return {.id = 0,
          .kind = app::EventKind::alarm,
          .machine = "mill",
          .job = {},
          .verdict = 0,
          .outcome = {},
          .text = std::move(text)};
}

app::LineReport handed(std::uint64_t bytes) {
  app::LineReport report;
  report.handed = bytes;
  return report;
}

// The newest report of the events stands in for the application.
std::shared_ptr<EventSubscription> watch(app::Events& events, std::uint64_t after) {
  return watch_events(events, after, [&events](const std::string& machine) {
    app::MachineStatus status;
    for (const app::Progress& progress : events.snapshot()) {
      if (progress.machine == machine) status.report = progress.report;
    }
    status.program = "O0042";
    status.block_text = "G01X1.";
    return status;
  });
}

TEST(Live, EventsAreFramedWithTheirIds) {
  app::Events events;
  const auto watcher = watch(events, 0);
  EXPECT_EQ(watcher->take(), "");
  events.publish(alarm("one\ntwo"));
  events.publish(alarm("three"));
  EXPECT_EQ(watcher->take(),
            "id: 1\nevent: alarm\ndata: {\"machine\":\"mill\",\"text\":\"one\\ntwo\"}\n\n"
            "id: 2\nevent: alarm\ndata: {\"machine\":\"mill\",\"text\":\"three\"}\n\n");
  EXPECT_EQ(watcher->take(), "");
  EXPECT_THAT(watch(events, 1)->take(), HasSubstr("three"));
  EXPECT_THAT(watch(events, 1)->take(), Not(HasSubstr("one")));
}

TEST(Live, AWatcherWhoFellBehindTheRingIsReset) {
  app::Events events;
  const auto watcher = watch(events, 0);
  for (std::size_t i = 0; i <= app::Events::kRing; ++i) events.publish(alarm("x"));
  EXPECT_EQ(watcher->take(), "id: 1025\nevent: reset\ndata: {}\n\n");
  events.publish(alarm("news"));
  EXPECT_THAT(watcher->take(), HasSubstr("id: 1026\nevent: alarm"));
  EXPECT_THAT(watch(events, 5000)->take(), HasSubstr("event: reset")) << "an id of another server";
}

TEST(Live, ProgressIsHeldBackAndComesInItsNewestForm) {
  app::Events events;
  const auto watcher = watch(events, 0);
  events.progress("mill", handed(1));
  const auto first = std::chrono::steady_clock::now();
  const std::string begin = watcher->take();
  EXPECT_THAT(begin, HasSubstr("event: progress\ndata: {\"machine\":\"mill\""));
  EXPECT_THAT(begin, HasSubstr("\"program\":\"O0042\",\"block_text\":\"G01X1.\"}"));
  EXPECT_FALSE(watcher->due_after());
  std::string later;
  int pieces = 0;
  for (std::uint64_t bytes = 2; std::chrono::steady_clock::now() - first < 700ms; ++bytes) {
    events.progress("mill", handed(bytes));
    const std::string piece = watcher->take();
    if (!piece.empty()) {
      ++pieces;
      later = piece;
    } else {
      EXPECT_TRUE(watcher->due_after());
    }
    std::this_thread::sleep_for(5ms);
  }
  EXPECT_GE(pieces, 1);
  EXPECT_LE(pieces, 4) << "five a second";
  EXPECT_EQ(later.find("event: progress"), later.rfind("event: progress")) << "one piece a machine";
  std::this_thread::sleep_for(200ms);
  events.progress("mill", handed(999'999));
  EXPECT_THAT(watcher->take(), HasSubstr("\"handed\":999999"));
  std::this_thread::sleep_for(200ms);
  EXPECT_EQ(watcher->take(), "") << "nothing changed";
}

TEST(Live, ProgressDoesNotHoldBackEvents) {
  app::Events events;
  const auto watcher = watch(events, 0);
  events.progress("mill", handed(1));
  EXPECT_NE(watcher->take(), "");
  events.progress("mill", handed(2));
  events.publish(alarm("now"));
  const std::string piece = watcher->take();
  EXPECT_THAT(piece, HasSubstr("now"));
  EXPECT_THAT(piece, Not(HasSubstr("progress")));
}

TEST(Live, TellsWhenThereIsMoreUntilItIsTold) {
  app::Events events;
  int ready = 0;
  const auto watcher = watch(events, 0);
  watcher->on_ready([&] { ++ready; });
  events.publish(alarm(""));
  EXPECT_EQ(ready, 1);
  watcher->on_ready([&] { ready += 10; });
  events.publish(alarm(""));
  EXPECT_EQ(ready, 11) << "the one before is let go";
  watcher->on_ready({});
  events.publish(alarm(""));
  EXPECT_EQ(ready, 11);
  {
    const auto gone = watch(events, 0);
    gone->on_ready([&] { ready = -1; });
  }
  events.publish(alarm(""));
  EXPECT_EQ(ready, 11);
}

}  // namespace
}  // namespace dripfeed::http
