// Arguments of Function::rotate, scale and mirror: how the change joins what is in effect.
#pragma once

#include <cstdint>

#include "dialects/ir/function.h"

namespace dripfeed::ir {

inline constexpr std::int16_t kFrameAdds = 0;      // AROT: on top of what is in effect
inline constexpr std::int16_t kFrameReplaces = 1;  // ROT: in the place of the whole programmable frame
inline constexpr std::int16_t kFrameAboutPoint =
    2;                                         // G68: about a point that it names, besides shift, scale and mirror
inline constexpr std::int16_t kFrameEnds = 3;  // G69: ends the one about a point

// Whether a code only ends what few programs begin: nothing to say where a control does not have it.
constexpr bool ends_frame(Function function, std::int16_t argument) {
  const bool frame = function == Function::rotate || function == Function::scale || function == Function::mirror;
  return (frame && argument == kFrameEnds) || function == Function::polar_words_off;
}

}  // namespace dripfeed::ir
