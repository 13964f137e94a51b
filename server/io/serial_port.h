// Opening and setting a tty: raw, 8 bits (parity of 7-bit framings is made in software), exclusive, modem lines held
// across a close (HUPCL off). No Asio here: a file descriptor comes out.
#pragma once

#include <cstdint>
#include <expected>
#include <optional>
#include <string>

#include "server/machine/profile.h"

namespace dripfeed::io {

// The descriptor, non-blocking; or one sentence: no such device, owned by another program, a baud rate that it does not
// have.
std::expected<int, std::string> open_serial_port(const std::string& path, std::uint32_t baud,
                                                 const tape_code::Framing& framing);

struct ModemLines {
  bool cts = true;
  bool dsr = true;
};
// Nothing where the device has no modem lines (a pty).
std::optional<ModemLines> read_modem_lines(int descriptor);

// Characters that the driver holds unsent; nothing where it does not tell. A pty always says 0.
std::optional<std::uint64_t> read_unsent(int descriptor);

}  // namespace dripfeed::io
