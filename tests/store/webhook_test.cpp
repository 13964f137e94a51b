// Events stand in the log with the change that they report, or not at all; each becomes one delivery a webhook that
// wants it; what is not taken is tried again until it is dead, and may be replayed.
#include <algorithm>

#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

using namespace store;

class EventLogTest : public StoreTest {
 protected:
  std::vector<std::string> types(std::uint64_t after = 0) {
    std::vector<std::string> all;
    for (const LoggedEvent& event : must(store_->event_log().after(after, 1000))) all.push_back(type_of(event.of));
    return all;
  }
  std::uint64_t newest() { return must(store_->event_log().newest()); }
};

TEST_F(EventLogTest, AChangeAndItsEventAreOneTransaction) {
  const Job job = add_job(*store_, "mill-1");
  const std::uint64_t before = newest();
  const auto undone = store_->atomically([&]() -> Result<void> {
    must(store_->jobs().move(job.id, {.to = JobState::armed}, by("olga", 7)));
    return std::unexpected(Error{ErrorCode::internal, "the end of the server"});
  });
  EXPECT_EQ(refusal(undone), ErrorCode::internal);
  EXPECT_EQ(newest(), before);
  must(store_->jobs().move(job.id, {.to = JobState::armed}, by("olga", 7)));
  const auto events = must(store_->event_log().after(before, 10));
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(type_of(events[0].of), "job.armed");
  EXPECT_EQ(events[0].of.subject, job.id);
  EXPECT_EQ(events[0].of.machine, "mill-1");
  EXPECT_EQ(events[0].by.actor, "olga");
  EXPECT_EQ(events[0].by.at_ms, 7);
}

TEST_F(EventLogTest, JobsReportTheirStatesButNotOfHolds) {
  const Job job = add_job(*store_, "mill-1");
  const std::uint64_t before = newest();
  bring(*store_, job.id, JobState::feeding);
  for (int i = 0; i < 3; ++i) {
    must(store_->jobs().move(job.id, {.to = JobState::held}, by("mill-1")));
    must(store_->jobs().move(job.id, {.to = JobState::feeding}, by("mill-1")));
  }
  must(store_->jobs().move(job.id, {.to = JobState::failed, .reason = "link", .torn = true}, by("mill-1")));
  EXPECT_EQ(types(before), (std::vector<std::string>{"job.armed", "job.feeding", "job.failed"}));
}

TEST_F(EventLogTest, AlarmsReportWhatChangesForPeople) {
  must(store_->machines().add("mill-1", "{}", by("anna")));
  const NewAlarm lost{.machine = "mill-1", .kind = "link_lost", .text = "no link", .lasts = true};
  const Alarm alarm = must(store_->alarms().raise(lost, 10));
  must(store_->alarms().raise(lost, 20));  // folds: nothing new
  must(store_->alarms().clear("mill-1", "link_lost", 30));
  must(store_->alarms().raise(lost, 40));  // on again
  must(store_->alarms().acknowledge(alarm.id, by("olga", 50)));
  must(store_->alarms().acknowledge(alarm.id, by("anna", 60)));  // known already
  must(store_->alarms().shelve(alarm.id, 100, "later", by("olga", 70)));
  must(store_->alarms().end_shelves(100));
  EXPECT_EQ(types(), (std::vector<std::string>{"alarm.raised", "alarm.cleared", "alarm.raised", "alarm.acknowledged",
                                               "alarm.shelved", "alarm.unshelved"}));
}

TEST_F(EventLogTest, ProgramsReleasesAndReceiptsReportTheirSteps) {
  const Released made = add_released(*store_, "mill-1");
  const auto seen = types();
  EXPECT_EQ(std::ranges::count(seen, "program.added"), 1);
  EXPECT_EQ((std::vector<std::string>(seen.end() - 4, seen.end())),
            (std::vector<std::string>{"release.draft", "release.in_review", "release.proving", "release.approved"}));
  const std::uint64_t before = newest();
  const Content text = must(store_->contents().put("%\nO7\nM30\n%\n"));
  must(store_->programs().add_revision(made.program.id, 1, {.sha256 = text.sha256}, by("anna")));
  const auto receipt = must(store_->receipts().add({.machine = "mill-1",
                                                    .name = "O7",
                                                    .style = "number",
                                                    .sha256 = text.sha256,
                                                    .raw_bytes = 12,
                                                    .code = "iso",
                                                    .ended_by = "punch_off"},
                                                   by("mill-1")));
  must(store_->receipts().discard(receipt.id, "a try", by("anna")));
  EXPECT_EQ(types(before), (std::vector<std::string>{"program.revised", "receipt.stored", "receipt.discarded"}));
}

