// What each version added has a row in the shops from that version on.
#include "tests/store/old_shop.h"

#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "tests/store/fixture.h"

namespace dripfeed::store_test {

using namespace store;

std::string old_shop_file(std::uint32_t version) {
  return fmt::format("{}/tests/store/schema/v{}.sql", DRIPFEED_SOURCE_DIR, version);
}

std::string old_shop(std::uint32_t version) {
  std::ifstream file(old_shop_file(version), std::ios::binary);
  EXPECT_TRUE(file) << old_shop_file(version);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

void expect_old_shop(Store& store, std::uint32_t version) {
  must(store.check());
  EXPECT_EQ(must(store.audit().verify()).first_broken, std::nullopt);
  const Job job = must(store.jobs().on_line("mill-1")).value();
  EXPECT_EQ(job.state, JobState::held);
  EXPECT_EQ(job.rank, version >= 8 ? 1U : 0U);
  EXPECT_EQ(job.held_ms, std::nullopt);
  EXPECT_EQ(must(store.ledger().interval(job.id)).high, 96U);
  EXPECT_EQ(must(store.ledger().verify(job.id)), 1U);
  must(store.contents().verify(job.text_sha256));
  EXPECT_EQ(must(store.tokens().find("hash")).role, Role::operator_);
  if (version >= 3) {
    const auto receipts = must(store.receipts().list({}, {}));
    ASSERT_EQ(receipts.items.size(), 1U);
    must(store.contents().verify(receipts.items[0].of.sha256));
    EXPECT_EQ(must(store.receipts().requests({}, "mill-1")).items.size(), 1U);
  }
  const std::size_t answers = version >= 5 ? 1 : 0;
  EXPECT_EQ(must(store.answers().tear_unfinished(by("server"))).size(), answers);
  const auto alarms = must(store.alarms().lasting());
  ASSERT_EQ(alarms.size(), version >= 6 ? 1U : 0U);
  for (const Alarm& alarm : alarms) EXPECT_EQ(alarm.acknowledged_by, "olga");
  must(store.alarms().raise({.machine = "mill-1", .kind = "torn_block", .text = "a block is torn"}, 9));
  EXPECT_EQ(must(store.alarms().list({})).items.size(), 1U) << "folded, or the first of a store that had no table";
  EXPECT_EQ(store.browser_sessions().find("cookie").has_value(), version >= 7);
  const bool has_providers = version >= 18;
  EXPECT_EQ(store.users().of_provider({"https://login.shop", "s-3"}).has_value(), has_providers);
  EXPECT_EQ(store.browser_sessions().find("of dora").has_value(), has_providers);
  must(store.browser_sessions().open("another", {.token_hash = "hash"}, 8, 10));
  const Program program = must(store.programs().get(job.program));
  EXPECT_EQ(program.tags.size(), version >= 9 ? 1U : 0U);
  EXPECT_EQ(program.folder, version >= 9 ? "acme" : "");
  EXPECT_NE(program.change, 0U) << "what is derived from programs is made anew";
  EXPECT_EQ(must(store.programs().list({}, {.shelf = Shelf::archived})).items.size(), version >= 9 ? 1U : 0U);
  const Program changed = must(store.programs().label(job.program, {.tags = {{"new"}}}, by("server")));
  EXPECT_EQ(must(store.programs().changed_after(program.change, 9)).back().change, changed.change);
  const bool has_webhooks = version >= 11;
  ASSERT_EQ(must(store.webhooks().enabled()).size(), has_webhooks ? 1U : 0U);
  EXPECT_EQ(must(store.event_log().seen_by("mqtt")).has_value(), has_webhooks);
  const auto waits = must(store.webhooks().due(1, 10));
  EXPECT_EQ(waits ? waits->event.of.word : "", has_webhooks ? "ping" : "");
  EXPECT_EQ(must(store.releases().list({})).items.at(0).of.restart.line, version >= 13 ? 2U : 0U);
  EXPECT_EQ(store.programs().get(3).has_value(), version >= 16) << "its row stays";
  const auto attached = must(store.attachments().list({}, {.program = job.program})).items;
  ASSERT_EQ(attached.size(), version >= 15 ? 1U : 0U);
  for (const Attachment& one : attached) must(store.contents().verify(one.of.sha256));
  EXPECT_EQ(must(store.verdicts().list({})).items.at(0).rules, version >= 19 ? "rules 1" : "");
  for (const MachineGroup& group : must(store.users().groups()))
    EXPECT_EQ(group.operator_sign_off, version < 20) << "the rule is new, and holds for the groups of before";
  must(store.releases().released_for(job.text_sha256, "mill-1", Delivery::drip, 0));
  EXPECT_EQ(must(store.jobs().interrupt_unfinished(by("server"))).size(), 1U);
}

}  // namespace dripfeed::store_test
