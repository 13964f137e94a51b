// Options of a register bus, by value.
#include "server/machine/bus_settings.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace dripfeed::machine {

namespace {

constexpr std::array<std::uint32_t, 14> kBauds = {300,   600,   1200,   2400,   4800,   9600,   19200,
                                                  38400, 57600, 115200, 230400, 460800, 500000, 921600};
constexpr std::uint32_t kShortestTimeout_ms = 10;
constexpr std::uint32_t kLongestTimeout_ms = 60'000;
constexpr std::uint32_t kShortestPoll_ms = 20;
constexpr std::uint32_t kLongestPoll_ms = 60'000;
constexpr std::uint32_t kLastUnit = 247;

std::optional<std::uint32_t> number_of(std::string_view text) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

const std::string* option(const LinkUrl& url, const std::string& name) {
  const auto found = url.options.find(name);
  return found == url.options.end() ? nullptr : &found->second;
}

using Read = std::expected<void, std::string>;

Read read_number(const LinkUrl& url, const std::string& name, std::uint32_t least, std::uint32_t most,
                 std::uint32_t& into) {
  const std::string* const given = option(url, name);
  if (given == nullptr) return {};
  const auto value = number_of(*given);
  if (!value || *value < least || *value > most) {
    return std::unexpected(fmt::format("{} \"{}\" is not {}..{}", name, *given, least, most));
  }
  into = *value;
  return {};
}

Read read_line(const LinkUrl& url, BusSettings& settings) {
  if (const std::string* const given = option(url, "baud")) {
    const auto value = number_of(*given);
    if (!value || std::ranges::find(kBauds, *value) == kBauds.end()) {
      return std::unexpected(fmt::format("baud \"{}\" is not one of {}", *given, fmt::join(kBauds, ", ")));
    }
    settings.baud = *value;
  }
  if (const std::string* const given = option(url, "framing")) {
    const auto framing = tape_code::parse_framing(*given);
    if (!framing || framing->data_bits != 8) {
      return std::unexpected(fmt::format("framing \"{}\": RTU has 8 data bits, as 8E1 or 8N2", *given));
    }
    settings.framing = *framing;
  }
  if (const std::string* const given = option(url, "unit")) {
    const auto value = number_of(*given);
    if (!value || *value < 1 || *value > kLastUnit) {
      return std::unexpected(fmt::format("unit \"{}\" is not 1..{}", *given, kLastUnit));
    }
    settings.unit = static_cast<std::uint8_t>(*value);
  }
  return {};
}

}  // namespace

std::expected<BusSettings, std::string> bus_settings_of(const LinkUrl& url) {
  BusSettings settings{.unit = url.unit};
  Read read = read_number(url, "timeout_ms", kShortestTimeout_ms, kLongestTimeout_ms, settings.timeout_ms);
  if (read) read = read_number(url, "poll_ms", kShortestPoll_ms, kLongestPoll_ms, settings.poll_ms);
  if (read && url.kind == LinkKind::modbus_rtu) read = read_line(url, settings);
  if (!read) return std::unexpected(fmt::format("link \"{}\": {}", url.text, read.error()));
  return settings;
}

}  // namespace dripfeed::machine
