// An MQTT broker (3.1.1), on libmosquitto.
#pragma once

#include <expected>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "server/app/ports/broker.h"

namespace dripfeed::io {

struct MqttSettings {
  std::string url{};   // mqtt://host[:port], mqtts://host[:port]
  std::string user{};  // "": none
  std::string password{};
  std::string client_id{};
  std::string ca_file{};  // PEM; "": whom the system believes
  // What the broker says when the server is gone. Asked for before each connection, on the thread that uses the broker.
  std::function<app::BrokerMessage()> will{};
  std::vector<std::string> subscriptions{};
};

// "" or what is wrong with the URL, as the end of a sentence.
std::string why_no_mqtt_url(const std::string& url);
// Begins to connect, and returns; or one sentence that says what is wrong with the settings.
std::expected<std::unique_ptr<app::Broker>, std::string> connect_mqtt(const MqttSettings& settings);

}  // namespace dripfeed::io
