// Chamfers and roundings between two moves of a plane: what is cut off the first and the second, and what comes
// between.
#pragma once

#include <optional>

#include "dialects/interpreter/motion/arc.h"

namespace dripfeed::interpreter {

enum class CornerKind : unsigned char { none, chamfer_leg, chamfer_edge, rounding };

// A straight line or an arc from `start` to `end` in the plane.
struct PathPiece {
  PlanePoint start;
  PlanePoint end;
  bool is_arc = false;
  PlanePoint center;  // of an arc, as a position
  Turn turn = Turn::clockwise;
};

// The first piece now ends at `from`, the second begins at `to`, and between them is a line, or an arc.
struct Corner {
  PlanePoint from;
  PlanePoint to;
  bool is_arc = false;
  PlanePoint center;
  Turn turn = Turn::clockwise;
};

// `first.end` is `second.start`. Nothing when the pieces go on without a corner, are too short for it, or one of them
// is an arc and a chamfer is wanted.
std::optional<Corner> corner_between(const PathPiece& first, const PathPiece& second, CornerKind kind, double size_mm);

// Which of two straight pieces is too short for the corner, the first one before the second; none for arcs, where other
// reasons are as likely.
enum class TooShort : unsigned char { none, first, second };
TooShort too_short_for(const PathPiece& first, const PathPiece& second, CornerKind kind, double size_mm);

}  // namespace dripfeed::interpreter
