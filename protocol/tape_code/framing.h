// Framing of a character on a serial line, and what its eighth bit carries on a channel of 8 bits. Data only: setting a
// port is the driver's work. Source of the code tables: ISO 840 (ASCII with even parity in bit 7); EIA is in eia.h.
#pragma once

#include <cstdint>
#include <expected>
#include <string>
#include <string_view>

namespace dripfeed::tape_code {

enum class Parity : std::uint8_t { none, even, odd };

// One character on the line: start bit, data bits, parity bit if any, stop bits.
struct Framing {
  int data_bits = 7;
  Parity parity = Parity::even;
  int stop_bits = 2;

  // Bits that one character takes on the line, start bit included: 7E2 and 8N2 have 11, 8N1 has 10.
  constexpr int bits_per_char() const { return 1 + data_bits + (parity == Parity::none ? 0 : 1) + stop_bits; }
  friend constexpr bool operator==(const Framing&, const Framing&) = default;
};

enum class FramingError : std::uint8_t { length, data_bits, parity, stop_bits };

// Reads "7E2", "8N1" and alike: 7 or 8, N, E or O (either case), 1 or 2.
std::expected<Framing, FramingError> parse_framing(std::string_view text);
std::string format_framing(const Framing& framing);
std::string_view message(FramingError error);

// The code of the characters: plain ASCII; ISO 840, which is ASCII with even parity in bit 7 whatever the framing; EIA
// RS-244, whose bytes have 8 bits, parity among them.
enum class Code : std::uint8_t { ascii, iso, eia };

// What bit 7 of a byte carries between the program and the driver.
//   data   bit 7 belongs to the character (8N with plain ASCII, EIA)
//   clear  7-bit characters; bit 7 is sent as 0 and is not looked at (7N, or parity is done by the UART)
//   even   even parity over all 8 bits (7E, or ISO code on 8N)
//   odd    odd parity over all 8 bits (7O)
enum class EighthBit : std::uint8_t { data, clear, even, odd };

// Who makes the parity bit: the UART (the driver set the framing) or software on a channel of 8 bits (pty, raw TCP).
enum class ParityBy : std::uint8_t { software, uart };

// What bit 7 carries for this framing and code. 8E and 8O have their parity outside the byte, so only a UART can make
// it: the byte then carries what the code says.
constexpr EighthBit eighth_bit(const Framing& framing, Code code, ParityBy by) {
  if (framing.data_bits == 8) return code == Code::iso ? EighthBit::even : EighthBit::data;
  if (by == ParityBy::uart || framing.parity == Parity::none) return EighthBit::clear;
  return framing.parity == Parity::even ? EighthBit::even : EighthBit::odd;
}

}  // namespace dripfeed::tape_code
