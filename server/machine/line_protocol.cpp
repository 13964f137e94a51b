// One row a protocol.
#include "server/machine/line_protocol.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "server/machine/profile.h"

namespace dripfeed::machine {

namespace {

constexpr std::array<std::string_view, 9> kNames = {
    "dc-codes", "remote-buffer-b", "xmodem", "xmodem-crc", "xmodem-1k", "remote-buffer-a", "3964", "3964r", "ymodem"};

using Packet = std::optional<packet::Protocol>;
constexpr std::array<Packet, kNames.size()> kPackets = {
    Packet{},
    Packet{},
    packet::Protocol::xmodem,
    packet::Protocol::xmodem_crc,
    packet::Protocol::xmodem_1k,
    packet::Protocol::remote_buffer_a,
    packet::Protocol::s3964,
    packet::Protocol::s3964r,
    packet::Protocol::ymodem,
};

}  // namespace

std::span<const std::string_view> line_protocol_names() { return kNames; }

std::string_view name_of(LineProtocol protocol) { return kNames[static_cast<std::size_t>(protocol)]; }

std::optional<LineProtocol> parse_line_protocol(std::string_view name) {
  const auto found = std::ranges::find(kNames, name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<LineProtocol>(found - kNames.begin());
}

std::optional<packet::Protocol> packet_protocol_of(LineProtocol protocol) {
  return kPackets[static_cast<std::size_t>(protocol)];
}

bool sends_name(const LineSettings& line) {
  if (!feeds_characters(line.link.kind)) return false;
  const auto effective = effective_line(line);
  return effective && effective->protocol == LineProtocol::ymodem;
}

std::expected<packet::Settings, std::string> packet_settings_of(const LineSettings& given) {
  const auto effective = effective_line(given);
  if (!effective) return std::unexpected(effective.error());
  const LineSettings& line = *effective;
  const std::string_view name = name_of(line.protocol);
  if (line.framing.data_bits != 8 || line.framing.parity != tape_code::Parity::none) {
    return std::unexpected(fmt::format("{} needs 8 data bits without parity: the framing is {}, write 8N1 or 8N2", name,
                                       tape_code::format_framing(line.framing)));
  }
  if (line.flow == feed::Flow::xonxoff || line.flow == feed::Flow::both) {
    return std::unexpected(
        fmt::format("{} cannot be used with flow control by XON and XOFF: its frames hold these characters", name));
  }
  packet::Settings settings;
  settings.protocol = *packet_protocol_of(line.protocol);
  settings.wire = wire_format_of(line);
  settings.char_time =
      packet::Time((std::int64_t{1'000'000'000} * line.framing.bits_per_char() + line.baud - 1) / line.baud);
  if (line.answer_s) settings.answer_patience = packet::Time(static_cast<std::int64_t>(*line.answer_s * 1e9));
  settings.payload = line.payload_bytes;
  settings.counted = line.counted_frames;
  settings.yields_on_collision = line.yields_on_collision;
  settings.end_is_cr = line.messages_end_with_cr;
  if (const auto valid = packet::validate(settings); !valid)
    return std::unexpected(std::string(packet::message(valid.error())));
  return settings;
}

}  // namespace dripfeed::machine
