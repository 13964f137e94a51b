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
constexpr std::uint32_t kMostUnconfirmed = 32;
constexpr std::string_view kReader = "mqtt";
constexpr std::string_view kServer = "dripfeed";

// How far the broker has come; the first time it begins with what happens from now on. Nothing: the store does not say.
std::optional<std::uint64_t> place_in(store::EventLog& log) {
  const auto known = log.seen_by(kReader);
  if (!known) return std::nullopt;
  if (*known) return *known;
  const auto newest = log.newest();
  if (!newest || !log.note_seen(kReader, *newest)) return std::nullopt;
  return *newest;
}

}  // namespace

BrokerMessage mqtt_connection(const std::string& prefix, bool is_online) {
  return {.topic = fmt::format("{}/{}/connection", prefix, kServer),
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
      seen_(place_in(store_.event_log())),
      thread_("mqtt", kRound, Urgency::usual, [this] { round(); }) {}

void Mqtt::stop() {
  if (ends_.request_stop()) {
    thread_.stop();
    broker_.leave(mqtt_connection(settings_.prefix, false));
  }
}

void Mqtt::round() {
  if (ends_.stop_requested()) return;
  if (!seen_) seen_ = place_in(store_.event_log());
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
  broker_.publish(mqtt_connection(settings_.prefix, true));
  sent_.clear();
  next_states_ = {};
}

void Mqtt::show_states() {
  if (clock_.now() < next_states_) return;
  next_states_ = clock_.now() + kStatesEvery;
  for (const auto& [machine, report] : application_.reports()) {
    Shown& shown = states_[machine];
    std::string text = settings_.state(machine);
    if (shown.connection == connection_ && shown.text == text) continue;
    const BrokerMessage message{
        .topic = fmt::format("{}/{}/state", settings_.prefix, topic_level(machine)), .payload = text, .retained = true};
    if (broker_.publish(message) != 0) shown = {.text = std::move(text), .connection = connection_};
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
  if (const auto noted = store_.event_log().note_seen(kReader, seen); !noted)
    return spdlog::warn("mqtt: {}", store::message_of(noted.error()));
  seen_ = seen;
  sent_.erase(sent_.begin(), open);
}

void Mqtt::send_events() {
  if (sent_.size() >= kMostUnconfirmed) return;
  const std::uint64_t after = sent_.empty() ? *seen_ : sent_.back().seq;
  const auto events = store_.event_log().after(after, kMostUnconfirmed - static_cast<std::uint32_t>(sent_.size()));
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

std::string Mqtt::topic_of(const store::LoggedEvent& event) const {
  const std::string level = event.of.machine.empty() ? std::string(kServer) : topic_level(event.of.machine);
  return fmt::format("{}/{}/event/{}/{}", settings_.prefix, level, store::name_of(event.of.topic), event.of.word);
}

}  // namespace dripfeed::app
