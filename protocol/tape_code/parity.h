// The parity bit of one byte, in bit 7: adding, checking and taking it off. Whole streams are wire_encoder's and
// wire_decoder's work.
#pragma once

#include <bit>
#include <cstdint>

#include "protocol/tape_code/framing.h"

namespace dripfeed::tape_code {

constexpr std::uint8_t kLowSevenBits = 0x7F;
constexpr std::uint8_t kTopBit = 0x80;

constexpr bool odd_ones(std::uint8_t byte) { return (std::popcount(byte) & 1) != 0; }

// The wire byte of a character. Shape: a 7-bit character for all but EighthBit::data (the caller checked it; a set bit
// 7 is overwritten).
constexpr std::uint8_t with_parity(std::uint8_t character, EighthBit eighth) {
  const auto low = static_cast<std::uint8_t>(character & kLowSevenBits);
  switch (eighth) {
    case EighthBit::data: return character;
    case EighthBit::clear: return low;
    case EighthBit::even: return static_cast<std::uint8_t>(low | (odd_ones(low) ? kTopBit : 0));
    case EighthBit::odd: return static_cast<std::uint8_t>(low | (odd_ones(low) ? 0 : kTopBit));
  }
  return character;
}

// Does the byte have the parity that the line promises? Lines without parity promise nothing.
constexpr bool parity_holds(std::uint8_t byte, EighthBit eighth) {
  switch (eighth) {
    case EighthBit::data: return true;
    case EighthBit::clear: return true;
    case EighthBit::even: return !odd_ones(byte);
    case EighthBit::odd: return odd_ones(byte);
  }
  return true;
}

// The character of a wire byte, whether or not its parity holds.
constexpr std::uint8_t without_parity(std::uint8_t byte, EighthBit eighth) {
  return eighth == EighthBit::data ? byte : static_cast<std::uint8_t>(byte & kLowSevenBits);
}

}  // namespace dripfeed::tape_code
