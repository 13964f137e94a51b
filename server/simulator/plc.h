// A simulated PLC: a Modbus TCP server with the block mailbox's registers, which appends what comes exactly once and
// runs it at its own pace.
#pragma once

#include <cstdint>
#include <expected>
#include <memory>
#include <string>

#include "server/machine/link_url.h"
#include "server/simulator/block_clock.h"

namespace dripfeed::simulator {

struct PlcSettings {
  std::uint32_t buffer_bytes = 4096;
  double speed = 1.0;
  std::uint16_t boot_counter = 1;
  BlockClockSettings clock;
};

struct PlcReport {
  std::string text;  // appended in the present session
  std::uint64_t requests = 0;
  std::uint64_t blocks_run = 0;
  bool complete = false;  // the end was announced and everything was run
};

class Plc {
 public:
  // Listens on the URL's host and port (modbus-tcp://); or what the system said.
  static std::expected<std::unique_ptr<Plc>, std::string> start(const machine::LinkUrl& url,
                                                                const PlcSettings& settings);
  virtual ~Plc() = default;  // stops and joins
  [[nodiscard]] virtual PlcReport report() const = 0;
  [[nodiscard]] virtual std::uint16_t port() const = 0;

  Plc(const Plc&) = delete;
  Plc& operator=(const Plc&) = delete;

 protected:
  Plc() = default;
};

}  // namespace dripfeed::simulator
