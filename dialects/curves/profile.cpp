// Few pieces: each is asked, but for those that begin farther away along z than the best foot so far.
#include "dialects/curves/profile.h"

#include <algorithm>
#include <cmath>

namespace dripfeed::curves {

ProfileFoot closest(const Profile& profile, Point point) {
  ProfileFoot best;
  bool found = false;
  for (std::size_t i = 0; i < profile.pieces.size(); ++i) {
    const ExplicitCurve& curve = profile.pieces[i].curve;
    const double away = std::max({0.0, curve.z.low - point.z, point.z - curve.z.high});
    if (found && away >= std::fabs(best.foot.distance)) continue;
    const Foot foot = closest(curve, point);
    if (found && std::fabs(foot.distance) >= std::fabs(best.foot.distance)) continue;
    best = {foot, i};
    found = true;
  }
  if (!found) return best;
  // A joint inside the profile is no end of it.
  const bool at_outer_end = (best.foot.beyond == Beyond::low && best.piece == 0) ||
                            (best.foot.beyond == Beyond::high && best.piece + 1 == profile.pieces.size());
  if (!at_outer_end) {
    best.foot.beyond = Beyond::none;
    best.foot.overhang = 0.0;
  }
  if (const ProfilePiece* own = piece_at(profile, point.z)) {
    best.foot.distance = std::copysign(best.foot.distance, point.x - own->curve.at(point.z).x);
  }
  return best;
}

const ProfilePiece* piece_at(const Profile& profile, double z) {
  for (auto piece = profile.pieces.rbegin(); piece != profile.pieces.rend(); ++piece) {
    if (piece->curve.z.contains(z)) return &*piece;
  }
  return nullptr;
}

}  // namespace dripfeed::curves
