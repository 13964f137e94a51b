// The library runs on the caller's thread alone, and not on one of its own: its thread and a second attempt to connect
// would free the same TLS session. connection() is where it reads, writes and connects, without waiting; the callbacks
// run inside it. It connects again after 1 s, 2 s, … 30 s.
#include "server/io/mqtt_broker.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <mosquitto.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

namespace dripfeed::io {

namespace {

constexpr int kKeepAlive_s = 20;
constexpr std::chrono::milliseconds kFirstDelay{1000};
constexpr std::chrono::milliseconds kLongestDelay{30000};
constexpr int kSubscribedQos = 1;
constexpr std::size_t kMostReceived = 16;  // until they are taken; later ones are dropped
constexpr int kLongestReceived = 64 * 1024;
constexpr std::size_t kMostInFlight = 64;
constexpr std::chrono::milliseconds kLeaveAtMost{1000};
constexpr std::chrono::milliseconds kWithoutWaiting{0};
constexpr std::chrono::milliseconds kAShortWait{10};
// In one call of connection(): as many as may be in flight, and some.
constexpr int kMostReads = 80;
constexpr const char* kSystemCertificates = "/etc/ssl/certs";

struct Place {
  std::string host;
  int port = 0;
  bool encrypted = false;
};

std::expected<Place, std::string> place_of(std::string_view url) {
  Place place;
  if (url.starts_with("mqtts://")) {
    place.encrypted = true;
    url.remove_prefix(8);
  } else if (url.starts_with("mqtt://")) {
    url.remove_prefix(7);
  } else {
    return std::unexpected(std::string("must begin with mqtt:// or mqtts://"));
  }
  if (url.ends_with('/')) url.remove_suffix(1);
  if (url.find_first_of("/?#@ ") != std::string_view::npos)
    return std::unexpected(std::string("names a host and a port only; user and password have options of their own"));
  place.port = place.encrypted ? 8883 : 1883;
  const std::size_t colon = url.rfind(':');
  const bool is_bare_v6 = url.ends_with(']');
  if (colon != std::string_view::npos && !is_bare_v6) {
    const std::string_view port = url.substr(colon + 1);
    const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), place.port);
    if (error != std::errc{} || end != port.data() + port.size() || place.port < 1 || place.port > 65535)
      return std::unexpected(fmt::format("has the port \"{}\", which is not 1..65535", port));
    url = url.substr(0, colon);
  }
  if (url.starts_with('[') && url.ends_with(']')) url = url.substr(1, url.size() - 2);
  if (url.empty()) return std::unexpected(std::string("names no host"));
  place.host = url;
  return place;
}

class MosquittoBroker final : public app::Broker {
 public:
  MosquittoBroker() = default;
  ~MosquittoBroker() override { mosquitto_destroy(client_); }

  // "" or what failed.
  std::string start(const MqttSettings& settings, const Place& place);

  [[nodiscard]] std::uint64_t connection() override {
    if (is_begun_) {
      exchange(kWithoutWaiting);
    } else {
      connect();
    }
    return is_up_ ? connections_ : 0;
  }

  std::int64_t publish(const app::BrokerMessage& message) override {
    if (!is_up_) return 0;
    int number = 0;
    const int done =
        mosquitto_publish(client_, &number, message.topic.c_str(), static_cast<int>(message.payload.size()),
                          message.payload.data(), message.qos, message.retained);
    return done == MOSQ_ERR_SUCCESS ? number : 0;
  }

  std::vector<std::int64_t> confirmed() override { return std::exchange(confirmed_, {}); }
  std::vector<app::BrokerMessage> received() override { return std::exchange(received_, {}); }

  void leave(const app::BrokerMessage& last) override {
    const std::int64_t number = publish(last);
    const auto is_open = [&] { return std::ranges::find(confirmed_, number) == confirmed_.end(); };
    const auto until = std::chrono::steady_clock::now() + kLeaveAtMost;
    while (number != 0 && is_up_ && is_open() && std::chrono::steady_clock::now() < until) exchange(kAShortWait);
    mosquitto_disconnect(client_);
  }

 private:
  static MosquittoBroker& self(void* user) { return *static_cast<MosquittoBroker*>(user); }
  static void on_connect(mosquitto* /*client*/, void* user, int code) noexcept {
    if (code != 0) return self(user).say(mosquitto_connack_string(code));
    ++self(user).connections_;
    self(user).is_up_ = true;
    self(user).delay_ = kFirstDelay;
    self(user).subscribe();
    self(user).say("the broker is connected");
  }
  static void on_publish(mosquitto* /*client*/, void* user, int number) noexcept {
    self(user).confirmed_.push_back(number);
  }
  static void on_message(mosquitto* /*client*/, void* user, const mosquitto_message* message) noexcept {
    self(user).take(*message);
  }
  void take(const mosquitto_message& message) noexcept {
    if (received_.size() >= kMostReceived || message.payloadlen > kLongestReceived) return;
    try {
      const auto* const bytes = static_cast<const char*>(message.payload);
      received_.push_back({.topic = message.topic,
                           .payload = std::string(bytes, bytes + message.payloadlen),
                           .retained = message.retain,
                           .qos = message.qos});
    } catch (const std::exception&) {
      return;  // no memory for a message
    }
  }
  void subscribe() noexcept {
    for (const std::string& topic : subscriptions_) {
      const int code = mosquitto_subscribe(client_, nullptr, topic.c_str(), kSubscribedQos);
      if (code != MOSQ_ERR_SUCCESS) say(mosquitto_strerror(code), spdlog::level::warn);
    }
  }
  // The same sentence once, however often it comes. The log has a queue: nothing waits for it.
  void say(std::string_view sentence, spdlog::level::level_enum level = spdlog::level::info) noexcept {
    try {
      if (std::exchange(last_sentence_, sentence) != sentence) spdlog::log(level, "mqtt: {}", sentence);
    } catch (const std::exception&) {
      return;  // no memory for a sentence
    }
  }

