// sysfs has a UART's clock and type under /sys/class/tty/NAME; a USB adapter has neither, and its rates are its own.
#include "server/io/port_state.h"

#include <filesystem>
#include <fstream>
#include <memory>
#include <vector>

#include <grp.h>
#include <sys/stat.h>
#include <unistd.h>

namespace dripfeed::io {

namespace {

constexpr std::uint32_t kClocksPerBit = 16;

std::optional<std::uint32_t> number_in(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::uint32_t number = 0;
  return file >> number ? std::optional(number) : std::nullopt;
}

std::string group_name(gid_t group) {
  std::vector<char> room(4096);
  struct group row{};
  struct group* found = nullptr;
  if (::getgrgid_r(group, &row, room.data(), room.size(), &found) == 0 && found != nullptr) return row.gr_name;
  return std::to_string(group);
}

}  // namespace

PortState look_at_port(const std::string& path, const std::string& sysfs) {
  PortState state;
  struct stat file{};
  if (::stat(path.c_str(), &file) != 0) return state;
  state.exists = true;
  state.is_device = S_ISCHR(file.st_mode);
  state.may_use = ::access(path.c_str(), R_OK | W_OK) == 0;
  state.group = group_name(file.st_gid);
  std::error_code error;
  const auto device = std::filesystem::canonical(path, error);
  const auto of = std::filesystem::path(sysfs) / "class/tty" / device.filename();
  const auto type = number_in(of / "type");
  const auto clock = number_in(of / "uartclk");
  state.has_uart = !type || *type != 0;
  if (clock && *clock >= kClocksPerBit && state.has_uart) state.base_baud = *clock / kClocksPerBit;
  return state;
}

bool divides_to(std::uint32_t base_baud, std::uint32_t baud) {
  if (baud == 0 || base_baud < baud / 2) return false;
  const std::uint32_t divisor = (base_baud + baud / 2) / baud;
  if (divisor == 0) return false;
  const double made = static_cast<double>(base_baud) / divisor;
  constexpr double kMostOff = 0.02;
  return made >= baud * (1.0 - kMostOff) && made <= baud * (1.0 + kMostOff);
}

}  // namespace dripfeed::io
