// Webhooks: who is to be informed of events by HTTP, and the deliveries to them. A delivery is a row before it is tried
// and until long after its end, so that no end of the server loses one; the receiver may get one twice, never none.
#pragma once

#include <optional>
#include <vector>

#include "store/event_log.h"

namespace dripfeed::store {

// What a person decides.
struct WebhookSettings {
  std::string url{};
  std::vector<std::string> types{};  // "job.done", "job.*", "*"
  std::string description{};
  bool enabled = true;
  bool local = false;  // it may lie in a private network or on this computer
};

struct Webhook {
  Id id = 0;
  WebhookSettings of;
  std::string secret;      // signs
  std::string old_secret;  // signs as well, until old_until_ms; "" none
  std::int64_t old_until_ms = 0;
  std::string why_disabled;  // "" where a person did it, or it is enabled
  std::string created_by;
  std::int64_t created_at_ms = 0;
  std::int64_t changed_at_ms = 0;
  std::uint64_t seen = 0;    // events up to here are deliveries, as far as it wants them
  std::uint64_t missed = 0;  // events that were forgotten before their delivery was made
};

// Whether one of these types is or covers the event's.
bool wants(const std::vector<std::string>& types, std::string_view type);

enum class DeliveryState : std::uint8_t {
  pending,    // to be tried, for the first time or again
  delivered,  // the receiver took it
  dead,       // all tries failed, or the receiver is gone; a person may replay it
};
template <>
inline constexpr std::array<std::string_view, 3> kNames<DeliveryState>{"pending", "delivered", "dead"};

struct WebhookDelivery {
  Id id = 0;
  Id webhook = 0;
  LoggedEvent event;
  DeliveryState state = DeliveryState::pending;
  std::uint32_t attempts = 0;     // since it was made or replayed
  std::int64_t next_at_ms = 0;    // of the next try; 0: none
  std::int64_t last_at_ms = 0;    // of the last one; 0: none yet
  std::uint32_t last_status = 0;  // of HTTP; 0: no answer came
  std::string last_error;         // why no answer came, for people
};

// What came of a try.
struct DeliveryTry {
  DeliveryState state = DeliveryState::pending;
  std::int64_t next_at_ms = 0;  // only with pending
  std::int64_t at_ms = 0;
  std::uint32_t status = 0;
  std::string error{};
};

struct DeliveryFilter {
  std::optional<DeliveryState> state{};
};

class Webhooks : public Repository {
 public:
  // It is informed of what happens from now on. Errors: invalid_value (no url, type or secret), exists (more than
  // `most`).
  virtual Result<Webhook> add(const WebhookSettings& settings, std::string_view secret, std::uint64_t most,
                              const Stamp& by) = 0;
  // One that is enabled again is informed of what happens from then on; what waited is tried again. Errors: not_found.
  virtual Result<Webhook> change(Id webhook, const WebhookSettings& settings, const Stamp& by) = 0;
  // A new secret; the previous one also signs until then. Errors: not_found, invalid_value.
  virtual Result<Webhook> rotate(Id webhook, std::string_view secret, std::int64_t old_until_ms, const Stamp& by) = 0;
  // By the server, because the receiver says that it is gone. Errors: not_found.
  virtual Result<Webhook> disable(Id webhook, std::string_view why, const Stamp& by) = 0;
  // With its deliveries. Errors: not_found.
  virtual Result<void> remove(Id webhook, const Stamp& by) = 0;
  virtual Result<Webhook> get(Id webhook) = 0;
  // Newest first.
  virtual Result<Page<Webhook>> list(const PageRequest& page) = 0;
  virtual Result<std::vector<Webhook>> enabled() = 0;

  // Makes deliveries of the events that came since the last call, for each webhook that is enabled and has fewer than
  // `most_pending` that wait. How many webhooks came further.
  virtual Result<std::uint64_t> take_new(std::int64_t now_ms, std::uint64_t most_pending) = 0;
  // An event of its own, to it alone. Errors: not_found, refused_transition (it is disabled).
  virtual Result<WebhookDelivery> ping(Id webhook, const Stamp& by) = 0;
  // The pending one of this webhook that is due first, if any is due now.
  virtual Result<std::optional<WebhookDelivery>> due(Id webhook, std::int64_t now_ms) = 0;
  virtual Result<void> note_try(Id delivery, const DeliveryTry& tried) = 0;
  // Tries it again, with all tries. Errors: not_found.
  virtual Result<WebhookDelivery> replay(Id webhook, Id delivery, const Stamp& by) = 0;
  // All dead ones whose event is from then or later. How many. Errors: not_found.
  virtual Result<std::uint64_t> replay_dead(Id webhook, std::int64_t since_ms, const Stamp& by) = 0;
  // Newest first. Errors: not_found (no such webhook).
  virtual Result<Page<WebhookDelivery>> deliveries(Id webhook, const PageRequest& page,
                                                   const DeliveryFilter& filter = {}) = 0;
};

}  // namespace dripfeed::store
