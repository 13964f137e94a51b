// One serial line. A frame's length follows from its function; what fits none, or has a wrong check sum, is passed over
// with the next silence, as the standard has it (there 3.5 characters; here what a scheduler can keep).
#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <optional>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include "server/io/pty_owner.h"
#include "server/machine/bus_settings.h"
#include "server/simulator/plc_port.h"
#include "server/simulator/wire.h"

namespace dripfeed::simulator {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kLongest = 256;
constexpr std::size_t kCrcBytes = 2;
constexpr std::chrono::milliseconds kSilence{20};
constexpr std::chrono::milliseconds kNoPeer{5};

struct FrameRow {
  std::uint8_t function;
  std::size_t length;                   // with unit and CRC; without the data that a count announces
  std::optional<std::size_t> count_at;  // of data bytes
};
constexpr std::array kFrames = {
    FrameRow{1, 8, {}}, FrameRow{2, 8, {}}, FrameRow{3, 8, {}}, FrameRow{4, 8, {}},   FrameRow{5, 8, {}},
    FrameRow{6, 8, {}}, FrameRow{15, 9, 6}, FrameRow{16, 9, 6}, FrameRow{22, 10, {}}, FrameRow{23, 13, 10},
};

// Nothing: it is not decided yet, or no such function.
std::optional<std::size_t> length_of(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < 2) return std::nullopt;
  const auto row = std::ranges::find(kFrames, bytes[1], &FrameRow::function);
  if (row == kFrames.end() || (row->count_at && bytes.size() <= *row->count_at)) return std::nullopt;
  return row->length + (row->count_at ? bytes[*row->count_at] : 0);
}

std::optional<speed_t> speed_of(std::uint32_t baud) {
  struct Row {
    std::uint32_t baud;
    speed_t speed;
  };
  static constexpr std::array kRows = {Row{1200, B1200},   Row{2400, B2400},    Row{4800, B4800},
                                       Row{9600, B9600},   Row{19200, B19200},  Row{38400, B38400},
                                       Row{57600, B57600}, Row{115200, B115200}};
  const auto row = std::ranges::find(kRows, baud, &Row::baud);
  if (row == kRows.end()) return std::nullopt;
  return row->speed;
}

// A device that is there: a tty, or one end of another's pair of pseudo-terminals.
class DeviceWire final : public Wire {
 public:
  DeviceWire(int file, std::string path) : file_(file), path_(std::move(path)) {}
  ~DeviceWire() override { cut(); }
  [[nodiscard]] int descriptor() const override { return file_; }
  std::size_t read(std::span<std::byte> into) override {
    const ssize_t count = ::read(file_, into.data(), into.size());
    return count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  void write(std::span<const std::byte> bytes) override {
    static_cast<void>(!::write(file_, bytes.data(), bytes.size()));  // what is not sent is lost, as on a wire
  }
  void cut() override {
    if (file_ >= 0) ::close(file_);
    file_ = -1;
  }
  [[nodiscard]] std::string address() const override { return path_; }

 private:
  int file_;
  std::string path_;
};

std::expected<std::unique_ptr<Wire>, std::string> open_device(const machine::LinkUrl& url,
                                                              const machine::BusSettings& bus) {
  const int file = ::open(url.path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  const auto speed = speed_of(bus.baud);
  termios settings{};
  if (file < 0 || !speed || ::tcgetattr(file, &settings) != 0) {
    const std::string why = speed ? std::strerror(errno) : "this rate is not simulated";
    if (file >= 0) ::close(file);
    return std::unexpected(fmt::format("{}: {}", url.text, why));
  }
  ::cfmakeraw(&settings);
  ::cfsetspeed(&settings, *speed);
  settings.c_cflag |= CLOCAL | CREAD;
  if (bus.framing.parity != tape_code::Parity::none) settings.c_cflag |= PARENB;
  if (bus.framing.parity == tape_code::Parity::odd) settings.c_cflag |= PARODD;
  if (bus.framing.stop_bits == 2) settings.c_cflag |= CSTOPB;
  ::tcsetattr(file, TCSANOW, &settings);
  return std::make_unique<DeviceWire>(file, url.path);
}

class RtuPort final : public PlcPort {
 public:
  explicit RtuPort(std::unique_ptr<Wire> wire) : wire_(std::move(wire)) {}

  void serve(int wait_ms, const PlcAnswer& answer) override {
    pollfd file{wire_->descriptor(), POLLIN, 0};
    ::poll(&file, 1, wait_ms);
    if ((file.revents & (POLLHUP | POLLERR)) != 0) std::this_thread::sleep_for(kNoPeer);
    const auto now = Clock::now();
    if (gathered_ > 0 && now - last_ > kSilence) gathered_ = 0;
    if (file.revents == 0) return;
    std::array<std::byte, kLongest> came{};
    const std::size_t count = wire_->read(std::span(came).first(bytes_.size() - gathered_));
    if (count == 0) return;
    last_ = now;
    for (std::size_t i = 0; i < count; ++i) bytes_[gathered_ + i] = std::to_integer<std::uint8_t>(came[i]);
    gathered_ += count;
    take_frames(answer);
  }
  void drop_all() override { gathered_ = 0; }
  [[nodiscard]] bool is_serial() const override { return true; }

 private:
  void take_frames(const PlcAnswer& answer) {
    for (auto length = length_of(gathered()); length && *length <= gathered_; length = length_of(gathered())) {
      const auto frame = std::span<const std::uint8_t>(bytes_).first(*length);
      const std::uint16_t crc = crc_16(frame.first(*length - kCrcBytes));
      const bool right = frame[*length - 2] == (crc & 0xFFU) && frame[*length - 1] == crc >> 8U;
      if (!right) return;  // until it is quiet
      const auto out = answer({.frame = frame, .function_at = 1});
      if (!out.empty()) wire_->write(std::as_bytes(out));
      if (gathered_ < *length) return;  // dropped meanwhile
      std::copy(bytes_.begin() + static_cast<std::ptrdiff_t>(*length),
                bytes_.begin() + static_cast<std::ptrdiff_t>(gathered_), bytes_.begin());
      gathered_ -= *length;
    }
  }
  [[nodiscard]] std::span<const std::uint8_t> gathered() const { return std::span(bytes_).first(gathered_); }

  std::unique_ptr<Wire> wire_;
  std::array<std::uint8_t, kLongest> bytes_{};
  std::size_t gathered_ = 0;
  Clock::time_point last_{};
};

}  // namespace

std::uint16_t crc_16(std::span<const std::uint8_t> bytes) {
  std::uint16_t crc = 0xFFFF;
  for (const std::uint8_t byte : bytes) {
    crc = static_cast<std::uint16_t>(crc ^ byte);
    for (int bit = 0; bit < 8; ++bit)
      crc = static_cast<std::uint16_t>((crc & 1U) != 0 ? (crc >> 1U) ^ 0xA001U : crc >> 1U);
  }
  return crc;
}

OpenedPort open_rtu_port(const machine::LinkUrl& url) {
  const auto bus = machine::bus_settings_of(url);
  if (!bus) return std::unexpected(bus.error());
  struct stat status{};
  const bool is_there = ::stat(url.path.c_str(), &status) == 0 && !io::is_abandoned(url.path);
  machine::LinkUrl own = url;
  own.kind = machine::LinkKind::pty;
  auto wire = is_there ? open_device(url, *bus) : Wire::open(own);
  if (!wire) return std::unexpected(wire.error());
  return std::make_unique<RtuPort>(std::move(*wire));
}

}  // namespace dripfeed::simulator
