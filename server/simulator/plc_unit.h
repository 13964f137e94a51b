// One unit of a simulated PLC: its registers, the receiver that reads them, and the machine that runs what came. Locks
// for itself; sockets and lines are not its matter.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "server/simulator/plc.h"
#include "server/simulator/plc_port.h"

namespace dripfeed::simulator {

class PlcUnit {
 public:
  static std::unique_ptr<PlcUnit> make(const PlcSettings& settings, std::uint8_t unit, bool is_serial);
  virtual ~PlcUnit() = default;
  [[nodiscard]] virtual std::uint8_t number() const = 0;
  // The answer's frame, valid until the next call; none: it does not answer.
  virtual std::span<const std::uint8_t> answer(const PlcRequest& request) = 0;
  // Runs what is due by now.
  virtual void run() = 0;
  // Whether it was restarted since the last call.
  virtual bool take_restarted() = 0;
  [[nodiscard]] virtual PlcReport report() const = 0;

  PlcUnit(const PlcUnit&) = delete;
  PlcUnit& operator=(const PlcUnit&) = delete;

 protected:
  PlcUnit() = default;
};

}  // namespace dripfeed::simulator
