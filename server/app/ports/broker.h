// A message broker, as the application needs it: messages go out, and few come in. The connection is kept and made
// again after this.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace dripfeed::app {

struct BrokerMessage {
  std::string topic;
  std::string payload;
  bool retained = false;
  int qos = 1;  // 0 or 1
};

// All on one thread, which may wait for a name to be resolved, and not for the broker.
class Broker {
 public:
  Broker() = default;
  Broker(const Broker&) = delete;
  Broker& operator=(const Broker&) = delete;
  virtual ~Broker() = default;

  // 0 while there is no connection; else another number for each one. It reads, writes and connects where it is time,
  // and at no other time: ask for it again and again.
  [[nodiscard]] virtual std::uint64_t connection() = 0;
  // Over the connection that is up. A number that confirmed() gives once the broker has it, or, by QoS 0, once it is
  // written; 0: not sent.
  virtual std::int64_t publish(const BrokerMessage& message) = 0;
  // What the broker has confirmed since the last call, on any connection.
  virtual std::vector<std::int64_t> confirmed() = 0;
  // What came on a topic that was subscribed to since the last call. Most is dropped where much comes.
  virtual std::vector<BrokerMessage> received() = 0;
  // Says that the server goes, and ends the connection. Waits a second at most.
  virtual void leave(const BrokerMessage& last) = 0;
};

}  // namespace dripfeed::app
