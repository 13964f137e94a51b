// Between the feet of its ends each piece is enclosed by curves::gap_range. First a bound that costs nothing is tried:
// the gap at the ends is no more than the ends' distance, and in between the largest second derivative of the whole
// profile counts; only where that would raise the maximum is more computed.
#include "checks/accuracy/chord.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dialects/curves/chord_bound.h"
#include "dialects/curves/gap.h"

namespace dripfeed::accuracy {

ChordBound::ChordBound(const curves::Profile& profile) {
  for (const curves::ProfilePiece& one : profile.pieces) {
    curves::ParametricCurve curve;
    curve.t = one.curve.z;
    curve.at = [x = one.curve.at](double z) {
      const curves::ExplicitPoint at = x(z);
      return curves::ParametricPoint{{z, at.x}, {1.0, at.slope}, {}};
    };
    if (one.curve.second_derivatives) {
      curve.second_derivatives = [second = one.curve.second_derivatives](double low, double high) {
        return curves::Box{{0.0, 0.0}, second(low, high)};
      };
    }
    pieces_.push_back({std::move(curve), curves::second_limit_of(one.curve)});
  }
}

void ChordBound::add_part(const Piece& nominal, curves::Range z, const curves::PathPiece& piece, double at_ends) {
  const bool straight = std::holds_alternative<curves::Segment>(piece);
  const double cheap = at_ends + curves::interpolation_bound(nominal.second_limit, z.width());
  if (straight && cheap <= bound_) return;
  const std::optional<curves::Range> range = curves::gap_range(nominal.curve, z, piece);
  proved_ = proved_ && range.has_value();
  if (range) bound_ = std::max({bound_, std::fabs(range->low), std::fabs(range->high)});
}

void ChordBound::add(const curves::PathPiece& piece, const curves::Deviation& measured) {
  if (measured.points == 0 || !proved_) return;
  bound_ = std::max(bound_, measured.largest());  // the ends, and where the path passes an end of the profile
  const double at_ends = std::max(std::fabs(measured.first.foot.distance), std::fabs(measured.last.foot.distance));
  const auto [low, high] = std::minmax(measured.first.piece, measured.last.piece);
  const bool forwards =
      measured.first.piece < measured.last.piece || (low == high && measured.first.foot.z <= measured.last.foot.z);
  const curves::Foot& left = forwards ? measured.first.foot : measured.last.foot;
  const curves::Foot& right = forwards ? measured.last.foot : measured.first.foot;
  for (std::size_t i = low; i <= high && i < pieces_.size(); ++i) {
    curves::Range z = pieces_[i].curve.t;
    if (i == low) z.low = left.z;
    if (i == high) z.high = right.z;
    if (z.low < z.high) add_part(pieces_[i], z, piece, low == high ? at_ends : 1e300);
  }
}

}  // namespace dripfeed::accuracy
