// Answers to operators: booked, ended once, torn by a stop of the server, confirmed by a person; and that a torn one
// keeps jobs off its machine.
#include <functional>
#include <thread>

#include "store/sql/write_lane.h"
#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

using namespace store;

class AnswerTest : public StoreTest {
 protected:
  AnswerTest() { job_ = add_job(*store_, "mill-1"); }
  Answers& answers() { return store_->answers(); }
  Job job_;
};

TEST_F(AnswerTest, AWholeOneLeavesNothingTorn) {
  const Answer begun = must(answers().begin("mill-1", 30, by("dripfeed", 5)));
  EXPECT_EQ(begun.state, AnswerState::sending);
  must(answers().end(begun.id, AnswerState::whole, "", by("dripfeed", 9)));
  EXPECT_FALSE(must(answers().torn_on("mill-1")));
  EXPECT_EQ(refusal(answers().end(begun.id, AnswerState::torn, "", by("dripfeed", 9))), ErrorCode::refused_transition);
  EXPECT_TRUE(must(answers().tear_unfinished(by("dripfeed", 10))).empty());
  const Answer kept = must(answers().list({.limit = 5, .after = {}}, "mill-1")).items.at(0);
  EXPECT_EQ(kept.begun_at_ms, 5);
  EXPECT_EQ(kept.ended_at_ms, 9);
  EXPECT_EQ(kept.bytes_total, 30U);
}

TEST_F(AnswerTest, OneThatNoOneEndedIsTornAtTheNextStartUntilAPersonConfirms) {
  must(answers().begin("mill-1", 30, by("dripfeed", 5)));
  const auto torn = must(answers().tear_unfinished(by("dripfeed", 20)));
  ASSERT_EQ(torn.size(), 1U);
  EXPECT_TRUE(must(answers().torn_on("mill-1"))->needs_confirmation());
  EXPECT_EQ(refusal(store_->jobs().move(job_.id, {JobState::armed, "", false, 620}, by("olga"))),
            ErrorCode::machine_torn);
  EXPECT_EQ(refusal(answers().confirm_reset("mill-1", "", by("olga"))), ErrorCode::invalid_value);
  EXPECT_EQ(refusal(answers().confirm_reset("mill-2", "reset", by("olga"))), ErrorCode::not_found);
  must(answers().confirm_reset("mill-1", "reset at the panel", by("olga", 30)));
  EXPECT_FALSE(must(answers().torn_on("mill-1")));
  must(store_->jobs().move(job_.id, {JobState::armed, "", false, 620}, by("olga")));
  EXPECT_EQ(refusal(answers().begin("mill-9", 1, by("dripfeed"))), ErrorCode::broken_reference);
  must(store_->audit().verify());
}

void wait_until(const std::function<bool()>& is_so) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!is_so() && std::chrono::steady_clock::now() < until) std::this_thread::yield();
  EXPECT_TRUE(is_so());
}

// Whoever goes first gets the next turn, however many others have waited longer.
TEST(WriteLane, TheLedgerGoesBeforeAllWhoWait) {
  sql::WriteLane lane;
  std::vector<int> order;
  lane.enter(sql::Turn::in_order);
  std::vector<std::thread> others;
  for (int i = 1; i <= 3; ++i) {
    others.emplace_back([&, i] {
      lane.enter(sql::Turn::in_order);
      order.push_back(i);
      lane.leave();
    });
  }
  wait_until([&] { return lane.use().others.waiting == 3; });
  std::thread ledger([&] {
    lane.enter(sql::Turn::first);
    order.push_back(0);
    lane.leave();
  });
  wait_until([&] { return lane.use().ledger.waiting == 1; });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  lane.leave();
  ledger.join();
  for (std::thread& other : others) other.join();
  ASSERT_EQ(order.size(), 4U);
  EXPECT_EQ(order.front(), 0);
  const store::StoreUse use = lane.use();
  EXPECT_EQ(use.ledger.turns, 1U);
  EXPECT_EQ(use.others.turns, 4U);
  EXPECT_EQ(use.others.begun, 4U);
  EXPECT_EQ(use.ledger.waiting + use.others.waiting, 0U);
  EXPECT_GE(use.ledger.waited, std::chrono::milliseconds(50));
  EXPECT_GE(use.others.waited, use.ledger.waited) << "three waited longer than the ledger";
  EXPECT_GE(use.others.held, std::chrono::milliseconds(50)) << "the first kept the lane so long";
}

TEST(WriteLane, ReportsWhoWaits) {
  sql::WriteLane lane;
  lane.enter(sql::Turn::in_order);
  std::thread other([&] {
    lane.enter(sql::Turn::in_order);
    lane.leave();
  });
  std::thread ledger([&] {
    lane.enter(sql::Turn::first);
    lane.leave();
  });
  wait_until([&] { return lane.use().ledger.waiting == 1 && lane.use().others.waiting == 1; });
  lane.leave();
  other.join();
  ledger.join();
  EXPECT_EQ(lane.use().ledger.waiting + lane.use().others.waiting, 0U);
}

}  // namespace
}  // namespace dripfeed::store_test
