// Brings the states of machines to a message broker as Sparkplug B: this server is an edge node, each machine a device
// of it. A host may ask for all births again, and for nothing else: no command to a machine comes in by this door. A
// thread of its own does it, over a connection of its own, and no other thread waits for it.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/application.h"
#include "server/app/base/round_thread.h"
#include "server/app/out/sparkplug_node.h"
#include "server/app/ports/broker.h"

namespace dripfeed::app {

struct SparkplugSettings {
  std::string software;                                          // for a host: which program this is
  std::function<bool(std::string_view payload)> asks_rebirth{};  // whether a command asks for all births again
};

// What a host sees of a machine, always the same metrics in the same order.
std::vector<SparkplugMetric> sparkplug_metrics(const MachineStatus& status);

class Sparkplug {
 public:
  // The broker's will is that of `node`, and it subscribes to the node's commands.
  Sparkplug(Application& application, Broker& broker, SparkplugNode& node, SparkplugSettings settings);
  ~Sparkplug() { stop(); }
  Sparkplug(const Sparkplug&) = delete;
  Sparkplug& operator=(const Sparkplug&) = delete;

  // Informs the broker that the node dies, and ends the thread.
  void stop();

 private:
  using Metrics = SparkplugNode::Metrics;

  void round();
  [[nodiscard]] bool is_asked_for_rebirth();
  void bear();
  void show();
  void bury_all_but(const std::map<std::string, LineReport>& machines);
  bool send(const BrokerMessage& message);

  Application& application_;
  const Clock& clock_;
  Broker& broker_;
  SparkplugNode& node_;
  SparkplugSettings settings_;
  std::stop_source ends_;

  // Of the thread alone.
  std::uint64_t connection_ = 0;          // over which the node was born
  std::map<std::string, Metrics> shown_;  // by machine: what its host has
  bool is_rebirth_due_ = false;
  feed::Time next_birth_{};
  feed::Time next_show_{};
  RoundThread thread_;  // last: it uses all of the above
};

}  // namespace dripfeed::app
