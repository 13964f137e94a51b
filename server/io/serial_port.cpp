// termios by hand: Asio's serial_port sets one thing a call, fails on ptys and cannot say what it changed.
#include "server/io/serial_port.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/serial.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include "server/io/pty_owner.h"
#include "server/io/serial_speed.h"

namespace dripfeed::io {

namespace {

std::string system_text() { return std::strerror(errno); }

// The kernel's XOFF compares whole bytes, so a DC3 with parity (0x93) stops it only when bit 7 is taken off on the path
// in; the parity of what comes in is then not seen.
void let_kernel_hold(termios& settings, const machine::LineSettings& line) {
  settings.c_iflag |= IXON;
  if (line.framing.data_bits == 7 || line.code == tape_code::Code::iso) settings.c_iflag |= ISTRIP;
  settings.c_cc[VSTART] = line.xon;
  settings.c_cc[VSTOP] = line.xoff;
}

std::expected<void, std::string> set_line(int descriptor, const machine::LineSettings& line) {
  const tape_code::Framing& framing = line.framing;
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
  if (feed::cts_is_flow(line.flow)) settings.c_cflag |= CRTSCTS;
  if (line.xoff_by == feed::XoffBy::kernel) let_kernel_hold(settings, line);
  settings.c_cc[VMIN] = 1;
  settings.c_cc[VTIME] = 0;
  if (::tcsetattr(descriptor, TCSANOW, &settings) != 0)
    return std::unexpected("it refused the settings: " + system_text());
  return {};
}

// DTR and RTS say to the control that a person is there (Fanuc alarm 086 otherwise). Devices without modem lines
// refuse; that is no fault.
void raise_modem_lines(int descriptor) {
  int lines = TIOCM_DTR | TIOCM_RTS;
  ::ioctl(descriptor, TIOCMBIS, &lines);
}

}  // namespace

std::expected<void, std::string> take_port(int descriptor, const std::string& path) {
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0)
    return std::unexpected(std::string("another program owns this line"));
  if (auto made = check_pty_owner(path, descriptor); !made) return made;
  if (::ioctl(descriptor, TIOCEXCL) != 0) return std::unexpected(std::string("it is not a terminal device"));
  return {};
}

std::expected<int, std::string> open_serial_port(const machine::LineSettings& line) {
  const std::string& path = line.link.path;
  const int descriptor = ::open(path.c_str(), O_RDWR | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (descriptor < 0) return std::unexpected(fmt::format("cannot open {}: {}", path, system_text()));
  std::expected<void, std::string> ready = take_port(descriptor, path);
  if (ready) ready = set_line(descriptor, line);
  if (ready) ready = set_speed(descriptor, line.baud);
  if (!ready) {
    ::close(descriptor);
    return std::unexpected(fmt::format("{}: {}", path, ready.error()));
  }
  raise_modem_lines(descriptor);
  return descriptor;
}

std::optional<ModemLines> read_modem_lines(int descriptor) {
  int lines = 0;
  if (::ioctl(descriptor, TIOCMGET, &lines) != 0) return std::nullopt;
  return ModemLines{.cts = (lines & TIOCM_CTS) != 0, .dsr = (lines & TIOCM_DSR) != 0};
}

bool set_rts(int descriptor, bool on) {
  int line = TIOCM_RTS;
  return ::ioctl(descriptor, on ? TIOCMBIS : TIOCMBIC, &line) == 0;
}

std::optional<std::uint64_t> read_unsent(int descriptor) {
  int count = 0;
  if (::ioctl(descriptor, TIOCOUTQ, &count) != 0 || count < 0) return std::nullopt;
  return static_cast<std::uint64_t>(count);
}

std::optional<app::LineErrors> read_line_errors(int descriptor) {
  serial_icounter_struct counted{};
  if (::ioctl(descriptor, TIOCGICOUNT, &counted) != 0) return std::nullopt;
  const auto count = [](int n) { return static_cast<std::uint64_t>(n < 0 ? 0 : n); };
  return app::LineErrors{.parity = count(counted.parity),
                         .framing = count(counted.frame),
                         .overrun = count(counted.overrun) + count(counted.buf_overrun),
                         .breaks = count(counted.brk)};
}

void leave_port(int descriptor) {
  ::tcflush(descriptor, TCOFLUSH);
  ::ioctl(descriptor, TIOCNXCL);
}

}  // namespace dripfeed::io
