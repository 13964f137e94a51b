// What lies between the control and the program at the host: the delays of the receivers that hosts have. The other
// direction needs no table: what the host wrote before it saw a stop sign arrives all the same, each character in its
// time, whatever holds it: a FIFO (16550: 16 characters, FTDI: 128) or a device server's buffer (1 KB).
#pragma once

#include <cstdint>
#include <expected>
#include <string>
#include <string_view>

namespace dripfeed::simulator {

struct Uart {
  std::string_view name;
  // Between the last bit of a lone character from the control and the host's read of it.
  std::uint32_t chars = 0;
  std::int64_t fixed_ns = 0;
};

// 16550: the receiver's time-out of 4 characters. ftdi: its latency timer of 16 ms. device-server: both a time-out of 4
// characters and 2 ms of network. ideal: nothing but the character's own time, which all have.
std::expected<Uart, std::string> find_uart(std::string_view name);

}  // namespace dripfeed::simulator
