// A standard rate goes by its own code, which every driver and every program that looks at the port knows; any other by
// BOTHER with the number itself. The driver writes back the rate that its divisor gives.
#include "server/io/serial_speed.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include <asm/ioctls.h>
#include <asm/termbits.h>
#include <fmt/format.h>
#include <sys/ioctl.h>

namespace dripfeed::io {

namespace {
constexpr std::uint64_t kTolerance_percent = 2;
constexpr std::uint32_t kLeast = 50;
constexpr std::uint32_t kMost = 12'000'000;
constexpr int kInputShift = 16;  // of CBAUD in c_cflag: the input's own rate

struct Standard {
  std::uint32_t baud;
  tcflag_t code;
};
constexpr std::array kStandard = {
    Standard{50, B50},         Standard{75, B75},         Standard{110, B110},       Standard{134, B134},
    Standard{150, B150},       Standard{200, B200},       Standard{300, B300},       Standard{600, B600},
    Standard{1200, B1200},     Standard{1800, B1800},     Standard{2400, B2400},     Standard{4800, B4800},
    Standard{9600, B9600},     Standard{19200, B19200},   Standard{38400, B38400},   Standard{57600, B57600},
    Standard{115200, B115200}, Standard{230400, B230400}, Standard{460800, B460800}, Standard{921600, B921600},
};

tcflag_t code_of(std::uint32_t baud) {
  const auto* const standard = std::ranges::find(kStandard, baud, &Standard::baud);
  return standard == kStandard.end() ? static_cast<tcflag_t>(BOTHER) : standard->code;
}

bool near(std::uint64_t asked, std::uint64_t got) {
  const std::uint64_t off = asked > got ? asked - got : got - asked;
  return off * 100 <= asked * kTolerance_percent;
}
}  // namespace

std::expected<void, std::string> set_speed(int descriptor, std::uint32_t baud) {
  if (baud < kLeast || baud > kMost) return std::unexpected(fmt::format("{} baud is not {}..{}", baud, kLeast, kMost));
  termios2 settings{};
  if (::ioctl(descriptor, TCGETS2, &settings) != 0) return std::unexpected(std::string("it is not a terminal device"));
  settings.c_cflag &= ~static_cast<tcflag_t>(CBAUD | (CBAUD << kInputShift));
  const tcflag_t code = code_of(baud);
  settings.c_cflag |= code | (code << kInputShift);
  settings.c_ispeed = baud;
  settings.c_ospeed = baud;
  if (::ioctl(descriptor, TCSETS2, &settings) != 0)
    return std::unexpected(fmt::format("it refused {} baud: {}", baud, std::strerror(errno)));
  if (::ioctl(descriptor, TCGETS2, &settings) != 0 || !near(baud, settings.c_ospeed))
    return std::unexpected(fmt::format("it took {} baud instead of {}", settings.c_ospeed, baud));
  return {};
}

}  // namespace dripfeed::io
