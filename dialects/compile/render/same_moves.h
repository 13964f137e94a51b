// Two runs of a program before and after a change, compared move by move.
#pragma once

#include <cstdint>
#include <optional>

#include "dialects/compile/translate/recorded_run.h"

namespace dripfeed::compile {

// The line of the first motion that is another one in `b`, in `a`'s text; nothing where there is none.
std::optional<std::uint32_t> first_difference(const RecordedRun& a, const RecordedRun& b);

// How far the paths lie apart at most, mm; nothing where more than the ends of straight moves along x, y and z differs.
// Two moves that begin and end within a distance of each other lie within it at each moment. A diameter counts as it
// is: twice the distance.
std::optional<double> distance_apart(const RecordedRun& a, const RecordedRun& b);

}  // namespace dripfeed::compile
