// Events that were forgotten before they became deliveries are counted: whoever reads the webhook sees the gap.
#include "store/sql/delivery_rows.h"

#include <algorithm>

#include <fmt/format.h>

#include "store/sql/event_table.h"

namespace dripfeed::sql {
namespace {

using store::Id;
using store::LoggedEvent;
using store::Webhook;
using store::WebhookDelivery;

constexpr std::uint64_t kEventsAtOnce = 256;

std::uint64_t count_pending(Session& session, Id webhook) {
  Query query(session, "SELECT count(*) FROM webhook_delivery WHERE webhook = ? AND state = 'pending'", webhook);
  return query.next() ? query.number() : 0;
}

std::vector<LoggedEvent> events_after(Session& session, std::uint64_t seq, std::uint64_t most) {
  static const std::string kSql =
      fmt::format("SELECT {} FROM event e WHERE e.seq > ? ORDER BY e.seq LIMIT ?", kEventColumns);
  Query query(session, kSql, seq, most);
  std::vector<LoggedEvent> found;
  while (query.next()) found.push_back(read_event(query));
  return found;
}

}  // namespace

std::string deliveries_where(std::string_view rest) {
  return fmt::format(
      "SELECT d.id, d.webhook, d.state, d.attempts, d.next_at_ms, d.last_at_ms, d.last_status, d.last_error, {} FROM "
      "webhook_delivery d JOIN event e ON e.seq = d.event WHERE {}",
      kEventColumns, rest);
}

WebhookDelivery read_delivery(Query& query) {
  WebhookDelivery delivery;
  delivery.id = query.number();
  delivery.webhook = query.number();
  delivery.state = query.value<store::DeliveryState>();
  delivery.attempts = static_cast<std::uint32_t>(query.number());
  delivery.next_at_ms = query.signed_number();
  delivery.last_at_ms = query.signed_number();
  delivery.last_status = static_cast<std::uint32_t>(query.number());
  delivery.last_error = query.text();
  delivery.event = read_event(query);
  return delivery;
}

std::optional<WebhookDelivery> find_delivery(Session& session, Id id) {
  static const std::string kSql = deliveries_where("d.id = ?");
  Query query(session, kSql, id);
  if (!query.next()) return std::nullopt;
  return read_delivery(query);
}

Id insert_delivery(Session& session, Id webhook, std::uint64_t event, std::int64_t at_ms) {
  session.run("INSERT INTO webhook_delivery (webhook, event, state, next_at_ms) VALUES (?, ?, 'pending', ?)", webhook,
              event, at_ms);
  return session.last_id();
}

bool take_events(Session& session, const Webhook& webhook, std::int64_t now_ms, std::uint64_t most_pending) {
  const std::uint64_t pending = count_pending(session, webhook.id);
  if (pending >= most_pending) return false;
  const std::uint64_t newest = newest_event(session);
  if (newest <= webhook.seen) return false;
  const auto events = events_after(session, webhook.seen, std::min(most_pending - pending, kEventsAtOnce));
  const std::uint64_t missed = events.empty() ? newest - webhook.seen : events.front().seq - webhook.seen - 1;
  for (const LoggedEvent& event : events) {
    if (event.of.topic == store::EventTopic::webhook || !store::wants(webhook.of.types, store::type_of(event.of)))
      continue;
    insert_delivery(session, webhook.id, event.seq, now_ms);
  }
  session.run("UPDATE webhook SET seen = ?, missed = missed + ? WHERE id = ?",
              events.empty() ? newest : events.back().seq, missed, webhook.id);
  return true;
}

}  // namespace dripfeed::sql
