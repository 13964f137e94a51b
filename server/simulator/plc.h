// A simulated PLC: a Modbus server, TCP or RTU, with the block mailbox's registers and the machine's words, which
// appends what comes exactly once and runs it at its own pace. Next to the map (protocol/modbus) it has a panel, which
// a test or a person writes by any Modbus client:
//   192      what the machine does: 0 by itself, else a state of the map (3 held, 4 alarm, 5 emergency stop, 6 manual)
//   193-194  its alarm number
//   195      what the doorbell asks for, 196-197 the program's number
//   198      the doorbell's count: another one rings
#pragma once

#include <cstdint>
#include <expected>
#include <memory>
#include <string>

#include "server/machine/link_url.h"
#include "server/simulator/block_clock.h"
#include "server/simulator/fault.h"

namespace dripfeed::simulator {

inline constexpr int kPanelAddress = 192;

struct PlcSettings {
  std::uint32_t buffer_bytes = 4096;
  double speed = 1.0;
  std::uint16_t boot_counter = 1;
  std::size_t units = 1;  // from the URL's on, all on one connection or line
  bool has_words = true;  // the machine's words; without them a longer read is an illegal address
  BlockClockSettings clock;
  Faults faults{};  // those of a PLC
};

struct PlcReport {
  std::string text;  // appended in the present session
  std::uint64_t requests = 0;
  std::uint64_t blocks_run = 0;
  bool complete = false;  // the end was announced and everything was run
};

class Plc {
 public:
  // Listens on the URL's host and port (modbus-tcp://); or speaks on its serial line (modbus-rtu:), which is a
  // pseudo-terminal linked there where no such device is. Or what the system said.
  static std::expected<std::unique_ptr<Plc>, std::string> start(const machine::LinkUrl& url,
                                                                const PlcSettings& settings);
  virtual ~Plc() = default;                                                 // stops and joins
  [[nodiscard]] virtual PlcReport report(std::size_t index = 0) const = 0;  // of the unit
  [[nodiscard]] virtual std::uint16_t port() const = 0;                     // 0 on a serial line

  Plc(const Plc&) = delete;
  Plc& operator=(const Plc&) = delete;

 protected:
  Plc() = default;
};

}  // namespace dripfeed::simulator
