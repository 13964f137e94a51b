// How a register bus is spoken to, from the options of its link URL:
// modbus-tcp://host:port/unit?timeout_ms=1000&poll_ms=500,
// modbus-rtu:/dev/ttyS1?baud=19200&framing=8E1&unit=N&timeout_ms=1000&poll_ms=500.
#pragma once

#include <cstdint>
#include <expected>
#include <string>

#include "protocol/tape_code/framing.h"
#include "server/machine/link_url.h"

namespace dripfeed::machine {

struct BusSettings {
  std::uint8_t unit = 1;
  std::uint32_t timeout_ms = 1000;  // for one answer; then the connection is made again
  std::uint32_t poll_ms = 500;      // between two looks at the machine's words while no job is on the line
  // RTU alone: what the standard asks for where nothing is stated.
  std::uint32_t baud = 19200;
  tape_code::Framing framing{.data_bits = 8, .parity = tape_code::Parity::even, .stop_bits = 1};
};

// Or one sentence that says which option is wrong. A rate is taken only if the library sets it: it makes 9600 of others
// and does not say so.
std::expected<BusSettings, std::string> bus_settings_of(const LinkUrl& url);

}  // namespace dripfeed::machine
