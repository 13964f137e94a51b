// What a message broker gets from the server: states and events as JSON, and the states as Sparkplug B where a group is
// named. Each has a connection of its own.
#pragma once

#include <memory>
#include <optional>

#include "server/app/application.h"
#include "server/app/mqtt.h"
#include "server/app/out/sparkplug_node.h"
#include "server/app/sparkplug.h"
#include "server/json/server_options.h"

namespace dripfeed::cli {

class Brokers {
 public:
  // Nothing where no broker is named. Errors: invalid (what the options have of the broker).
  app::Result<void> start(app::Application& application, const json::ServerOptions& options,
                          app::WriteEvent write_event);
  // Informs the broker that the server goes.
  void stop();

 private:
  app::Result<void> start_sparkplug(app::Application& application, const json::ServerOptions& options);

  std::unique_ptr<app::Broker> broker_;
  std::optional<app::Mqtt> mqtt_;
  std::optional<app::SparkplugNode> node_;
  std::unique_ptr<app::Broker> sparkplug_broker_;
  std::optional<app::Sparkplug> sparkplug_;
};

}  // namespace dripfeed::cli
