// Signatures of webhooks against the example of Standard Webhooks' own libraries.
#include "store/hash/webhook_secret.h"

#include <gtest/gtest.h>

namespace dripfeed::hash {
namespace {

TEST(WebhookSecret, SignsAsTheStandardsExampleDoes) {
  const WebhookMessage message{
      .id = "msg_p5jXN8AQM9LWM0D4loKWxJek", .at_s = 1614265330, .body = R"({"test": 2432232314})"};
  EXPECT_EQ(webhook_signature("whsec_MfKQ9r8GKYqrTwjUPD8ILPZIo2LaLaSw", message),
            "v1,g0hM9SsE+OTPJTGt/tmIKtSyZlE3uFJELVlNIOLJ1OE=");
}

TEST(WebhookSecret, NewOnesDifferAndSign) {
  const std::string a = new_webhook_secret();
  const std::string b = new_webhook_secret();
  EXPECT_NE(a, b);
  EXPECT_EQ(a.size(), 6U + 32U);
  const WebhookMessage message{.id = "1", .at_s = 2, .body = "{}"};
  EXPECT_NE(webhook_signature(a, message), webhook_signature(b, message));
  EXPECT_EQ(webhook_signature(a, message), webhook_signature(a, message));
}

TEST(WebhookSecret, WhatIsNoSecretSignsNothing) {
  for (const char* const none : {"", "whsec_", "whsec_%%%", "MfKQ9r8GKYqrTwjUPD8ILPZIo2LaLaSw"})
    EXPECT_EQ(webhook_signature(none, {.id = "1", .at_s = 2, .body = "{}"}), std::nullopt) << none;
}

}  // namespace
}  // namespace dripfeed::hash
