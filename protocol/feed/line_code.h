// What one byte from the control means. DC3 is believed with or without parity, as are SYN and NAK: they stop. DC1, DC2
// and DC4 must have the right bit 7, because one flipped bit makes them out of a DC3 with parity.
#pragma once

#include <cstdint>
#include <optional>

#include "protocol/feed/settings.h"
#include "protocol/tape_code/framing.h"

namespace dripfeed::feed {

enum class Signal : std::uint8_t { dc1, dc2, dc3, dc4, eot, syn, nak, unexpected };

// flow: what stands for DC1 and DC3. eot: the profile's end-of-transmission character, 7 bits.
Signal classify(std::uint8_t byte, tape_code::EighthBit eighth_bit, const FlowCharacters& flow,
                std::optional<std::uint8_t> eot);

}  // namespace dripfeed::feed
