// What lies between the control and the program at the host: the delays of the receivers that hosts have.
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
  // Characters that the host's side takes from its program before they are on the line: they follow a DC3 whatever the
  // host does.
  std::uint32_t fifo_chars = 0;
};

// 16550: the receiver's time-out of 4 characters, a FIFO of 16. ftdi: its latency timer of 16 ms. device-server: 2 ms
// of network and a buffer of 1 KB. ideal: nothing but the character's own time, which all have.
std::expected<Uart, std::string> find_uart(std::string_view name);

}  // namespace dripfeed::simulator
