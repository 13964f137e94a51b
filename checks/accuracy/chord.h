// A proved bound of how far the pieces of a path lie from a profile.
#pragma once

#include <optional>
#include <vector>

#include "dialects/curves/deviation.h"
#include "dialects/curves/parametric_curve.h"
#include "dialects/curves/path.h"
#include "dialects/curves/profile.h"

namespace dripfeed::accuracy {

// The largest bound over many pieces of path.
class ChordBound {
 public:
  ChordBound() = default;
  explicit ChordBound(const curves::Profile& profile);

  // `measured` is of that piece: its feet, and what was seen of it.
  void add(const curves::PathPiece& piece, const curves::Deviation& measured);
  // No point of any piece lies farther from the profile than this, mm, along the normal; within about 2 % of what is
  // reached. Nothing where it was not proved for a piece: no bound of the profile's second derivative there.
  [[nodiscard]] std::optional<double> value() const { return proved_ ? std::optional(bound_) : std::nullopt; }

 private:
  struct Piece {
    curves::ParametricCurve curve;  // t is z
    double second_limit = 0.0;
  };
  void add_part(const Piece& nominal, curves::Range z, const curves::PathPiece& piece, double at_ends);

  std::vector<Piece> pieces_;
  bool proved_ = true;
  double bound_ = 0.0;
};

}  // namespace dripfeed::accuracy
