// The table of event types against everything that the store and the lines can say: no event goes out that has no row.
#include "server/app/out/event_types.h"

#include <array>
#include <set>

#include <gtest/gtest.h>

#include "server/app/base/wall_time.h"
#include "server/app/out/line_events.h"
#include "tests/unit/server/app/whole_shop.h"

namespace dripfeed::app::test {
namespace {

using store::EventTopic;

template <class Words>
void add_all(std::set<std::string>& all, EventTopic topic, const Words& words) {
  for (const std::string_view word : words) all.insert(store::type_of({.topic = topic, .word = std::string(word)}));
}

TEST(EventTypes, AreAllThatCanHappenAndNoMore) {
  std::set<std::string> possible;
  add_all(possible, EventTopic::release, store::kNames<store::ReleaseState>);
  add_all(possible, EventTopic::receipt, store::kNames<store::ReceiptState>);
  add_all(possible, EventTopic::alarm, store::kAlarmEvents);
  add_all(possible, EventTopic::program, store::kProgramEvents);
  add_all(possible, EventTopic::order, store::kNames<store::OrderState>);
  add_all(possible, EventTopic::order, store::kOrderEvents);
  add_all(possible, EventTopic::job, store::kJobEvents);
  add_all(possible, EventTopic::release, std::array{store::kReleaseSignedOff});
  possible.insert("webhook.ping");
  for (std::size_t i = 0; i <= static_cast<std::size_t>(LineState::answering); ++i)
    possible.insert("line." + std::string(name_of(static_cast<LineState>(i))));
  // A job's move that is not in the audit is not an event.
  possible.insert("job.queued");
  for (const store::JobTransition& move : store::job_transitions())
    if (move.audited) possible.insert("job." + std::string(store::name_of(move.to)));
  std::set<std::string> known;
  for (const EventType& type : event_types()) {
    EXPECT_TRUE(known.insert(std::string(type.name)).second) << type.name;
    EXPECT_FALSE(type.when.empty() || type.schema.empty()) << type.name;
  }
  EXPECT_EQ(known, possible);
}

TEST(EventTypes, APatternCoversAtLeastOne) {
  for (const char* const good : {"*", "job.*", "job.done", "line.torn"}) EXPECT_TRUE(covers_a_type(good)) << good;
  for (const char* const bad : {"", "job", "jo*", "jobs.*", "job.held", "*.done", "job."})
    EXPECT_FALSE(covers_a_type(bad)) << bad;
}

TEST(WallTime, IsAsRfc3339HasIt) {
  EXPECT_EQ(rfc3339(0), "1970-01-01T00:00:00.000Z");
  EXPECT_EQ(rfc3339(1'709'210'096'789), "2024-02-29T12:34:56.789Z");
}

class LineEventsTest : public ::testing::Test {
 protected:
  LineEventsTest()
      : store_(must(sqlite::open(folder_.file("d.db")))),
        line_(*store_, events_, clock_, [this](std::string_view) { return is_ours_; }) {
    must(store_->machines().add("mill", "mill", by("anna")));
  }
  // The line has this state for so long; the server looks every 200 ms.
  void stands(LineState state, std::chrono::milliseconds span) {
    LineReport report;
    report.state = state;
    report.changes = ++changes_;
    events_.progress("mill", report);
    for (auto left = span; left.count() > 0; left -= std::chrono::milliseconds(200)) {
      line_.look();
      clock_.set(clock_.now() + std::chrono::milliseconds(200));
    }
  }
  std::vector<std::string> published() {
    std::vector<std::string> all;
    for (const auto& event : must(store_->event_log().after(0, 100))) all.push_back(event.of.word);
    return all;
  }

  dripfeed::test::TempFolder folder_;
  std::unique_ptr<store::Store> store_;
  dripfeed::test::VirtualClock clock_;
  Events events_;
  bool is_ours_ = true;
  LineEvents line_;
  std::uint64_t changes_ = 0;
};

TEST_F(LineEventsTest, ALineOfAnotherServerIsReportedByThatOne) {
  stands(LineState::idle, 1200ms);
  is_ours_ = false;
  stands(LineState::disconnected, 2000ms);
  is_ours_ = true;
  stands(LineState::idle, 1200ms);
  EXPECT_EQ(published(), (std::vector<std::string>{"idle", "idle"}));
}

TEST_F(LineEventsTest, AStateThatStandsIsReportedOnce) {
  using std::chrono::milliseconds;
  stands(LineState::idle, milliseconds(3000));
  for (int i = 0; i < 5; ++i) {  // holds of a feed
    stands(LineState::feeding, milliseconds(400));
    stands(LineState::held, milliseconds(400));
  }
  EXPECT_EQ(published(), (std::vector<std::string>{"idle"}));
  stands(LineState::feeding, milliseconds(2000));
  stands(LineState::held, milliseconds(400));
  stands(LineState::feeding, milliseconds(2000));
  EXPECT_EQ(published(), (std::vector<std::string>{"idle", "feeding"})) << "a short hold is no news, nor is its end";
  stands(LineState::torn, milliseconds(1400));
  EXPECT_EQ(published().back(), "torn");
}

}  // namespace
}  // namespace dripfeed::app::test
