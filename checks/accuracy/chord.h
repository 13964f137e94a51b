// A proved bound of how far one piece of path lies from the nominal.
#pragma once

#include <optional>

#include "dialects/curves/path.h"
#include "dialects/curves/profile.h"

namespace dripfeed::accuracy {

// No point of the piece over the profile's range of z lies farther from the profile than this, mm, measured along x and
// so along the normal, too. Nothing where it cannot be proved: no bound of the profile's second derivative, a piece
// straight along x, or an arc that is no function of z. 0 for a piece beside the profile.
std::optional<double> chord_bound(const curves::Profile& profile, const curves::PathPiece& piece);

}  // namespace dripfeed::accuracy
