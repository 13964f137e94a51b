// Alarms: equal ones fold, an alarm is open until it is acknowledged and over, and what is closed is forgotten in its
// time.
#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

using namespace store;

class AlarmTest : public StoreTest {
 protected:
  AlarmTest() {
    job_ = add_job(*store_, "mill-1");
    must(store_->machines().add("mill-2", "{}", by("anna")));
  }
  Alarms& alarms() { return store_->alarms(); }
  Alarm raise(const std::string& kind, const std::string& text, bool lasts, std::int64_t at_ms,
              const std::string& machine = "mill-1") {
    return must(alarms().raise({.machine = machine, .kind = kind, .text = text, .lasts = lasts}, at_ms));
  }
  std::vector<Id> listed(const AlarmFilter& filter, std::uint32_t limit = 50) {
    std::vector<Id> ids;
    PageRequest page{.limit = limit, .after = {}};
    do {
      const auto rows = must(alarms().list(page, filter));
      for (const Alarm& alarm : rows.items) ids.push_back(alarm.id);
      page.after = rows.next;
    } while (!page.after.empty());
    return ids;
  }
  std::vector<std::string> audited(Id alarm) {
    std::vector<std::string> all;
    for (const AuditRow& row : must(store_->audit().list({}, {.subject = "alarm/" + std::to_string(alarm)})).items)
      all.push_back(row.by.actor + " " + row.entry.action + ": " + row.entry.detail);
    return all;
  }
  Job job_;
};

TEST_F(AlarmTest, EqualOnesFoldWhileOneIsOpen) {
  const Alarm first = must(alarms().raise(
      {.machine = "mill-1", .kind = "call", .text = "a person is called", .job = job_.id, .count = 2}, 10));
  EXPECT_EQ(first.count, 2U);
  EXPECT_EQ(first.cleared_at_ms, 10) << "an event is over at once";
  EXPECT_EQ(raise("call", "a person is called", false, 20).id, first.id);
  EXPECT_NE(raise("call", "a person is called", false, 20, "mill-2").id, first.id);
  EXPECT_NE(raise("call", "another", false, 20).id, first.id);
  const Alarm folded = must(alarms().get(first.id));
  EXPECT_EQ(folded.count, 3U);
  EXPECT_EQ(folded.raised_at_ms, 10);
  EXPECT_EQ(folded.last_at_ms, 20);
  EXPECT_EQ(folded.job, job_.id);
  EXPECT_TRUE(folded.is_open());
  must(alarms().acknowledge(first.id, by("olga", 30)));
  EXPECT_NE(raise("call", "a person is called", false, 40).id, first.id) << "the closed one is over";
  EXPECT_EQ(must(alarms().get(first.id)).count, 3U);
}

TEST_F(AlarmTest, OpenOnesAreCountedByMachineAndKind) {
  EXPECT_TRUE(must(alarms().count_open()).empty());
  raise("call", "first", false, 10);
  const Alarm second = raise("call", "second", false, 10);
  raise("call", "second", false, 20);
  raise("link_lost", "gone", true, 10, "mill-2");
  must(alarms().acknowledge(raise("call", "closed", false, 10).id, by("olga", 30)));
  const auto found = must(alarms().count_open());
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].machine + found[0].kind + std::to_string(found[0].count), "mill-1call2");
  EXPECT_EQ(found[1].machine + found[1].kind + std::to_string(found[1].count), "mill-2link_lost1");
  must(alarms().acknowledge(second.id, by("olga", 30)));
  EXPECT_EQ(must(alarms().count_open())[0].count, 1U);
}

