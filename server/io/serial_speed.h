// The speed of a tty, any number of baud: the kernel's termios2, whose header does not bear <termios.h> next to it.
#pragma once

#include <cstdint>
#include <expected>
#include <string>

namespace dripfeed::io {

// Sets the speed in both directions and reads back what the device took; or why not: it refused, or took another one
// that is further away than 2 %.
std::expected<void, std::string> set_speed(int descriptor, std::uint32_t baud);

}  // namespace dripfeed::io
