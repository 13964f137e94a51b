// A webhook sends one delivery at a time, so that they come in their order while all goes well; webhooks do
// not wait for each other.
#include "server/app/out/webhooks.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "server/app/out/event_types.h"
#include "store/hash/webhook_secret.h"

namespace dripfeed::app {

namespace {

using namespace std::chrono_literals;

constexpr std::chrono::milliseconds kLookEvery{200};
constexpr std::chrono::milliseconds kAtOnce{0};  // a round waits by itself, for receivers
constexpr feed::Time kRest = 5s;
constexpr feed::Time kForgetEvery = 10min;
constexpr double kJitter = 0.1;  // of a delay, up and down
constexpr std::uint32_t kGone = 410;
constexpr std::int64_t kHour_ms = 3'600'000;
constexpr std::string_view kServer = "dripfeed";

bool is_taken(std::uint32_t status) { return status >= 200 && status < 300; }

}  // namespace

Webhooks::Webhooks(store::Store& store, const Events& events, const Clock& clock, HttpSender& sender,
                   WebhookSettings settings)
    : store_(store),
      clock_(clock),
      sender_(sender),
      settings_(std::move(settings)),
      line_events_(store, events, clock, settings.is_ours),
      thread_("webhooks", kAtOnce, Urgency::usual, [this] { round(); }) {}

void Webhooks::stop() {
  ends_.request_stop();
  sender_.wake();
  thread_.stop();
}

// --- what people ask for
// ------------------------------------------------------------------------------------------------------------------

store::Stamp Webhooks::stamp(std::string_view actor) const { return {std::string(actor), clock_.wall_ms()}; }

Result<void> Webhooks::check(const store::WebhookSettings& settings) const {
  std::vector<ErrorPlace> faults;
  if (const std::string why = sender_.why_no_target(settings.url, settings.local); !why.empty())
    faults.push_back({.pointer = "/url", .line = 0, .column = 0, .text = why});
  if (settings.types.empty())
    faults.push_back({.pointer = "/types", .line = 0, .column = 0, .text = "must name at least one type of event"});
  for (std::size_t i = 0; i < settings.types.size(); ++i) {
    if (covers_a_type(settings.types[i])) continue;
    faults.push_back(
        {.pointer = fmt::format("/types/{}", i),
         .line = 0,
         .column = 0,
         .text = fmt::format("\"{}\" is not a type of event: see GET /api/v1/event-types", settings.types[i])});
  }
  if (faults.empty()) return {};
  std::string text = fmt::format("the webhook's {} {}", faults.front().pointer.substr(1), faults.front().text);
  return fail(ErrorCode::invalid, std::move(text), std::move(faults));
}

Result<store::Webhook> Webhooks::add(const store::WebhookSettings& settings, std::string_view actor) {
  if (auto good = check(settings); !good) return std::unexpected(good.error());
  return lift(store_.webhooks().add(settings, hash::new_webhook_secret(), kMost, stamp(actor)));
}

Result<store::Webhook> Webhooks::change(store::Id webhook, const store::WebhookSettings& settings,
                                        std::string_view actor) {
  if (auto good = check(settings); !good) return std::unexpected(good.error());
  auto changed = lift(store_.webhooks().change(webhook, settings, stamp(actor)));
  sender_.wake();
  return changed;
}

Result<store::Webhook> Webhooks::rotate(store::Id webhook, std::int64_t keep_h, std::string_view actor) {
  const store::Stamp by = stamp(actor);
  return lift(store_.webhooks().rotate(webhook, hash::new_webhook_secret(), by.at_ms + keep_h * kHour_ms, by));
}

Result<store::WebhookDelivery> Webhooks::ping(store::Id webhook, std::string_view actor) {
  auto made = lift(store_.webhooks().ping(webhook, stamp(actor)));
  sender_.wake();
  return made;
}

Result<store::WebhookDelivery> Webhooks::replay(store::Id webhook, store::Id delivery, std::string_view actor) {
  auto again = lift(store_.webhooks().replay(webhook, delivery, stamp(actor)));
  sender_.wake();
  return again;
}

Result<std::uint64_t> Webhooks::replay_dead(store::Id webhook, std::int64_t since_ms, std::string_view actor) {
  auto count = lift(store_.webhooks().replay_dead(webhook, since_ms, stamp(actor)));
  sender_.wake();
  return count;
}

Result<void> Webhooks::remove(store::Id webhook, std::string_view actor) {
  return lift(store_.webhooks().remove(webhook, stamp(actor)));
}

// --- the thread
// ------------------------------------------------------------------------------------------------------------------

void Webhooks::round() {
  if (ends_.stop_requested()) return;
  line_events_.look();
  if (settings_.leads && !settings_.leads()) return;
  if (const auto taken = store_.webhooks().take_new(clock_.wall_ms(), kMostPending); !taken)
    spdlog::warn("webhooks: {}", store::message_of(taken.error()));
  begin_due();
  for (const HttpOutcome& outcome : sender_.work(kLookEvery)) note(outcome);
  forget();
}

void Webhooks::begin_due() {
  const auto webhooks = store_.webhooks().enabled();
  if (!webhooks) return;
  std::erase_if(rests_, [now = clock_.now()](const auto& row) { return row.second <= now; });
  for (const store::Webhook& webhook : *webhooks) {
    const bool is_on = std::ranges::any_of(on_, [&](const auto& row) { return row.second.webhook.id == webhook.id; });
    if (is_on || rests_.contains(webhook.id)) continue;
    const auto due = store_.webhooks().due(webhook.id, clock_.wall_ms());
    if (due && *due) send(webhook, **due);
  }
}

// The time of a try is the time of its signature: a receiver refuses an old one.
void Webhooks::send(const store::Webhook& webhook, const store::WebhookDelivery& delivery) {
  const std::int64_t now_ms = clock_.wall_ms();
  HttpCall post{
      .url = webhook.of.url, .headers = {}, .body = settings_.write(delivery.event), .local = webhook.of.local};
  const std::string id = store::id_of(delivery.event);
  const hash::WebhookMessage message{.id = id, .at_s = now_ms / 1000, .body = post.body};
  std::string signatures = hash::webhook_signature(webhook.secret, message).value_or("");
  if (now_ms < webhook.old_until_ms)
    signatures += " " + hash::webhook_signature(webhook.old_secret, message).value_or("");
  post.headers = {{"Content-Type", "application/cloudevents+json; charset=utf-8"},
                  {"webhook-id", id},
                  {"webhook-timestamp", fmt::format("{}", message.at_s)},
                  {"webhook-signature", signatures}};
  on_[delivery.id] = {.webhook = webhook, .delivery = delivery};
  sender_.begin(delivery.id, post);
}

store::DeliveryTry Webhooks::judge(const InFlight& sent, const HttpOutcome& outcome) {
  store::DeliveryTry tried{
      .state = store::DeliveryState::dead, .at_ms = clock_.wall_ms(), .status = outcome.status, .error = outcome.error};
  if (is_taken(outcome.status)) {
    tried.state = store::DeliveryState::delivered;
  } else if (outcome.status != kGone && sent.delivery.attempts < settings_.retries_s.size()) {
    std::uniform_real_distribution<double> jitter(1.0 - kJitter, 1.0 + kJitter);
    tried.state = store::DeliveryState::pending;
    tried.next_at_ms = tried.at_ms + std::llround(settings_.retries_s[sent.delivery.attempts] * jitter(random_) * 1e3);
  }
  return tried;
}

void Webhooks::note(const HttpOutcome& outcome) {
  const auto found = on_.extract(outcome.ticket);
  if (found.empty()) return;
  const InFlight& sent = found.mapped();
  const store::DeliveryTry tried = judge(sent, outcome);
  if (tried.state == store::DeliveryState::dead)
    spdlog::warn("webhook {}: event {} is given up: {}", sent.webhook.id, store::id_of(sent.delivery.event),
                 outcome.status == 0 ? outcome.error : fmt::format("it answered {}", outcome.status));
  auto written = store_.webhooks().note_try(sent.delivery.id, tried);
  if (written && outcome.status == kGone)
    if (const auto off = store_.webhooks().disable(sent.webhook.id, "it answered 410: it is gone", stamp(kServer));
        !off)
      written = std::unexpected(off.error());
  if (written) return;
  spdlog::warn("webhook {}: {}", sent.webhook.id, store::message_of(written.error()));
  rests_[sent.webhook.id] = clock_.now() + kRest;
}

void Webhooks::forget() {
  if (clock_.now() < next_forget_) return;
  const std::int64_t now_ms = clock_.wall_ms();
  const auto gone = store_.event_log().forget(
      {.before_ms = now_ms - kEventsKept_ms, .delivered_before_ms = now_ms - kDeliveredKept_ms, .most = kMostEvents});
  if (!gone || *gone == 0) next_forget_ = clock_.now() + kForgetEvery;
}

}  // namespace dripfeed::app
