// The meaning of a byte from the control.
#include "protocol/feed/line_code.h"

#include "protocol/tape_code/parity.h"

namespace dripfeed::feed {
namespace {

using tape_code::EighthBit;

constexpr std::uint8_t kDc2 = 0x12;
constexpr std::uint8_t kDc4 = 0x14;
constexpr std::uint8_t kNak = 0x15;
constexpr std::uint8_t kSyn = 0x16;

// Has the byte the bit 7 that this character must have? On a line whose 8 bits are data the control sends DC codes
// plain or with even parity.
bool bit_seven_fits(std::uint8_t byte, EighthBit eighth_bit) {
  switch (eighth_bit) {
    case EighthBit::clear: return true;
    case EighthBit::data: return (byte & tape_code::kTopBit) == 0 || parity_holds(byte, EighthBit::even);
    case EighthBit::even:
    case EighthBit::odd: return tape_code::parity_holds(byte, eighth_bit);
  }
  return false;
}

}  // namespace

Signal classify(std::uint8_t byte, EighthBit eighth_bit, const FlowCharacters& flow, std::optional<std::uint8_t> eot) {
  const auto character = static_cast<std::uint8_t>(byte & tape_code::kLowSevenBits);
  if (character == flow.xoff) return Signal::dc3;
  if (character == kSyn) return Signal::syn;
  if (character == kNak) return Signal::nak;
  // The end character ends the transfer, so it is believed in either parity on a line that carries no parity.
  if (eot && character == *eot && (eighth_bit == EighthBit::data || bit_seven_fits(byte, eighth_bit)))
    return Signal::eot;
  if (!bit_seven_fits(byte, eighth_bit)) return Signal::unexpected;
  if (character == flow.xon) return Signal::dc1;
  switch (character) {
    case kDc2: return Signal::dc2;
    case kDc4: return Signal::dc4;
    default: return Signal::unexpected;
  }
}

}  // namespace dripfeed::feed
