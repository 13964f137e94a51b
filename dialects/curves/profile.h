// A nominal profile: explicit curves side by side in z, each with its tolerance, and the distance of a point from all
// of it. The material is below (smaller x).
#pragma once

#include <cstddef>
#include <vector>

#include "dialects/curves/explicit_curve.h"
#include "dialects/curves/point.h"

namespace dripfeed::curves {

struct ProfilePiece {
  ExplicitCurve curve;
  double tolerance = 0.0;  // mm, to both sides
};

struct ProfileFoot {
  Foot foot;
  std::size_t piece = 0;
};

// Pieces in the order of z; each may begin where the one before ends, at another x (a step) if need be.
struct Profile {
  std::vector<ProfilePiece> pieces;

  [[nodiscard]] bool empty() const { return pieces.empty(); }
  // From the first piece's start to the last one's end; pieces must not be empty.
  [[nodiscard]] Range z() const { return {pieces.front().curve.z.low, pieces.back().curve.z.high}; }
};

// The nearest point of the profile; `beyond` only at its outer ends. The sign is above (+) or below (-), as for one
// curve.
ProfileFoot closest(const Profile& profile, Point point);

// The curve whose range holds z, the last of them at a joint; nullptr outside.
const ProfilePiece* piece_at(const Profile& profile, double z);

}  // namespace dripfeed::curves
