// Simulated controls on real wires: pseudo-terminals and TCP ports, all served by one loop over poll(). Faults are made
// here, where a cable would be cut.
#pragma once

#include <cstdint>
#include <expected>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "server/machine/link_url.h"
#include "server/simulator/control.h"

namespace dripfeed::simulator {

struct StationSettings {
  machine::LinkUrl link;  // pty: or tcp-listen:
  ControlSettings control;
  Record record;
  std::optional<std::uint64_t> cut_after;  // the cable is cut after so many bytes (pty closed, TCP reset)
  double operator_s = 0.0;  // after so long without a character the operator presses RESET and START; 0: never
  bool repeat = false;      // and starts the next program after the end of one
};

class Fleet {
 public:
  Fleet();
  ~Fleet();
  Fleet(const Fleet&) = delete;
  Fleet& operator=(const Fleet&) = delete;

  // Makes the control and its pty (linked at the path) or listens; its index, or what is wrong or the system said.
  std::expected<std::size_t, std::string> add(StationSettings settings);
  // Serves all until `stop`, or until every control has finished, was cut or stands in an alarm (unless an operator
  // restarts it).
  void run(const std::stop_token& stop);
  [[nodiscard]] ControlReport report(std::size_t index) const;
  // "pty:/path" or "tcp://127.0.0.1:port": where a host reaches it.
  [[nodiscard]] std::string address(std::size_t index) const;

 private:
  class Station;
  std::vector<std::unique_ptr<Station>> stations_;
};

}  // namespace dripfeed::simulator
