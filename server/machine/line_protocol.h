// What a line speaks: DC codes, or one of the packet protocols; and the packet protocol's settings out of a profile.
#pragma once

#include <cstdint>
#include <expected>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "protocol/packet/settings.h"

namespace dripfeed::machine {

struct LineSettings;

enum class LineProtocol : std::uint8_t {
  dc_codes,
  remote_buffer_b,  // DC codes, SYN and NAK: the FANUC remote buffer's protocol B
  xmodem,
  xmodem_crc,
  xmodem_1k,
  remote_buffer_a,
  s3964,
  s3964r,
  ymodem,
};

// "dc-codes", "xmodem", "xmodem-crc", "xmodem-1k", "remote-buffer-a", "remote-buffer-b", "3964", "3964r", "ymodem".
std::span<const std::string_view> line_protocol_names();
std::string_view name_of(LineProtocol protocol);
std::optional<LineProtocol> parse_line_protocol(std::string_view name);
// Nothing where the line speaks DC codes.
std::optional<packet::Protocol> packet_protocol_of(LineProtocol protocol);

// A transfer over this line gives the control the program's name: YMODEM. The URL's options count.
bool sends_name(const LineSettings& line);

// The settings of a packet line, URL options included; or one sentence that says which is wrong. Only for a line whose
// protocol has packets.
std::expected<packet::Settings, std::string> packet_settings_of(const LineSettings& line);

}  // namespace dripfeed::machine