TEST_F(AlarmTest, OneThatLastsIsOpenUntilItIsAcknowledgedAndOver) {
  const Alarm link = raise("link_lost", "gone", true, 10);
  EXPECT_EQ(link.cleared_at_ms, 0);
  must(alarms().acknowledge(link.id, by("olga", 20)));
  EXPECT_TRUE(must(alarms().get(link.id)).is_open()) << "acknowledged, and it lasts";
  EXPECT_EQ(raise("link_lost", "gone", true, 25).id, link.id);
  EXPECT_EQ(must(alarms().lasting()).size(), 1U);
  EXPECT_TRUE(must(alarms().clear("mill-2", "link_lost", 30)).empty());
  EXPECT_TRUE(must(alarms().clear("mill-1", "torn_block", 30)).empty());
  const auto cleared = must(alarms().clear("mill-1", "link_lost", 30));
  ASSERT_EQ(cleared.size(), 1U);
  EXPECT_EQ(cleared[0].cleared_at_ms, 30);
  EXPECT_FALSE(cleared[0].is_open());
  EXPECT_TRUE(must(alarms().lasting()).empty());
  const Alarm again = raise("link_lost", "gone", true, 40);
  EXPECT_NE(again.id, link.id);
  must(alarms().clear("mill-1", "link_lost", 50));
  EXPECT_TRUE(must(alarms().get(again.id)).is_open()) << "over, and nobody said that they know";
  EXPECT_EQ(raise("link_lost", "gone", true, 60).cleared_at_ms, 0) << "on again";
}

TEST_F(AlarmTest, AnAcknowledgementIsGivenOnce) {
  const Alarm alarm = raise("call", "a person is called", false, 10);
  EXPECT_EQ(must(alarms().acknowledge(alarm.id, by("olga", 20))).acknowledged_by, "olga");
  const Alarm second = must(alarms().acknowledge(alarm.id, by("anna", 30)));
  EXPECT_EQ(second.acknowledged_by, "olga");
  EXPECT_EQ(second.acknowledged_at_ms, 20);
  EXPECT_EQ(audited(alarm.id),
            std::vector<std::string>{"olga alarm.acknowledge: call on mill-1, 1 times: a person is called"});
  EXPECT_EQ(refusal(alarms().acknowledge(99, by("olga"))), ErrorCode::not_found);
  EXPECT_EQ(refusal(alarms().get(99)), ErrorCode::not_found);
}