TEST_F(EventLogTest, OldOnesAreForgottenAndTheirNumbersNeverComeBack) {
  for (int i = 1; i <= 5; ++i)
    must(store_->event_log().append({.topic = EventTopic::line, .word = "idle"}, by("dripfeed", i)));
  EXPECT_EQ(must(store_->event_log().forget({.before_ms = 2, .most = 3, .at_once = 10})), 2U);
  EXPECT_EQ(must(store_->event_log().after(0, 10)).front().seq, 3U);
  EXPECT_EQ(must(store_->event_log().forget({.before_ms = 100, .most = 3, .at_once = 10})), 3U);
  EXPECT_EQ(must(store_->event_log().append({.topic = EventTopic::line, .word = "idle"}, by("x"))).seq, 6U);
  EXPECT_NE(sql("UPDATE event SET word = 'armed'"), "");
}

class WebhookTest : public EventLogTest {
 protected:
  Webhook add(std::vector<std::string> types = {"*"}) {
    return must(store_->webhooks().add({.url = "https://mes.shop/in", .types = std::move(types)}, "whsec_a", 8,
                                       by("admin", 1)));
  }
  void happen(const std::string& word, std::int64_t at_ms = 5) {
    must(store_->event_log().append({.topic = EventTopic::line, .word = word, .machine = "mill-1"}, by("x", at_ms)));
  }
  std::vector<std::string> listed(Id webhook, const DeliveryFilter& filter = {}) {
    std::vector<std::string> all;
    for (const auto& one : must(store_->webhooks().deliveries(webhook, {}, filter)).items)
      all.push_back(type_of(one.event.of));
    return all;
  }
};

TEST_F(WebhookTest, TypesCoverByWholeWords) {
  EXPECT_TRUE(wants({"job.done"}, "job.done"));
  EXPECT_FALSE(wants({"job.done"}, "job.done2"));
  EXPECT_TRUE(wants({"alarm.raised", "job.*"}, "job.failed"));
  EXPECT_FALSE(wants({"job.*"}, "jobs.failed"));
  EXPECT_TRUE(wants({"*"}, "line.idle"));
  EXPECT_FALSE(wants({}, "line.idle"));
}

TEST_F(WebhookTest, EachGetsWhatItWantsFromItsBeginningOn) {
  happen("idle");
  const Webhook all = add();
  const Webhook some = add({"line.torn", "job.*"});
  happen("armed");
  happen("torn");
  EXPECT_EQ(must(store_->webhooks().take_new(10, 100)), 2U);
  EXPECT_EQ(must(store_->webhooks().take_new(11, 100)), 0U);
  EXPECT_EQ(listed(all.id), (std::vector<std::string>{"line.torn", "line.armed"}));
  EXPECT_EQ(listed(some.id), (std::vector<std::string>{"line.torn"}));
  EXPECT_EQ(must(store_->webhooks().due(some.id, 9)), std::nullopt);
  EXPECT_EQ(must(store_->webhooks().due(some.id, 10))->event.of.word, "torn");
}

TEST_F(WebhookTest, ATryThatFailsComesAgainUntilItIsDead) {
  const Webhook hook = add();
  happen("armed");
  must(store_->webhooks().take_new(10, 100));
  const auto first = must(store_->webhooks().due(hook.id, 10)).value();
  must(store_->webhooks().note_try(first.id, {.next_at_ms = 500, .at_ms = 11, .status = 503}));
  EXPECT_EQ(must(store_->webhooks().due(hook.id, 499)), std::nullopt);
  EXPECT_EQ(must(store_->webhooks().due(hook.id, 500))->attempts, 1U);
  must(store_->webhooks().note_try(first.id, {.state = DeliveryState::dead, .at_ms = 501, .error = "timeout"}));
  EXPECT_EQ(must(store_->webhooks().due(hook.id, 9999)), std::nullopt);
  EXPECT_EQ(listed(hook.id, {.state = DeliveryState::dead}).size(), 1U);
  EXPECT_EQ(must(store_->webhooks().replay_dead(hook.id, 6, by("admin", 600))), 0U) << "the event is older";
  EXPECT_EQ(must(store_->webhooks().replay_dead(hook.id, 5, by("admin", 600))), 1U);
  const auto again = must(store_->webhooks().due(hook.id, 600)).value();
  EXPECT_EQ(again.id, first.id);
  EXPECT_EQ(id_of(again.event), id_of(first.event)) << "the receiver knows it again";
  EXPECT_EQ(again.attempts, 0U);
  must(store_->webhooks().note_try(first.id, {.state = DeliveryState::delivered, .at_ms = 601, .status = 204}));
  EXPECT_EQ(must(store_->webhooks().replay(hook.id, first.id, by("admin", 700))).state, DeliveryState::pending);
  EXPECT_EQ(refusal(store_->webhooks().replay(hook.id + 1, first.id, by("admin", 700))), ErrorCode::not_found);
}

