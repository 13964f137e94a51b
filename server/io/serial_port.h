// Opening and setting a tty: raw, 8 bits (parity of 7-bit framings is made in software), exclusive, modem lines held
// across a close (HUPCL off). No Asio here: a file descriptor comes out.
#pragma once

#include <cstdint>
#include <expected>
#include <optional>
#include <string>

#include "server/app/ports/link.h"
#include "server/machine/profile.h"

namespace dripfeed::io {

// The descriptor, non-blocking; or one sentence: no such device, owned by another program, a baud rate that it does not
// have. Any rate may be asked for; the device says which it took (termios2).
// RTS/CTS, and XON/XOFF where the profile gives it to the kernel, are honored below us.
std::expected<int, std::string> open_serial_port(const machine::LineSettings& line);

// Locks an open port against other programs: TIOCEXCL keeps those out that know no lock, and root passes that, so a
// flock() decides between two of ours. A link to a pseudo-terminal must have a maker that lives.
std::expected<void, std::string> take_port(int descriptor, const std::string& path);

struct ModemLines {
  bool cts = true;
  bool dsr = true;
};
// Nothing where the device has no modem lines (a pty).
std::optional<ModemLines> read_modem_lines(int descriptor);

// Of the UART since it was plugged in; nothing where the device does not count (a pty).
std::optional<app::LineErrors> read_line_errors(int descriptor);

// Sets our RTS; false where the device has none (a pty).
bool set_rts(int descriptor, bool on);

// Characters that the driver holds unsent; nothing where it does not report. A pty always says 0.
std::optional<std::uint64_t> read_unsent(int descriptor);

// Before a close: what the driver holds must not follow later, a line that is held must not hold the close, and the far
// end of a pseudo-terminal, which lives on, is free for the next one.
void leave_port(int descriptor);

}  // namespace dripfeed::io