TEST_F(AlarmTest, AShelfHasAReasonAndAnEnd) {
  const Alarm alarm = raise("link_lost", "gone", true, 10);
  EXPECT_EQ(refusal(alarms().shelve(alarm.id, 60'010, "", by("olga", 10))), ErrorCode::invalid_value);
  EXPECT_EQ(refusal(alarms().shelve(alarm.id, 10, "off for repair", by("olga", 10))), ErrorCode::invalid_value);
  EXPECT_EQ(refusal(alarms().shelve(99, 60'010, "off for repair", by("olga", 10))), ErrorCode::not_found);
  const Alarm shelved = must(alarms().shelve(alarm.id, 60'010, "off for repair", by("olga", 10)));
  EXPECT_EQ(shelved.shelved_by, "olga");
  EXPECT_EQ(shelved.shelf_reason, "off for repair");
  EXPECT_TRUE(must(alarms().end_shelves(60'009)).empty());
  const auto ended = must(alarms().end_shelves(60'010));
  ASSERT_EQ(ended.size(), 1U);
  EXPECT_EQ(ended[0].shelved_until_ms, 0);
  EXPECT_EQ(must(alarms().get(alarm.id)).shelved_by, "");
  must(alarms().shelve(alarm.id, 90'000, "again", by("olga", 70'000)));
  EXPECT_EQ(must(alarms().unshelve(alarm.id, by("olga", 71'000))).shelved_until_ms, 0);
  must(alarms().unshelve(alarm.id, by("olga", 72'000)));
  EXPECT_EQ(audited(alarm.id),
            (std::vector<std::string>{"olga alarm.unshelve: link_lost on mill-1",
                                      "olga alarm.shelve: link_lost on mill-1 for 20 s: again",
                                      "olga alarm.shelve: link_lost on mill-1 for 60 s: off for repair"}));
  must(alarms().acknowledge(alarm.id, by("olga", 80'000)));
  must(alarms().clear("mill-1", "link_lost", 80'000));
  EXPECT_EQ(refusal(alarms().shelve(alarm.id, 90'000, "closed", by("olga", 80'001))), ErrorCode::refused_transition);
}

TEST_F(AlarmTest, PagesAreInTheOrderOfTheLastTime) {
  const Id a = raise("call", "a", false, 10).id;
  const Id b = raise("call", "b", false, 20).id;
  const Id c = raise("call", "c", false, 20, "mill-2").id;
  EXPECT_EQ(listed({}), (std::vector<Id>{c, b, a}));
  raise("call", "a", false, 30);
  EXPECT_EQ(listed({}, 1), (std::vector<Id>{a, c, b}));
  EXPECT_EQ(listed({.machine = "mill-1"}, 1), (std::vector<Id>{a, b}));
  must(alarms().acknowledge(b, by("olga")));
  EXPECT_EQ(listed({.open_only = true}, 1), (std::vector<Id>{a, c}));
  EXPECT_EQ(listed({.machine = "mill-1", .open_only = true}), (std::vector<Id>{a}));
  for (const char* wrong : {"x", "5", "5-", "5-x", "-", "5-6 "})
    EXPECT_EQ(refusal(alarms().list({.limit = 1, .after = wrong})), ErrorCode::invalid_value) << wrong;
}

TEST_F(AlarmTest, OnlyClosedOnesAreForgottenOldestFirst) {
  std::vector<Id> closed;
  for (int i = 0; i < 6; ++i) {
    closed.push_back(raise("call", "closed " + std::to_string(i), false, 100 + i).id);
    must(alarms().acknowledge(closed.back(), by("olga")));
  }
  const Id open = raise("call", "open", false, 1).id;
  const Id lasting = raise("link_lost", "gone", true, 2).id;
  must(alarms().acknowledge(lasting, by("olga")));
  EXPECT_EQ(must(alarms().forget(0, 6, 100)), 0U);
  EXPECT_EQ(must(alarms().forget(0, 4, 1)), 1U) << "no more than at once";
  EXPECT_EQ(must(alarms().forget(0, 4, 100)), 1U);
  EXPECT_EQ(listed({}), (std::vector<Id>{closed[5], closed[4], closed[3], closed[2], lasting, open}));
  EXPECT_EQ(must(alarms().forget(104, 4, 100)), 2U) << "those that are older";
  EXPECT_EQ(must(alarms().forget(1'000'000, 0, 100)), 2U);
  EXPECT_EQ(listed({}), (std::vector<Id>{lasting, open}));
}

TEST_F(AlarmTest, WhatMakesNoSenseIsRefused) {
  EXPECT_EQ(refusal(alarms().raise({.machine = "nobody", .kind = "call", .text = "x"}, 1)),
            ErrorCode::broken_reference);
  EXPECT_EQ(refusal(alarms().raise({.machine = "mill-1", .kind = "", .text = "x"}, 1)), ErrorCode::invalid_value);
  EXPECT_EQ(refusal(alarms().raise({.machine = "mill-1", .kind = "call", .text = ""}, 1)), ErrorCode::invalid_value);
  const Id alarm = raise("call", "x", false, 5).id;
  EXPECT_EQ(sql("DELETE FROM alarm"), "append-only");
  EXPECT_EQ(sql("UPDATE alarm SET kind = 'y'"), "append-only");
  must(alarms().acknowledge(alarm, by("olga", 6)));
  EXPECT_EQ(sql("UPDATE alarm SET acknowledged_at_ms = 0, acknowledged_by = ''"), "append-only");
  EXPECT_EQ(sql("UPDATE alarm SET count = 9"), "append-only");
}

}  // namespace
}  // namespace dripfeed::store_test
