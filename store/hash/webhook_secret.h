// Secrets of webhooks and what they sign, by the rules of Standard Webhooks 1.0: HMAC-SHA256 over "id.timestamp.body".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace dripfeed::hash {

// "whsec_" and 24 random bytes in base64.
std::string new_webhook_secret();

struct WebhookMessage {
  std::string_view id;
  std::int64_t at_s = 0;  // when this try is made, since 1970
  std::string_view body;
};
// "v1,<base64>"; nothing where the secret is none.
std::optional<std::string> webhook_signature(std::string_view secret, const WebhookMessage& message);

}  // namespace dripfeed::hash
