// The audit names webhooks by id, url and types, never by their secrets.
#include "store/sql/webhook_table.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "store/sql/audit_table.h"
#include "store/sql/delivery_rows.h"
#include "store/sql/event_table.h"
#include "store/sql/paging.h"

namespace dripfeed::sql {
namespace {

using store::ErrorCode;
using store::Id;
using store::Result;
using store::Stamp;
using store::Webhook;
using store::WebhookDelivery;
using store::WebhookSettings;

std::string subject_of(Id webhook) { return fmt::format("webhook/{}", webhook); }

std::string webhooks_where(std::string_view rest) {
  return fmt::format(
      "SELECT id, url, types, description, enabled, is_local, secret, old_secret, old_until_ms, why_disabled, "
      "created_by, created_at_ms, changed_at_ms, seen, missed FROM webhook WHERE {}",
      rest);
}

// One type a line.
std::vector<std::string> split_lines(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::string joined(const std::vector<std::string>& types) { return fmt::format("{}", fmt::join(types, "\n")); }

Webhook read_webhook(Query& query) {
  Webhook webhook;
  webhook.id = query.number();
  webhook.of.url = query.text();
  webhook.of.types = split_lines(query.text());
  webhook.of.description = query.text();
  webhook.of.enabled = query.flag();
  webhook.of.local = query.flag();
  webhook.secret = query.text();
  webhook.old_secret = query.text();
  webhook.old_until_ms = query.signed_number();
  webhook.why_disabled = query.text();
  webhook.created_by = query.text();
  webhook.created_at_ms = query.signed_number();
  webhook.changed_at_ms = query.signed_number();
  webhook.seen = query.number();
  webhook.missed = query.number();
  return webhook;
}

std::optional<Webhook> find_webhook(Session& session, Id id) {
  static const std::string kSql = webhooks_where("id = ?");
  Query query(session, kSql, id);
  if (!query.next()) return std::nullopt;
  return read_webhook(query);
}

Result<Webhook> webhook_or_refusal(Session& session, Id id) {
  auto found = find_webhook(session, id);
  if (!found) return session.refuse(ErrorCode::not_found);
  return std::move(*found);
}

Result<void> check(Session& session, const WebhookSettings& settings) {
  if (!settings.url.empty() && !settings.types.empty()) return {};
  return session.refuse(ErrorCode::invalid_value, "a webhook has a url and types of events");
}

void note(Session& session, std::string_view action, Id id, std::string detail, const Stamp& by) {
  add_audit_row(session, {.action = std::string(action), .subject = subject_of(id), .detail = std::move(detail)}, by);
}

std::string describe(const WebhookSettings& settings) {
  return fmt::format("{} {} for {}{}", settings.enabled ? "enabled" : "disabled", settings.url,
                     fmt::join(settings.types, " "), settings.local ? ", local" : "");
}

std::vector<Webhook> read_enabled(Session& session) {
  static const std::string kSql = webhooks_where("enabled = 1 ORDER BY id");
  std::vector<Webhook> found;
  Query query(session, kSql);
  while (query.next()) found.push_back(read_webhook(query));
  return found;
}

}  // namespace

Result<Webhook> WebhookTable::add(const WebhookSettings& settings, std::string_view secret, std::uint64_t most,
                                  const Stamp& by) {
  return database_.write("webhook", [&](Session& session) -> Result<Webhook> {
    if (auto good = check(session, settings); !good) return std::unexpected(good.error());
    if (secret.empty()) return session.refuse(ErrorCode::invalid_value, "a webhook has a secret");
    std::uint64_t known = 0;
    {
      Query count(session, "SELECT count(*) FROM webhook");
      if (count.next()) known = count.number();
    }
    if (known >= most) return session.refuse(ErrorCode::exists, fmt::format("there are {} webhooks already", known));
    session.run(
        "INSERT INTO webhook (url, types, description, enabled, is_local, secret, created_by, created_at_ms, "
        "changed_at_ms, seen) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
        settings.url, joined(settings.types), settings.description, std::uint64_t{settings.enabled},
        std::uint64_t{settings.local}, secret, by.actor, by.at_ms, by.at_ms, newest_event(session));
    const Id id = session.last_id();
    note(session, "webhook.add", id, describe(settings), by);
    return webhook_or_refusal(session, id);
  });
}

Result<Webhook> WebhookTable::change(Id id, const WebhookSettings& settings, const Stamp& by) {
  return database_.write(subject_of(id), [&](Session& session) -> Result<Webhook> {
    const auto old = webhook_or_refusal(session, id);
    if (!old) return old;
    if (auto good = check(session, settings); !good) return std::unexpected(good.error());
    const bool again = settings.enabled && !old->of.enabled;
    session.run(
        "UPDATE webhook SET url = ?, types = ?, description = ?, enabled = ?, is_local = ?, why_disabled = ?, "
        "changed_at_ms = ?, seen = ? WHERE id = ?",
        settings.url, joined(settings.types), settings.description, std::uint64_t{settings.enabled},
        std::uint64_t{settings.local}, settings.enabled ? std::string() : old->why_disabled, by.at_ms,
        again ? newest_event(session) : old->seen, id);
    note(session, "webhook.change", id, describe(settings), by);
    return webhook_or_refusal(session, id);
  });
}

Result<Webhook> WebhookTable::rotate(Id id, std::string_view secret, std::int64_t old_until_ms, const Stamp& by) {
  return database_.write(subject_of(id), [&](Session& session) -> Result<Webhook> {
    const auto old = webhook_or_refusal(session, id);
    if (!old) return old;
    if (secret.empty()) return session.refuse(ErrorCode::invalid_value, "a webhook has a secret");
    const bool stays = old_until_ms > by.at_ms;
    session.run("UPDATE webhook SET secret = ?, old_secret = ?, old_until_ms = ?, changed_at_ms = ? WHERE id = ?",
                secret, stays ? old->secret : std::string(), stays ? old_until_ms : 0, by.at_ms, id);
    note(session, "webhook.rotate", id, stays ? "the previous secret also signs" : "the previous secret is void", by);
    return webhook_or_refusal(session, id);
  });
}

Result<Webhook> WebhookTable::disable(Id id, std::string_view why, const Stamp& by) {
  return database_.write(subject_of(id), [&](Session& session) -> Result<Webhook> {
    const auto old = webhook_or_refusal(session, id);
    if (!old || !old->of.enabled) return old;
    session.run("UPDATE webhook SET enabled = 0, why_disabled = ?, changed_at_ms = ? WHERE id = ?", why, by.at_ms, id);
    note(session, "webhook.disable", id, std::string(why), by);
    return webhook_or_refusal(session, id);
  });
}

Result<void> WebhookTable::remove(Id id, const Stamp& by) {
  return database_.write(subject_of(id), [&](Session& session) -> Result<void> {
    const auto old = webhook_or_refusal(session, id);
    if (!old) return std::unexpected(old.error());
    session.run("DELETE FROM webhook WHERE id = ?", id);
    note(session, "webhook.remove", id, old->of.url, by);
    return {};
  });
}

Result<Webhook> WebhookTable::get(Id id) {
  return database_.read(subject_of(id),
                        [&](Session& session) -> Result<Webhook> { return webhook_or_refusal(session, id); });
}

Result<store::Page<Webhook>> WebhookTable::list(const store::PageRequest& page) {
  return database_.read("webhooks", [&](Session& session) -> Result<store::Page<Webhook>> {
    const auto from = newest_first(page);
    if (!from) return std::unexpected(from.error());
    static const std::string kSql = webhooks_where("id < ? ORDER BY id DESC LIMIT ?");
    Query query(session, kSql, from->after, from->rows);
    return collect(query, page, read_webhook, [](const Webhook& one) { return fmt::format("{}", one.id); });
  });
}

Result<std::vector<Webhook>> WebhookTable::enabled() {
  return database_.read("webhooks",
                        [](Session& session) -> Result<std::vector<Webhook>> { return read_enabled(session); });
}

// Looked at first without a turn of the writer: mostly there is nothing new.
Result<std::uint64_t> WebhookTable::take_new(std::int64_t now_ms, std::uint64_t most_pending) {
  const auto news = database_.read("webhooks", [](Session& session) -> Result<bool> {
    Query query(session, "SELECT 1 FROM webhook WHERE enabled = 1 AND seen < ? LIMIT 1", newest_event(session));
    return query.next();
  });
  if (!news || !*news) return news ? Result<std::uint64_t>(0U) : std::unexpected(news.error());
  return database_.write("webhooks", [&](Session& session) -> Result<std::uint64_t> {
    std::uint64_t further = 0;
    for (const Webhook& webhook : read_enabled(session)) {
      if (take_events(session, webhook, now_ms, most_pending)) ++further;
    }
    return further;
  });
}

Result<WebhookDelivery> WebhookTable::ping(Id id, const Stamp& by) {
  return database_.write(subject_of(id), [&](Session& session) -> Result<WebhookDelivery> {
    const auto webhook = webhook_or_refusal(session, id);
    if (!webhook) return std::unexpected(webhook.error());
    if (!webhook->of.enabled) return session.refuse(ErrorCode::refused_transition, "it is disabled");
    const std::uint64_t event = add_event_row(
        session, {.topic = store::EventTopic::webhook, .word = std::string(store::kPing), .subject = id}, by);
    const Id delivery = insert_delivery(session, id, event, by.at_ms);
    note(session, "webhook.ping", id, {}, by);
    auto made = find_delivery(session, delivery);
    if (!made) return session.refuse(ErrorCode::internal);
    return std::move(*made);
  });
}

Result<std::optional<WebhookDelivery>> WebhookTable::due(Id webhook, std::int64_t now_ms) {
  return database_.read(subject_of(webhook), [&](Session& session) -> Result<std::optional<WebhookDelivery>> {
    static const std::string kSql = deliveries_where(
        "d.webhook = ? AND d.state = 'pending' AND d.next_at_ms <= ? ORDER BY d.next_at_ms, d.event LIMIT 1");
    Query query(session, kSql, webhook, now_ms);
    if (!query.next()) return std::nullopt;
    return read_delivery(query);
  });
}

Result<void> WebhookTable::note_try(Id delivery, const store::DeliveryTry& tried) {
  return database_.write("delivery", [&](Session& session) -> Result<void> {
    session.run(
        "UPDATE webhook_delivery SET state = ?, attempts = attempts + 1, next_at_ms = ?, last_at_ms = ?, last_status = "
        "?, last_error = ? WHERE id = ?",
        tried.state, tried.state == store::DeliveryState::pending ? tried.next_at_ms : 0, tried.at_ms, tried.status,
        tried.error, delivery);
    return {};
  });
}

Result<WebhookDelivery> WebhookTable::replay(Id webhook, Id id, const Stamp& by) {
  return database_.write(subject_of(webhook), [&](Session& session) -> Result<WebhookDelivery> {
    auto found = find_delivery(session, id);
    if (!found || found->webhook != webhook) return session.refuse(ErrorCode::not_found);
    session.run("UPDATE webhook_delivery SET state = 'pending', attempts = 0, next_at_ms = ? WHERE id = ?", by.at_ms,
                id);
    note(session, "webhook.replay", webhook, fmt::format("delivery {}", id), by);
    found->state = store::DeliveryState::pending;
    found->attempts = 0;
    found->next_at_ms = by.at_ms;
    return std::move(*found);
  });
}

Result<std::uint64_t> WebhookTable::replay_dead(Id webhook, std::int64_t since_ms, const Stamp& by) {
  return database_.write(subject_of(webhook), [&](Session& session) -> Result<std::uint64_t> {
    if (auto known = webhook_or_refusal(session, webhook); !known) return std::unexpected(known.error());
    session.run(
        "UPDATE webhook_delivery SET state = 'pending', attempts = 0, next_at_ms = ? WHERE webhook = ? AND state = "
        "'dead' AND event IN (SELECT seq FROM event WHERE at_ms >= ?)",
        by.at_ms, webhook, since_ms);
    const std::uint64_t count = session.changed_rows();
    note(session, "webhook.replay", webhook, fmt::format("{} dead deliveries since {}", count, since_ms), by);
    return count;
  });
}

Result<store::Page<WebhookDelivery>> WebhookTable::deliveries(Id webhook, const store::PageRequest& page,
                                                              const store::DeliveryFilter& filter) {
  return database_.read(subject_of(webhook), [&](Session& session) -> Result<store::Page<WebhookDelivery>> {
    if (auto known = webhook_or_refusal(session, webhook); !known) return std::unexpected(known.error());
    const auto from = newest_first(page);
    if (!from) return std::unexpected(from.error());
    const std::string sql = deliveries_where(fmt::format("d.webhook = ? AND {} AND d.id < ? ORDER BY d.id DESC LIMIT ?",
                                                         filter.state ? "d.state = ?" : "? = ''"));
    const std::string_view state = filter.state ? store::name_of(*filter.state) : std::string_view();
    Query query(session, sql, webhook, state, from->after, from->rows);
    return collect(query, page, read_delivery, [](const WebhookDelivery& one) { return fmt::format("{}", one.id); });
  });
}

}  // namespace dripfeed::sql
