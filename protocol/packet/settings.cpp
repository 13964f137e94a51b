// The names of the protocols, and what cannot be kept.
#include "protocol/packet/settings.h"

#include <algorithm>
#include <array>

namespace dripfeed::packet {
namespace {

constexpr std::array<std::string_view, kProtocols> kNames = {"xmodem", "xmodem-crc",      "xmodem-1k", "3964",
                                                             "3964r",  "remote-buffer-a", "ymodem"};

constexpr std::array<std::string_view, 4> kMessages = {
    "the bytes of text in a frame must be 1 to 1024",
    "the line has no speed",
    "XMODEM and YMODEM need 8 data bits without parity",
    "the character that ends a message of the remote buffer is part of the EOB; end messages with ETX",
};

}  // namespace

std::string_view name(Protocol protocol) { return kNames[static_cast<std::size_t>(protocol)]; }

std::optional<Protocol> parse_protocol(std::string_view name) {
  const auto found = std::ranges::find(kNames, name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<Protocol>(found - kNames.begin());
}

std::string_view message(SettingsFault fault) { return kMessages[static_cast<std::size_t>(fault)]; }

std::expected<void, SettingsFault> validate(const Settings& s) {
  if (s.payload == 0 || s.payload > kMaxPayload) return std::unexpected(SettingsFault::payload);
  if (s.char_time <= Time(0)) return std::unexpected(SettingsFault::char_time);
  if (is_xmodem(s.protocol) && s.wire.eighth_bit == tape_code::EighthBit::odd)
    return std::unexpected(SettingsFault::seven_bits);
  const bool cr_inside = tape_code::characters(s.wire.eob).find('\r') != std::string_view::npos;
  if (s.protocol == Protocol::remote_buffer_a && s.end_is_cr && cr_inside)
    return std::unexpected(SettingsFault::end_inside);
  return {};
}

}  // namespace dripfeed::packet
