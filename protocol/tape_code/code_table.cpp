// Filling the tables.
#include "protocol/tape_code/code_table.h"

#include "protocol/tape_code/parity.h"

namespace dripfeed::tape_code {
namespace {

constexpr std::uint8_t kNul = 0x00;
constexpr std::uint8_t kDel = 0x7F;
// Back space, upper and lower case shift: codes that say nothing in a program.
constexpr std::array<std::uint8_t, 3> kEiaIdle = {0x2A, 0x7C, 0x7A};

}  // namespace

EncodeTable::EncodeTable(EighthBit eighth_bit, const std::optional<EiaSpecials>& eia) {
  for (unsigned i = 0; i < codes_.size(); ++i) {
    const auto character = static_cast<std::uint8_t>(i);
    if (eia) {
      const std::uint8_t code = eia_code(static_cast<char>(character), *eia);
      codes_[i] = code == 0 ? kNone : code;
    } else {
      const bool fits = eighth_bit == EighthBit::data || character <= kLowSevenBits;
      codes_[i] = fits ? with_parity(character, eighth_bit) : kNone;
    }
  }
}

DecodeTable::DecodeTable(EighthBit eighth_bit, const std::optional<EiaSpecials>& eia) {
  if (eia) {
    kinds_.fill(ByteKind::wrong_nothing);
    kinds_[kEiaBlank] = ByteKind::blank;
    kinds_[kEiaDel] = ByteKind::filler;
    for (const std::uint8_t idle : kEiaIdle) kinds_[idle] = ByteKind::filler;
    for (unsigned i = 0; i <= kLowSevenBits; ++i) {
      const std::uint8_t code = eia_code(static_cast<char>(i), *eia);
      if (code == 0) continue;
      kinds_[code] = ByteKind::character;
      characters_[code] = static_cast<char>(i);
    }
    return;
  }
  for (unsigned i = 0; i < kinds_.size(); ++i) {
    const auto byte = static_cast<std::uint8_t>(i);
    const std::uint8_t character = without_parity(byte, eighth_bit);
    const bool is_filler = character == kNul || character == kDel;
    characters_[i] = static_cast<char>(character);
    kinds_[i] = !parity_holds(byte, eighth_bit) ? (is_filler ? ByteKind::wrong_nothing : ByteKind::wrong)
                : is_filler                     ? ByteKind::filler
                                                : ByteKind::character;
  }
}

}  // namespace dripfeed::tape_code
