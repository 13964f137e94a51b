// One edge node of Sparkplug B: its topics, its numbers, and what it sends when it is born, has changed and dies. A
// machine is a device of it. It keeps the order of what it sends and sends nothing itself.
//
//   spBv1.0/GROUP/NBIRTH/NODE           NDEATH, and NCMD in the other direction
//   spBv1.0/GROUP/DBIRTH/NODE/MACHINE   DDATA, DDEATH
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/ports/broker.h"
#include "server/app/ports/sparkplug_payload.h"

namespace dripfeed::app {

using WriteSparkplug = std::function<std::string(const SparkplugPayload&)>;

class SparkplugNode {
 public:
  using Metrics = std::vector<SparkplugMetric>;

  // `group` and `node` as why_no_sparkplug_id() accepts them; `session` is the number of the last session, 0 to 255.
  SparkplugNode(std::string group, std::string node, std::uint8_t session, WriteSparkplug write);

  // The will of the next connection: a new session begins. To be asked for before each one.
  BrokerMessage next_will(std::int64_t now_ms);
  [[nodiscard]] std::uint8_t session() const { return session_; }
  // Of this session, for whoever leaves.
  [[nodiscard]] BrokerMessage death(std::int64_t now_ms) const;

  // Sets the order to 0.
  BrokerMessage birth(std::string_view software, std::int64_t now_ms);
  // `word` is DBIRTH, DDATA or DDEATH. Its place in the order counts once sent() confirms that it went out.
  [[nodiscard]] BrokerMessage of_device(std::string_view word, std::string_view machine, Metrics metrics,
                                        std::int64_t now_ms) const;
  void sent() { ++seq_; }

  // On which a host asks for all births again.
  [[nodiscard]] std::string command_topic() const { return topic("NCMD"); }

 private:
  [[nodiscard]] std::string topic(std::string_view word) const;

  std::string group_;
  std::string node_;
  WriteSparkplug write_;
  std::uint8_t session_;
  std::uint8_t seq_ = 0;
};

// "" or what is wrong with the id of a group or a node, as the end of a sentence.
std::string why_no_sparkplug_id(std::string_view id);

}  // namespace dripfeed::app
