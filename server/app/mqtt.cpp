// What a broker did not confirm is sent again over the next connection, so it comes at least once; the store says after
// a start how far the server before this one came.
#include "server/app/mqtt.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "server/app/out/topics.h"

namespace dripfeed::app {

namespace {

using namespace std::chrono_literals;

constexpr std::chrono::milliseconds kRound{100};
constexpr feed::Time kStatesEvery = 1s;
// Where several servers share a store: the last word of who lost a line may come after the first of who got it.
constexpr feed::Time kStatesAgain = 60s;
constexpr std::uint32_t kMostUnconfirmed = 32;
constexpr std::string_view kAlone = "mqtt";
constexpr std::string_view kServer = "dripfeed";

std::string reader_of(const std::string& node) {
  return node.empty() ? std::string(kAlone) : fmt::format("{} of node {}", kAlone, node);
}

// How far the broker has come; the first time it begins with what happens from now on, or where the server stopped that
// had the store alone before. Nothing: the store does not say.
std::optional<std::uint64_t> place_in(store::EventLog& log, const std::string& reader) {
  for (const std::string_view one : {std::string_view(reader), kAlone}) {
    const auto known = log.seen_by(one);
    if (!known) return std::nullopt;
    if (*known) return *known;
  }
  const auto newest = log.newest();
  if (!newest || !log.note_seen(reader, *newest)) return std::nullopt;
  return *newest;
}

}  // namespace

BrokerMessage mqtt_connection(const std::string& prefix, const std::string& node, bool is_online) {
  const std::string server = node.empty() ? std::string(kServer) : fmt::format("{}/{}", kServer, topic_level(node));
  return {.topic = fmt::format("{}/{}/connection", prefix, server),
          .payload = is_online ? "online" : "offline",
          .retained = true};
}

std::string why_no_prefix(std::string_view prefix) {
  constexpr std::size_t kLongest = 200;
  if (prefix.empty() || prefix.size() > kLongest) return "has 1 to 200 bytes";
  if (prefix.find_first_of("+#") != std::string_view::npos || prefix.front() == '$')
    return "has no + and # and does not begin with $: they have a meaning to the broker";
  if (prefix.front() == '/' || prefix.back() == '/' || prefix.find("//") != std::string_view::npos)
    return "has no level without a name: a/b, not /a//b/";
  if (std::ranges::any_of(prefix, [](char c) { return static_cast<unsigned char>(c) < 0x20; }))
    return "has no control characters";
  return {};
}

Mqtt::Mqtt(Application& application, Broker& broker, MqttSettings settings)
    : application_(application),
      store_(application.store()),
      clock_(application.clock()),
      broker_(broker),
      settings_(std::move(settings)),
      reader_(reader_of(settings_.node)),
      seen_(place_in(store_.event_log(), reader_)),
      thread_("mqtt", kRound, Urgency::usual, [this] { round(); }) {}

void Mqtt::stop() {
  if (ends_.request_stop()) {
    thread_.stop();
    broker_.leave(mqtt_connection(settings_.prefix, settings_.node, false));
  }
}

void Mqtt::round() {
  if (ends_.stop_requested()) return;
  if (!seen_) seen_ = place_in(store_.event_log(), reader_);
  if (!seen_) return;
  take_confirmed();
  const std::uint64_t connection = broker_.connection();
  if (connection == 0) return;
  if (connection != connection_) {
    connection_ = connection;
    greet();
  }
  show_states();
  send_events();
}

// What the broker before may have lost goes out again.
void Mqtt::greet() {
  broker_.publish(mqtt_connection(settings_.prefix, settings_.node, true));
  sent_.clear();
  next_states_ = {};
}

void Mqtt::show_states() {
  if (clock_.now() < next_states_) return;
  next_states_ = clock_.now() + kStatesEvery;
  leave_others();
  for (const auto& [machine, report] : application_.own_reports()) show(machine);
}

void Mqtt::show(const std::string& machine) {
  Shown& shown = states_[machine];
  std::string text = settings_.state(machine);
  const bool is_again = !settings_.node.empty() && clock_.now() >= shown.again_at;
  if (shown.connection == connection_ && shown.text == text && !is_again) return;
  const BrokerMessage message{
      .topic = fmt::format("{}/{}/state", settings_.prefix, topic_level(machine)), .payload = text, .retained = true};
  if (broker_.publish(message) != 0)
    shown = {.text = std::move(text), .connection = connection_, .again_at = clock_.now() + kStatesAgain};
}

// The last word about a line that went to another server: whose it is. Else what is retained here would state for ever
// how it stood.
void Mqtt::leave_others() {
  NodeLines* const nodes = application_.nodes();
  if (nodes == nullptr) return;
  for (auto shown = states_.begin(); shown != states_.end();) {
    const bool is_left = !nodes->is_ours(shown->first);
    if (is_left) show(shown->first);
    shown = is_left ? states_.erase(shown) : std::next(shown);
  }
}

// Notes how far all is confirmed: no number after one that is not.
void Mqtt::take_confirmed() {
  for (const std::int64_t number : broker_.confirmed()) {
    const auto found = std::ranges::find(sent_, number, &Sent::number);
    if (found != sent_.end()) found->is_confirmed = true;
  }
  const auto open = std::ranges::find(sent_, false, &Sent::is_confirmed);
  if (open == sent_.begin()) return;
  const std::uint64_t seen = std::prev(open)->seq;
  if (const auto noted = store_.event_log().note_seen(reader_, seen); !noted)
    return spdlog::warn("mqtt: {}", store::message_of(noted.error()));
  seen_ = seen;
  sent_.erase(sent_.begin(), open);
}

void Mqtt::send_events() {
  if (sent_.size() >= kMostUnconfirmed) return;
  const std::uint64_t after = sent_.empty() ? *seen_ : sent_.back().seq;
  const auto events = events_after(after, kMostUnconfirmed - static_cast<std::uint32_t>(sent_.size()));
  if (!events) return;
  for (const store::LoggedEvent& event : *events) {
    // A ping is for one webhook; it counts as sent.
    const bool is_ours = event.of.topic != store::EventTopic::webhook;
    const std::int64_t number =
        is_ours ? broker_.publish({.topic = topic_of(event), .payload = settings_.write(event)}) : 0;
    if (is_ours && number == 0) return;
    sent_.push_back({.number = number, .seq = event.seq, .is_confirmed = !is_ours});
  }
}

store::Result<std::vector<store::LoggedEvent>> Mqtt::events_after(std::uint64_t seq, std::uint32_t most) {
  store::Nodes* const nodes = store_.nodes();
  return nodes == nullptr ? store_.event_log().after(seq, most) : nodes->own_events(seq, most);
}

std::string Mqtt::topic_of(const store::LoggedEvent& event) const {
  const std::string level = event.of.machine.empty() ? std::string(kServer) : topic_level(event.of.machine);
  return fmt::format("{}/{}/event/{}/{}", settings_.prefix, level, store::name_of(event.of.topic), event.of.word);
}

}  // namespace dripfeed::app
