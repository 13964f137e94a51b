// Live events as a stream: framing, resuming, a reset where the ring is too short, and progress that comes in its
// newest form at most five times a second.
#include "server/http/live.h"

#include <atomic>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace dripfeed::http {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::Not;

app::Event receipt(std::string text) {
  return {.id = 0,
          .kind = app::EventKind::receipt,
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

// A hub that rounds when the test says so as well; the newest report of the events stands in for the application.
class LiveTest : public ::testing::Test {
 protected:
  std::shared_ptr<EventSubscription> watch(std::uint64_t after, const std::string& token = "token") {
    auto watcher = hub_.watch(after, {.owner = token, .session = {}});
    EXPECT_TRUE(watcher) << watcher.error();
    return watcher ? *watcher : nullptr;
  }
  std::string take(EventSubscription& watcher) {
    hub_.round();
    return watcher.take();
  }
  app::MachineStatus describe(const std::string& machine) {
    ++described_;
    app::MachineStatus status;
    for (const app::Progress& progress : events_.snapshot()) {
      if (progress.machine == machine) status.report = progress.report;
    }
    status.program = "O0042";
    status.block_text = "G01X1.";
    return status;
  }

  app::Events events_;
  std::atomic<int> described_ = 0;
  std::atomic<bool> valid_ = true;
  LiveHub hub_{events_, [this](const std::string& machine) { return describe(machine); },
               [this](const Credential& credential) { return credential.owner != "short" || valid_; }};
};

template <class Condition>
bool soon(const Condition& condition) {
  const auto until = std::chrono::steady_clock::now() + 10s;
  while (std::chrono::steady_clock::now() < until) {
    if (condition()) return true;
    std::this_thread::sleep_for(5ms);
  }
  return false;
}

TEST_F(LiveTest, EventsAreFramedWithTheirIds) {
  const auto watcher = watch(0);
  EXPECT_EQ(take(*watcher), "");
  events_.publish(receipt("one\ntwo"));
  events_.publish(receipt("three"));
  EXPECT_EQ(take(*watcher),
            "id: 1\nevent: receipt\ndata: {\"machine\":\"mill\",\"text\":\"one\\ntwo\"}\n\n"
            "id: 2\nevent: receipt\ndata: {\"machine\":\"mill\",\"text\":\"three\"}\n\n");
  EXPECT_EQ(take(*watcher), "");
  EXPECT_THAT(take(*watch(1)), HasSubstr("three"));
  EXPECT_THAT(take(*watch(1)), Not(HasSubstr("one")));
}

TEST_F(LiveTest, AWatcherWhoLagsTheRingIsReset) {
  const auto watcher = watch(0);
  EXPECT_EQ(take(*watcher), "");
  for (std::size_t i = 0; i <= app::Events::kRing; ++i) events_.publish(receipt("x"));
  EXPECT_EQ(take(*watcher), "id: 1025\nevent: reset\ndata: {}\n\n");
  events_.publish(receipt("news"));
  EXPECT_THAT(take(*watcher), HasSubstr("id: 1026\nevent: receipt"));
  EXPECT_THAT(take(*watch(5000)), HasSubstr("event: reset")) << "an id of another server";
}

TEST_F(LiveTest, AllWhoWatchGetAllOnce) {
  std::vector<std::shared_ptr<EventSubscription>> watchers;
  std::vector<std::string> got(20);
  for (std::size_t i = 0; i < got.size(); ++i) watchers.push_back(watch(0, std::to_string(i)));
  for (int n = 0; n < 3000; ++n) {
    events_.publish(receipt(std::to_string(n)));
    if (n % 100 == 0) hub_.round();
    for (std::size_t i = 0; i < got.size(); ++i) {
      if (n % (static_cast<int>(i) + 1) == 0) got[i] += watchers[i]->take();
    }
  }
  for (std::size_t i = 0; i < got.size(); ++i) {
    got[i] += take(*watchers[i]);
    std::size_t at = 0;
    for (int n = 1; n <= 3000; ++n) {
      at = got[i].find("id: " + std::to_string(n) + "\n", at);
      ASSERT_NE(at, std::string::npos) << "watcher " << i << " missed event " << n;
    }
    EXPECT_EQ(got[i].find("id: 3000\n"), got[i].rfind("id: 3000\n")) << "twice";
    EXPECT_EQ(got[i].find("reset"), std::string::npos);
  }
}

TEST_F(LiveTest, ProgressIsHeldBackAndComesInItsNewestForm) {
  const auto watcher = watch(0);
  events_.progress("mill", handed(1));
  std::string begin;
  ASSERT_TRUE(soon([&] { return !(begin += take(*watcher)).empty(); }));
  const auto first = std::chrono::steady_clock::now();
  EXPECT_THAT(begin, HasSubstr("event: progress\ndata: {\"machine\":\"mill\""));
  EXPECT_THAT(begin, HasSubstr("\"program\":\"O0042\",\"block_text\":\"G01X1.\"}"));
  std::string later;
  int pieces = 0;
  for (std::uint64_t bytes = 2; std::chrono::steady_clock::now() - first < 700ms; ++bytes) {
    events_.progress("mill", handed(bytes));
    const std::string piece = take(*watcher);
    if (!piece.empty()) {
      ++pieces;
      later = piece;
    }
    std::this_thread::sleep_for(5ms);
  }
  EXPECT_GE(pieces, 1);
  EXPECT_LE(pieces, 4) << "five a second";
  EXPECT_EQ(later.find("event: progress"), later.rfind("event: progress")) << "one piece a machine";
  events_.progress("mill", handed(999'999));
  ASSERT_TRUE(soon([&] { return (later = take(*watcher)).find("\"handed\":999999") != std::string::npos; }));
  std::this_thread::sleep_for(250ms);
  EXPECT_EQ(take(*watcher), "") << "nothing changed";
}

TEST_F(LiveTest, ProgressIsDescribedOnceForAllWhoWatch) {
  std::vector<std::shared_ptr<EventSubscription>> watchers;
  for (std::size_t i = 0; i < LiveHub::kMostOfOne; ++i) watchers.push_back(watch(0));
  events_.progress("mill", handed(1));
  for (const auto& watcher : watchers) {
    std::string got;
    ASSERT_TRUE(soon([&] { return !(got += take(*watcher)).empty(); }));
    EXPECT_THAT(got, HasSubstr("\"handed\":1"));
  }
  EXPECT_EQ(described_, 1);
}

TEST_F(LiveTest, ReportsWhenThereIsMoreUntilItIsReported) {
  std::atomic<int> ready = 0;
  const auto watcher = watch(0);
  watcher->on_ready([&] { ++ready; });
  events_.publish(receipt(""));
  EXPECT_TRUE(soon([&] { return ready >= 1; }));
  watcher->on_ready([&] { ready = 1000; });
  events_.publish(receipt(""));
  EXPECT_TRUE(soon([&] { return ready == 1000; })) << "the one before is let go";
  watcher->on_ready({});
  ready = 0;
  events_.publish(receipt(""));
  hub_.round();
  EXPECT_EQ(ready, 0);
}

TEST_F(LiveTest, ATokenThatIsRevokedEndsItsWatchersAlone) {
  std::atomic<int> woken = 0;
  const auto ends = watch(0, "short");
  const auto stays = watch(0);
  ends->on_ready([&] { ++woken; });
  EXPECT_FALSE(ends->ended());
  valid_ = false;
  EXPECT_TRUE(soon([&] { return ends->ended() && woken > 0; }));
  EXPECT_FALSE(stays->ended());
}

TEST_F(LiveTest, WatchersAreLimitedByTokenAndInAll) {
  std::vector<std::shared_ptr<EventSubscription>> watchers;
  for (std::size_t i = 0; i < LiveHub::kMostOfOne; ++i) watchers.push_back(watch(0, "first"));
  EXPECT_FALSE(hub_.watch(0, {.owner = "first", .session = {}}));
  watchers.pop_back();
  watchers.push_back(watch(0, "first"));
  while (watchers.size() < LiveHub::kMost) watchers.push_back(watch(0, std::to_string(watchers.size())));
  EXPECT_FALSE(hub_.watch(0, {.owner = "new", .session = {}}));
  watchers.clear();
  EXPECT_TRUE(hub_.watch(0, {.owner = "first", .session = {}}));
}

}  // namespace
}  // namespace dripfeed::http
