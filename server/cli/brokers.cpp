// The connections, and how each of them is made.
#include "server/cli/brokers.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "server/cli/cli.h"
#include "server/cli/host.h"
#include "server/io/mqtt_broker.h"
#include "server/io/sparkplug.h"
#include "server/json/records.h"

namespace dripfeed::cli {

namespace {

// A computer may run several servers of one store.
std::string own_name(const json::ServerOptions& options) {
  return options.node.empty() ? host_name() : fmt::format("{}-{}", host_name(), options.node);
}

// `ending` of the client's name: a broker knows each connection by a name of its own.
app::Result<std::unique_ptr<app::Broker>> connect_broker(const json::ServerOptions& options, std::string_view ending,
                                                         std::function<app::BrokerMessage()> will,
                                                         std::vector<std::string> subscriptions = {}) {
  auto password = password_in(options.mqtt_password_file);
  if (!password) return app::fail(app::ErrorCode::invalid, "--mqtt-password-file: " + password.error().text);
  const std::string id = options.mqtt_client_id.empty() ? "dripfeed-" + own_name(options) : options.mqtt_client_id;
  auto broker = io::connect_mqtt({.url = options.mqtt,
                                  .user = options.mqtt_user,
                                  .password = std::move(*password),
                                  .client_id = fmt::format("{}{}", id, ending),
                                  .ca_file = options.mqtt_ca,
                                  .will = std::move(will),
                                  .subscriptions = std::move(subscriptions)});
  if (!broker) return app::fail(app::ErrorCode::invalid, "--mqtt: " + broker.error());
  return std::move(*broker);
}

// The number of the last session, which outlives the server: a host knows two sessions by it. 0 where no file
// says.
std::uint8_t last_session(const std::string& path) {
  unsigned number = 0;
  std::ifstream(path) >> number;
  return static_cast<std::uint8_t>(number);
}

}  // namespace

app::Result<void> Brokers::start(app::Application& application, const json::ServerOptions& options,
                                 app::WriteEvent write_event) {
  if (options.mqtt.empty()) return {};
  auto broker = connect_broker(options, "", [prefix = options.mqtt_prefix, node = options.node] {
    return app::mqtt_connection(prefix, node, false);
  });
  if (!broker) return std::unexpected(broker.error());
  broker_ = std::move(*broker);
  auto state = [&application](const std::string& machine) { return json::machine_status(application.status(machine)); };
  mqtt_.emplace(
      application, *broker_,
      app::MqttSettings{
          .prefix = options.mqtt_prefix, .node = options.node, .write = std::move(write_event), .state = state});
  return options.sparkplug_group.empty() ? app::Result<void>() : start_sparkplug(application, options);
}

void Brokers::stop() {
  if (mqtt_) mqtt_->stop();
  if (sparkplug_) sparkplug_->stop();
}

app::Result<void> Brokers::start_sparkplug(app::Application& application, const json::ServerOptions& options) {
  const app::Clock& clock = application.clock();
  const std::string sessions = (std::filesystem::path(options.data) / "sparkplug-session").string();
  node_.emplace(options.sparkplug_group, options.sparkplug_node.empty() ? own_name(options) : options.sparkplug_node,
                last_session(sessions), io::write_sparkplug);
  const auto next_will = [this, &clock, sessions] {
    app::BrokerMessage will = node_->next_will(clock.wall_ms());
    if (!(std::ofstream(sessions) << static_cast<unsigned>(node_->session()) << '\n' << std::flush))
      spdlog::warn("sparkplug: {} cannot be written: a host may mistake the next start for this one", sessions);
    return will;
  };
  auto broker = connect_broker(options, "-sparkplug", next_will, {node_->command_topic()});
  if (!broker) return std::unexpected(broker.error());
  sparkplug_broker_ = std::move(*broker);
  sparkplug_.emplace(application, *sparkplug_broker_, *node_,
                     app::SparkplugSettings{.software = fmt::format("dripfeed {}", std::string_view(kVersion)),
                                            .asks_rebirth = io::asks_for_rebirth});
  return {};
}

}  // namespace dripfeed::cli
