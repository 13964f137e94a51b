// What a code of Function::transformation does: Code::argument. The letter across is the rotary axis itself (G12.1,
// G07.1), or Y in millimetres (TRANSMIT, TRACYL).
#pragma once

#include <cstdint>

namespace dripfeed::ir {

inline constexpr std::int16_t kTransformationEnds = 0;  // G13.1, TRAFOOF
inline constexpr std::int16_t kFaceByRotary = 1;        // G12.1: C is a coordinate across X, in mm
inline constexpr std::int16_t kCylinderByRotary = 2;    // G07.1 C10.: the radius; C0 ends it
inline constexpr std::int16_t kFaceByY = 3;             // TRANSMIT
inline constexpr std::int16_t kCylinderByY = 4;         // TRACYL(20): the diameter, as Address::r

}  // namespace dripfeed::ir
