// One piece of a path, straight or an arc, run through with t in 0..1.
#pragma once

#include <variant>

#include "dialects/curves/arc.h"
#include "dialects/curves/line.h"
#include "dialects/curves/point.h"

namespace dripfeed::curves {

using PathPiece = std::variant<Segment, Arc>;

inline Point point_at(const PathPiece& piece, double t) {
  return std::visit([t](const auto& one) { return one.at(t); }, piece);
}
inline double length_of(const PathPiece& piece) {
  return std::visit([](const auto& one) { return one.length(); }, piece);
}
Point direction_at(const PathPiece& piece, double t);
// The part between two values of t.
PathPiece part_of(const PathPiece& piece, double from, double to);
PathPiece moved(const PathPiece& piece, Point by);
Box box_of(const PathPiece& piece);

}  // namespace dripfeed::curves