  void connect();
  void exchange(std::chrono::milliseconds patience);
  void lose(int code);

  mosquitto* client_ = nullptr;
  Place place_;
  bool is_begun_ = false;  // the library connects or is connected
  bool is_up_ = false;
  std::chrono::steady_clock::time_point next_try_{};
  std::chrono::milliseconds delay_ = kFirstDelay;
  std::uint64_t connections_ = 0;
  std::vector<std::int64_t> confirmed_;
  std::vector<app::BrokerMessage> received_;
  std::function<app::BrokerMessage()> will_;
  std::vector<std::string> subscriptions_;
  std::string last_sentence_;
};

std::string MosquittoBroker::start(const MqttSettings& settings, const Place& place) {
  client_ = mosquitto_new(settings.client_id.empty() ? nullptr : settings.client_id.c_str(), true, this);
  if (client_ == nullptr) return "the MQTT client cannot be created";
  const auto failed = [](int code) { return std::string(mosquitto_strerror(code)); };
  mosquitto_connect_callback_set(client_, on_connect);
  mosquitto_publish_callback_set(client_, on_publish);
  mosquitto_message_callback_set(client_, on_message);
  mosquitto_max_inflight_messages_set(client_, kMostInFlight);
  if (!settings.user.empty())
    if (const int code = mosquitto_username_pw_set(client_, settings.user.c_str(), settings.password.c_str());
        code != 0)
      return failed(code);
  will_ = settings.will;
  subscriptions_ = settings.subscriptions;
  if (place.encrypted) {
    const bool is_own = !settings.ca_file.empty();
    const int code = mosquitto_tls_set(client_, is_own ? settings.ca_file.c_str() : nullptr,
                                       is_own ? nullptr : kSystemCertificates, nullptr, nullptr, nullptr);
    if (code != 0) return "certificates: " + failed(code);
  }
  place_ = place;
  return {};
}

void MosquittoBroker::connect() {
  const auto now = std::chrono::steady_clock::now();
  if (now < next_try_) return;
  next_try_ = now + delay_;
  delay_ = std::min(2 * delay_, kLongestDelay);
  const app::BrokerMessage will = will_();
  int code = mosquitto_will_set(client_, will.topic.c_str(), static_cast<int>(will.payload.size()), will.payload.data(),
                                will.qos, will.retained);
  if (code == MOSQ_ERR_SUCCESS) code = mosquitto_connect_async(client_, place_.host.c_str(), place_.port, kKeepAlive_s);
  is_begun_ = code == MOSQ_ERR_SUCCESS;
  if (!is_begun_) lose(code);
}

// What has come and what waits to go out. The first call waits `patience` for the socket.
void MosquittoBroker::exchange(std::chrono::milliseconds patience) {
  std::size_t known = confirmed_.size();
  for (int reads = 0; reads < kMostReads; ++reads) {
    const bool was_up = is_up_;
    if (const int code = mosquitto_loop(client_, static_cast<int>(patience.count()), 1); code != MOSQ_ERR_SUCCESS)
      return lose(code);
    if (was_up == is_up_ && known == confirmed_.size()) return;
    known = confirmed_.size();
    patience = kWithoutWaiting;
  }
}

// The library closes what it has left of the connection when it makes the next one.
void MosquittoBroker::lose(int code) {
  is_begun_ = false;
  is_up_ = false;
  // errno is of the socket here, and the library's own sentence for it is none.
  say(fmt::format("{}:{}: {}", place_.host, place_.port,
                  code == MOSQ_ERR_ERRNO ? std::generic_category().message(errno) : mosquitto_strerror(code)),
      spdlog::level::warn);
}

}  // namespace

std::string why_no_mqtt_url(const std::string& url) {
  const auto place = place_of(url);
  return place ? std::string() : place.error();
}

std::expected<std::unique_ptr<app::Broker>, std::string> connect_mqtt(const MqttSettings& settings) {
  static const int kStarted = mosquitto_lib_init();
  if (kStarted != MOSQ_ERR_SUCCESS) return std::unexpected(std::string("libmosquitto does not start"));
  const auto place = place_of(settings.url);
  if (!place) return std::unexpected("the broker's URL " + place.error());
  if (!settings.ca_file.empty() && ::access(settings.ca_file.c_str(), R_OK) != 0)
    return std::unexpected(fmt::format("{} cannot be read", settings.ca_file));
  auto broker = std::make_unique<MosquittoBroker>();
  if (std::string why = broker->start(settings, *place); !why.empty()) return std::unexpected(std::move(why));
  return broker;
}

}  // namespace dripfeed::io
