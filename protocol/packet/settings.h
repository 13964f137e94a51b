// Which packet protocol a line speaks and by what times; the checks that a wrong setting is refused. Plain data; the
// server fills it from the machine profile and the link.
#pragma once

#include <cstdint>
#include <expected>
#include <optional>
#include <span>
#include <string_view>

#include "protocol/feed/settings.h"
#include "protocol/tape_code/wire_encoder.h"

namespace dripfeed::packet {

using Time = feed::Time;

enum class Protocol : std::uint8_t {
  xmodem,           // 128 bytes and a sum
  xmodem_crc,       // 128 bytes and CRC-16, the sum where the receiver wants that
  xmodem_1k,        // 1024 bytes and CRC-16, short ends in 128
  s3964,            // Siemens 3964: the frame of 3964R without its check
  s3964r,           // Siemens 3964R
  remote_buffer_a,  // FANUC remote buffer, protocol A
  ymodem,           // blocks as of xmodem_1k after a header with name and length; one file in a batch
};
inline constexpr std::size_t kProtocols = 7;

// How a user names them: "xmodem", "xmodem-crc", "xmodem-1k", "3964", "3964r", "remote-buffer-a", "ymodem".
std::string_view name(Protocol protocol);
std::optional<Protocol> parse_protocol(std::string_view name);

constexpr bool is_xmodem(Protocol p) {
  return p == Protocol::xmodem || p == Protocol::xmodem_crc || p == Protocol::xmodem_1k || p == Protocol::ymodem;
}
constexpr bool is_3964(Protocol p) { return p == Protocol::s3964 || p == Protocol::s3964r; }

// Limit of the text in one frame.
inline constexpr std::uint32_t kMaxPayload = 1024;
// Limit of a frame on the wire: 3964R doubles each DLE.
inline constexpr std::uint32_t kMaxFrame = 2 * kMaxPayload + 16;

struct Settings {
  Protocol protocol = Protocol::xmodem;
  tape_code::WireFormat wire{.eighth_bit = tape_code::EighthBit::data};  // how the text is coded inside the frames
  Time char_time{1'041'667};                                             // of one character on the line: 8N1 at 9600
  // How long an answer to a frame may take. None: without limit, because a machine that is held answers late.
  std::optional<Time> answer_patience{};
  std::uint32_t payload = 128;  // text bytes in a frame of 3964 and of the remote buffer
  bool counted = false;         // 3964: two bytes at the head of each frame number it, so that a repeated one is known
  bool yields_on_collision = true;  // 3964: of two that call at once this side withdraws
  bool end_is_cr = false;           // remote buffer: a message ends with CR instead of ETX
};

enum class SettingsFault : std::uint8_t { payload, char_time, seven_bits, end_inside };
std::string_view message(SettingsFault fault);
std::expected<void, SettingsFault> validate(const Settings& settings);

}  // namespace dripfeed::packet
