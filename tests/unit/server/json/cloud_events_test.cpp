// Events as CloudEvents: the envelope of each topic, what is cut, and that no secret is shown but where it is new.
#include "server/json/cloud_events.h"

#include <gmock/gmock.h>

#include "server/json/requests.h"

namespace dripfeed::json {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

store::LoggedEvent an_event(store::EventTopic topic, std::string word) {
  return {.seq = 42,
          .of = {.topic = topic,
                 .word = std::move(word),
                 .subject = 7,
                 .machine = "mill",
                 .job = 7,
                 .program = 3,
                 .revision = 2,
                 .cause = "link_lost",
                 .text = "no link"},
          .by = {"olga", 1'700'000'000'123}};
}

TEST(CloudEvents, TheWholeOfOneJob) {
  EXPECT_EQ(cloud_event(an_event(store::EventTopic::job, "failed"), "dripfeed://hall-2"),
            R"({"specversion":"1.0","id":"18bcfe5687b-42","source":"dripfeed://hall-2","type":"job.failed",)"
            R"("subject":"job/7","time":"2023-11-14T22:13:20.123Z","sequence":"00000000000000000042",)"
            R"("datacontenttype":"application/json","data":{"job":7,"state":"failed","machine":"mill","program":3,)"
            R"("revision":2,"reason":"no link","reason_id":"link_lost","actor":"olga"}})");
}

TEST(CloudEvents, EachTopicNamesItsSubject) {
  using store::EventTopic;
  EXPECT_THAT(cloud_event(an_event(EventTopic::line, "torn"), "a"), HasSubstr(R"("subject":"machine/mill")"));
  EXPECT_THAT(cloud_event(an_event(EventTopic::alarm, "raised"), "a"), HasSubstr(R"("severity":"warning")"));
  EXPECT_THAT(cloud_event(an_event(EventTopic::release, "approved"), "a"), HasSubstr(R"("note":"no link")"));
  EXPECT_THAT(cloud_event(an_event(EventTopic::program, "revised"), "a"), HasSubstr(R"("program":7,"name":"no link")"));
  EXPECT_THAT(cloud_event(an_event(EventTopic::receipt, "stored"), "a"), HasSubstr(R"("subject":"receipt/7")"));
  EXPECT_THAT(cloud_event(an_event(EventTopic::webhook, "ping"), "a"), HasSubstr(R"("data":{"webhook":7,)"));
}

TEST(CloudEvents, ALongTextIsCutAtACharacter) {
  store::LoggedEvent event = an_event(store::EventTopic::job, "failed");
  event.of.text.clear();
  for (int i = 0; i < 20'000; ++i) event.of.text += "ä";
  const std::string text = cloud_event(event, "a");
  EXPECT_LT(text.size(), 20'000U);
  EXPECT_THAT(text, HasSubstr("ää\",\"reason_id\""));
}

TEST(CloudEvents, ASecretIsShownWhereItIsNew) {
  store::Webhook hook;
  hook.secret = "whsec_new";
  hook.old_secret = "whsec_old";
  EXPECT_THAT(webhook(hook), Not(HasSubstr("whsec")));
  EXPECT_THAT(webhook_with_secret(hook), HasSubstr("whsec_new"));
  EXPECT_THAT(webhook_with_secret(hook), Not(HasSubstr("whsec_old")));
}

TEST(CloudEvents, AChangeLeavesWhatItDoesNotName) {
  const store::WebhookSettings known{
      .url = "https://a", .types = {"job.*"}, .description = "MES", .enabled = false, .local = true};
  const auto changed = read_webhook_change(R"({"enabled":true})", known);
  ASSERT_TRUE(changed);
  EXPECT_TRUE(changed->enabled);
  EXPECT_EQ(changed->url, "https://a");
  EXPECT_EQ(changed->types, known.types);
  EXPECT_TRUE(changed->local);
}

}  // namespace
}  // namespace dripfeed::json
