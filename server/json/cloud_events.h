// Events as other systems get them: CloudEvents 1.0, structured, as JSON; what one of them is asked before an arming;
// and what an admin sees of webhooks.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "server/app/out/arming_hook.h"
#include "server/app/out/event_types.h"
#include "server/app/out/webhooks.h"

namespace dripfeed::json {

// `source`: who sends, as a URI reference; together with the id it names the event in all the world.
std::string cloud_event(const store::LoggedEvent& event, std::string_view source);

std::string arming_question(const app::ArmingQuestion& question);
// It allows with 200 and {"allow": true} alone. It refuses with {"allow": false, "reason": "…"}, or with 403, 409 or
// 422 and the words of a problem document's `detail`. All else is not an answer.
app::HookAnswer read_hook_answer(std::uint32_t status, std::string_view body);

std::string event_type(const app::EventType& type);
// Without its secrets.
std::string webhook(const store::Webhook& webhook);
// With the new one: it is shown once.
std::string webhook_with_secret(const store::Webhook& webhook);
std::string webhook_delivery(const store::WebhookDelivery& delivery);
std::string replayed(std::uint64_t count);

}  // namespace dripfeed::json
