// How requests reach a simulated PLC: sockets of several clients, or one serial line. Gathers bytes into whole requests
// and sends answers; what a request means is the PLC's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "server/machine/link_url.h"

namespace dripfeed::simulator {

// A whole request as it came (with MBAP header, or with CRC).
struct PlcRequest {
  std::span<const std::uint8_t> frame;
  std::size_t function_at = 0;  // the unit is right before it
  [[nodiscard]] std::uint8_t unit() const { return frame[function_at - 1]; }
  [[nodiscard]] std::uint8_t function() const { return frame[function_at]; }
};
// Gives the answer's frame; none: nothing is answered.
using PlcAnswer = std::function<std::span<const std::uint8_t>(const PlcRequest&)>;

class PlcPort {
 public:
  PlcPort() = default;
  PlcPort(const PlcPort&) = delete;
  PlcPort& operator=(const PlcPort&) = delete;
  virtual ~PlcPort() = default;
  // Waits for input, at most so long; answers each whole request that came.
  virtual void serve(int wait_ms, const PlcAnswer& answer) = 0;
  // The PLC was restarted: connections are lost, what was half here is gone.
  virtual void drop_all() = 0;
  [[nodiscard]] virtual std::uint16_t port() const { return 0; }
  [[nodiscard]] virtual bool is_serial() const { return false; }
};

using OpenedPort = std::expected<std::unique_ptr<PlcPort>, std::string>;
OpenedPort open_tcp_port(const machine::LinkUrl& url);
OpenedPort open_rtu_port(const machine::LinkUrl& url);

// Of RTU (Modbus over Serial Line 1.02, 6.2.2): over a frame without its last two bytes, which hold it, low byte first.
std::uint16_t crc_16(std::span<const std::uint8_t> bytes);

}  // namespace dripfeed::simulator
