// The code of a line as two tables of 256 entries, so that a stream is a look-up a byte whatever the code: ASCII, ISO
// with its parity, EIA.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "protocol/tape_code/eia.h"
#include "protocol/tape_code/framing.h"

namespace dripfeed::tape_code {

// Text to wire.
class EncodeTable {
 public:
  // eia: RS-244 with these specials; eighth_bit is then of no meaning.
  EncodeTable(EighthBit eighth_bit, const std::optional<EiaSpecials>& eia);
  bool has(char character) const { return codes_[static_cast<std::uint8_t>(character)] != kNone; }
  // Of a character that it has.
  std::uint8_t code(char character) const {
    return static_cast<std::uint8_t>(codes_[static_cast<std::uint8_t>(character)]);
  }

 private:
  static constexpr std::uint16_t kNone = 0x100;
  std::array<std::uint16_t, 256> codes_{};
};

// What a byte from the wire is.
enum class ByteKind : std::uint8_t {
  character,
  filler,         // DEL, NUL of ISO and ASCII, codes of EIA without a meaning in a program
  blank,          // EIA without a hole: leader and trailer, an error inside
  wrong,          // wrong parity; the character is what its low 7 bits say
  wrong_nothing,  // wrong parity, or a code that no table has: EIA gives no character then
};

// Wire to text.
class DecodeTable {
 public:
  DecodeTable(EighthBit eighth_bit, const std::optional<EiaSpecials>& eia);
  ByteKind kind(std::uint8_t byte) const { return kinds_[byte]; }
  char character(std::uint8_t byte) const { return characters_[byte]; }

 private:
  std::array<ByteKind, 256> kinds_{};
  std::array<char, 256> characters_{};
};

}  // namespace dripfeed::tape_code
