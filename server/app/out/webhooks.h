// Sends events to webhooks by the rules of Standard Webhooks 1.0. Events become deliveries in the store, and a delivery
// stays there until the receiver took it or all tries failed: a receiver may get one twice, and never none. A thread of
// its own does it, which waits for the store and for receivers, and for which no thread waits.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/base/error.h"
#include "server/app/base/round_thread.h"
#include "server/app/out/line_events.h"
#include "server/app/ports/http_sender.h"

namespace dripfeed::app {

// An event as other systems get it, whatever brings it there.
using WriteEvent = std::function<std::string(const store::LoggedEvent&)>;

// After the first try; the schedule of the standard. The last one is followed by no other.
inline const std::vector<double> kWebhookRetries_s = {5, 300, 1'800, 7'200, 18'000, 36'000, 50'400, 72'000, 86'400};

struct WebhookSettings {
  WriteEvent write;
  std::vector<double> retries_s = kWebhookRetries_s;
  std::function<bool()> leads{};  // whether this server posts for all nodes of its store; empty: it does
  std::function<bool(std::string_view machine)> is_ours{};  // whether this server has the machine's line; empty: it has
};

class Webhooks {
 public:
  static constexpr std::uint64_t kMost = 32;             // webhooks
  static constexpr std::uint64_t kMostPending = 1000;    // deliveries of one; beyond it the log of events waits
  static constexpr std::uint64_t kMostEvents = 100'000;  // in the log
  static constexpr std::int64_t kEventsKept_ms = 30LL * 24 * 3600 * 1000;
  static constexpr std::int64_t kDeliveredKept_ms = 7LL * 24 * 3600 * 1000;
  static constexpr std::int64_t kOldSecretAtMost_h = 168;

  Webhooks(store::Store& store, const Events& events, const Clock& clock, HttpSender& sender, WebhookSettings settings);
  ~Webhooks() { stop(); }
  Webhooks(const Webhooks&) = delete;
  Webhooks& operator=(const Webhooks&) = delete;

  // The secret of the new one is in it. Errors: invalid (the URL, a type), exists (too many).
  Result<store::Webhook> add(const store::WebhookSettings& settings, std::string_view actor);
  // Errors: not_found, invalid.
  Result<store::Webhook> change(store::Id webhook, const store::WebhookSettings& settings, std::string_view actor);
  // Errors: not_found.
  Result<store::Webhook> rotate(store::Id webhook, std::int64_t keep_h, std::string_view actor);
  // Errors: not_found, refused (it is disabled).
  Result<store::WebhookDelivery> ping(store::Id webhook, std::string_view actor);
  Result<store::WebhookDelivery> replay(store::Id webhook, store::Id delivery, std::string_view actor);
  Result<std::uint64_t> replay_dead(store::Id webhook, std::int64_t since_ms, std::string_view actor);
  Result<void> remove(store::Id webhook, std::string_view actor);

  // Ends the thread; what is in transit is sent again at the next start.
  void stop();

 private:
  struct InFlight {
    store::Webhook webhook;
    store::WebhookDelivery delivery;
  };

  void round();
  void begin_due();
  void send(const store::Webhook& webhook, const store::WebhookDelivery& delivery);
  void note(const HttpOutcome& outcome);
  [[nodiscard]] store::DeliveryTry judge(const InFlight& sent, const HttpOutcome& outcome);
  void forget();
  [[nodiscard]] Result<void> check(const store::WebhookSettings& settings) const;
  [[nodiscard]] store::Stamp stamp(std::string_view actor) const;

  store::Store& store_;
  const Clock& clock_;
  HttpSender& sender_;
  WebhookSettings settings_;

  std::stop_source ends_;

  // Of the thread alone.
  LineEvents line_events_;
  std::map<store::Id, InFlight> on_;       // by delivery; one a webhook
  std::map<store::Id, feed::Time> rests_;  // webhooks whose last try could not be written
  std::minstd_rand random_{std::random_device{}()};
  feed::Time next_forget_{};
  RoundThread thread_;  // last: it uses all of the above
};

}  // namespace dripfeed::app
