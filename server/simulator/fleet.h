// Simulated controls on real wires: pseudo-terminals and TCP ports, all served by one loop. Faults of the line are made
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
  std::uint32_t seed = 1;    // of the line's faults; control.faults has them all
  double operator_s = 0.0;   // after so long without a character the operator presses RESET and START; 0: never
  double patience_s = 60.0;  // and after so long inside a program whose host is still there: it may be held
  bool repeat = false;       // and starts the next program after the end of one
};

class Fleet {
 public:
  // grid_ns: how often all controls are looked at together; 0: each as often as its line needs, woken by its input. A
  // coarse grid serves hundreds in one process: arrivals are dated from the look before, and a stop sign that leaves
  // late by the grid does not count against the host.
  explicit Fleet(Time_ns grid_ns = 0);
  ~Fleet();
  Fleet(const Fleet&) = delete;
  Fleet& operator=(const Fleet&) = delete;

  // Makes the control and its pty (linked at the path) or listens; its index, or what is wrong or the system said.
  std::expected<std::size_t, std::string> add(StationSettings settings);
  // Serves all until `stop`, or until every control has finished, was cut or stands in an alarm (unless an operator
  // restarts it).
  void run(const std::stop_token& stop);
  [[nodiscard]] std::size_t size() const { return stations_.size(); }
  [[nodiscard]] ControlReport report(std::size_t index) const;
  // "pty:/path" or "tcp://127.0.0.1:port": where a host reaches it.
  [[nodiscard]] std::string address(std::size_t index) const;

 private:
  class Station;
  void wait_for_input();
  void wait_for_grid();
  Time_ns grid_ns_;
  Time_ns next_look_ = 0;
  std::vector<std::unique_ptr<Station>> stations_;
};

}  // namespace dripfeed::simulator
