// Deliveries as rows: making them of events, reading them with their event.
#pragma once

#include <optional>

#include "store/sql/session.h"
#include "store/webhooks.h"

namespace dripfeed::sql {

// A SELECT of the columns that read_delivery() reads; `rest` names the delivery `d` and its event `e`.
std::string deliveries_where(std::string_view rest);
store::WebhookDelivery read_delivery(Query& query);
std::optional<store::WebhookDelivery> find_delivery(Session& session, store::Id id);
// To be tried from this time on; its id.
store::Id insert_delivery(Session& session, store::Id webhook, std::uint64_t event, std::int64_t at_ms);
// Of the events after webhook.seen that it wants, as long as fewer than `most_pending` wait. False: none came.
bool take_events(Session& session, const store::Webhook& webhook, std::int64_t now_ms, std::uint64_t most_pending);

}  // namespace dripfeed::sql