TEST_F(WebhookTest, AFullQueueLetsTheLogWait) {
  const Webhook hook = add();
  for (int i = 0; i < 5; ++i) happen("armed");
  must(store_->webhooks().take_new(10, 2));
  EXPECT_EQ(listed(hook.id).size(), 2U);
  must(store_->webhooks().take_new(11, 2));
  EXPECT_EQ(listed(hook.id).size(), 2U);
  const auto one = must(store_->webhooks().due(hook.id, 20)).value();
  must(store_->webhooks().note_try(one.id, {.state = DeliveryState::delivered, .at_ms = 21, .status = 200}));
  must(store_->webhooks().take_new(22, 2));
  EXPECT_EQ(listed(hook.id).size(), 3U);
  must(store_->event_log().forget({.before_ms = 0, .most = 1, .at_once = 10}));
  must(store_->webhooks().take_new(23, 2));
  EXPECT_EQ(must(store_->webhooks().get(hook.id)).missed, 1U) << "the fourth was forgotten before it was a delivery";
}

TEST_F(WebhookTest, OneThatIsDisabledGetsNothing) {
  const Webhook hook = add();
  happen("armed");
  must(store_->webhooks().take_new(10, 100));
  const Webhook off = must(store_->webhooks().disable(hook.id, "it answered 410", by("dripfeed", 11)));
  EXPECT_FALSE(off.of.enabled);
  EXPECT_EQ(off.why_disabled, "it answered 410");
  happen("torn");
  EXPECT_EQ(must(store_->webhooks().take_new(12, 100)), 0U);
  EXPECT_EQ(refusal(store_->webhooks().ping(hook.id, by("admin"))), ErrorCode::refused_transition);
  const Webhook on = must(store_->webhooks().change(hook.id, hook.of, by("admin", 13)));
  EXPECT_EQ(on.why_disabled, "");
  happen("idle");
  must(store_->webhooks().take_new(14, 100));
  EXPECT_EQ(listed(hook.id), (std::vector<std::string>{"line.idle", "line.armed"}));
}

TEST_F(WebhookTest, TheSecretBeforeStaysForAWhile) {
  const Webhook hook = add();
  const Webhook turned = must(store_->webhooks().rotate(hook.id, "whsec_b", 100, by("admin", 50)));
  EXPECT_EQ(turned.secret, "whsec_b");
  EXPECT_EQ(turned.old_secret, "whsec_a");
  EXPECT_EQ(turned.old_until_ms, 100);
  EXPECT_EQ(must(store_->webhooks().rotate(hook.id, "whsec_c", 0, by("admin", 60))).old_secret, "");
  for (const AuditRow& row : must(store_->audit().list({}, {.subject = "webhook/1"})).items)
    EXPECT_EQ(row.entry.detail.find("whsec"), std::string::npos) << row.entry.detail;
}

TEST_F(WebhookTest, OneThatIsRemovedTakesItsDeliveriesWithIt) {
  const Webhook hook = add();
  must(store_->webhooks().ping(hook.id, by("admin", 5)));
  EXPECT_EQ(listed(hook.id), (std::vector<std::string>{"webhook.ping"}));
  const Webhook other = add();
  must(store_->webhooks().take_new(10, 100));
  EXPECT_EQ(listed(other.id).size(), 0U) << "a ping is for one alone";
  must(store_->webhooks().remove(hook.id, by("admin", 6)));
  EXPECT_EQ(refusal(store_->webhooks().get(hook.id)), ErrorCode::not_found);
  EXPECT_EQ(refusal(store_->webhooks().deliveries(hook.id, {})), ErrorCode::not_found);
  EXPECT_EQ(refusal(store_->webhooks().add({.url = "https://a", .types = {"*"}}, "s", 1, by("admin"))),
            ErrorCode::exists);
}

}  // namespace
}  // namespace dripfeed::store_test
