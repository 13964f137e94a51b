// termios by hand: Asio's serial_port sets one thing a call, fails on ptys and cannot say what it changed.
#include "server/io/serial_port.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

namespace dripfeed::io {

namespace {

struct Speed {
  std::uint32_t baud;
  speed_t code;
};
constexpr std::array kSpeeds = {
    Speed{300, B300},     Speed{600, B600},       Speed{1200, B1200},     Speed{2400, B2400},
    Speed{4800, B4800},   Speed{9600, B9600},     Speed{19200, B19200},   Speed{38400, B38400},
    Speed{57600, B57600}, Speed{115200, B115200}, Speed{230400, B230400},
};

std::optional<speed_t> speed_code(std::uint32_t baud) {
  for (const Speed& speed : kSpeeds) {
    if (speed.baud == baud) return speed.code;
  }
  return std::nullopt;
}

std::string system_text() { return std::strerror(errno); }

std::expected<void, std::string> set_line(int descriptor, speed_t speed, const tape_code::Framing& framing) {
  termios settings{};
  if (::tcgetattr(descriptor, &settings) != 0) return std::unexpected(std::string("it is not a terminal device"));
  ::cfmakeraw(&settings);
  settings.c_iflag &= ~static_cast<tcflag_t>(IXON | IXOFF | IXANY | INPCK | ISTRIP);
  settings.c_cflag &= ~static_cast<tcflag_t>(CSIZE | PARENB | PARODD | CSTOPB | CRTSCTS | HUPCL);
  settings.c_cflag |= CS8 | CREAD | CLOCAL;
  if (framing.stop_bits == 2) settings.c_cflag |= CSTOPB;
  if (framing.data_bits == 8 && framing.parity != tape_code::Parity::none) {
    settings.c_cflag |= PARENB;
    if (framing.parity == tape_code::Parity::odd) settings.c_cflag |= PARODD;
  }
  settings.c_cc[VMIN] = 1;
  settings.c_cc[VTIME] = 0;
  ::cfsetispeed(&settings, speed);
  ::cfsetospeed(&settings, speed);
  if (::tcsetattr(descriptor, TCSANOW, &settings) != 0)
    return std::unexpected("it refused the settings: " + system_text());
  return {};
}

// DTR and RTS say to the control that somebody is there (Fanuc alarm 086 otherwise). Devices without modem lines
// refuse; that is no fault.
void raise_modem_lines(int descriptor) {
  int lines = TIOCM_DTR | TIOCM_RTS;
  ::ioctl(descriptor, TIOCMBIS, &lines);
}

}  // namespace

std::expected<int, std::string> open_serial_port(const std::string& path, std::uint32_t baud,
                                                 const tape_code::Framing& framing) {
  const auto speed = speed_code(baud);
  if (!speed) return std::unexpected(fmt::format("{}: {} baud is not a standard rate", path, baud));
  const int descriptor = ::open(path.c_str(), O_RDWR | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (descriptor < 0) return std::unexpected(fmt::format("cannot open {}: {}", path, system_text()));
  std::expected<void, std::string> ready;
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    ready = std::unexpected(std::string("another program owns this line"));
  } else {
    ready = set_line(descriptor, *speed, framing);
  }
  if (!ready) {
    ::close(descriptor);
    return std::unexpected(fmt::format("{}: {}", path, ready.error()));
  }
  // Keeps programs out that know nothing of flock; root passes it, so the lock above decides between two of us.
  ::ioctl(descriptor, TIOCEXCL);
  raise_modem_lines(descriptor);
  return descriptor;
}

std::optional<ModemLines> read_modem_lines(int descriptor) {
  int lines = 0;
  if (::ioctl(descriptor, TIOCMGET, &lines) != 0) return std::nullopt;
  return ModemLines{.cts = (lines & TIOCM_CTS) != 0, .dsr = (lines & TIOCM_DSR) != 0};
}

std::optional<std::uint64_t> read_unsent(int descriptor) {
  int count = 0;
  if (::ioctl(descriptor, TIOCOUTQ, &count) != 0 || count < 0) return std::nullopt;
  return static_cast<std::uint64_t>(count);
}

}  // namespace dripfeed::io
