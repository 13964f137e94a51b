// In coordinates in which the travel goes to the right and levels rise away from the material the tool is on the left.
// The corner of two offset lines is the centre of a rounding of that radius.
#include "dialects/interpreter/cycles/contour_offset.h"

#include <cmath>

#include "dialects/interpreter/motion/corner.h"

namespace dripfeed::interpreter {

namespace {

constexpr double kSmall = 1e-9;

class Offset {
 public:
  Offset(double distance, const ContourSide& side) : distance_(distance), side_(side) {}

  std::optional<std::vector<ContourPiece>> run(const std::vector<ContourPiece>& contour) {
    for (const ContourPiece& piece : contour) pieces_.push_back(turned(piece.segment));
    std::vector<ContourPiece> out;
    PlanePoint begin = offset_point(pieces_.front(), pieces_.front().start);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const PathPiece& piece = pieces_[i];
      PlanePoint end = offset_point(piece, piece.end);
      PlanePoint next = end;
      bool rounded = false;
      if (i + 1 < pieces_.size()) {
        const double turn = turn_between(piece, pieces_[i + 1]);
        next = offset_point(pieces_[i + 1], pieces_[i + 1].start);
        rounded = turn < -kSmall;
        if (turn > kSmall) {
          const auto corner = corner_between(piece, pieces_[i + 1], CornerKind::rounding, distance_);
          if (!corner.has_value()) return std::nullopt;
          end = next = corner->center;
        }
      }
      if (!fits(piece, begin, end)) return std::nullopt;
      const std::uint32_t line = contour[i].segment.line;
      out.push_back(back({begin, end, piece.is_arc, piece.center, piece.turn}, line));
      if (rounded) out.push_back(back({end, next, true, piece.end, Turn::clockwise}, line));
      begin = next;
    }
    return out;
  }

 private:
  [[nodiscard]] PlanePoint turned(ShapePoint p) const { return {p.travel * side_.forward, p.level * side_.rise}; }
  [[nodiscard]] PathPiece turned(const ShapeSegment& s) const {
    const bool left = s.turn * side_.forward * side_.rise > 0.0;
    return {turned(s.from), turned(s.to), s.arc, turned(s.center), left ? Turn::counterclockwise : Turn::clockwise};
  }
  [[nodiscard]] ShapePoint back(PlanePoint p) const { return {p.p * side_.forward, p.q * side_.rise}; }
  [[nodiscard]] ContourPiece back(const PathPiece& p, std::uint32_t line) const {
    ContourPiece out;
    out.segment = {.from = back(p.start), .to = back(p.end), .center = back(p.center), .arc = p.is_arc, .line = line};
    const bool positive = ((p.turn == Turn::counterclockwise ? 1.0 : -1.0) * side_.forward * side_.rise) > 0.0;
    if (p.is_arc) out.segment.turn = turn_of(out.segment, positive);
    out.ccw = positive == side_.along_z;
    return out;
  }

  static PlanePoint direction(const PathPiece& piece, PlanePoint at) {
    PlanePoint d{piece.end.p - piece.start.p, piece.end.q - piece.start.q};
    if (piece.is_arc) {
      const double sign = piece.turn == Turn::counterclockwise ? 1.0 : -1.0;
      d = {-sign * (at.q - piece.center.q), sign * (at.p - piece.center.p)};
    }
    const double length = length_of(d);
    return {d.p / length, d.q / length};
  }
  [[nodiscard]] PlanePoint offset_point(const PathPiece& piece, PlanePoint at) const {
    const PlanePoint d = direction(piece, at);
    return {at.p - distance_ * d.q, at.q + distance_ * d.p};
  }
  static double turn_between(const PathPiece& a, const PathPiece& b) {
    const PlanePoint before = direction(a, a.end);
    const PlanePoint after = direction(b, b.start);
    return before.p * after.q - before.q * after.p;
  }
  // What is left of the piece still goes its travel.
  [[nodiscard]] bool fits(const PathPiece& piece, PlanePoint begin, PlanePoint end) const {
    if (!piece.is_arc) {
      const PlanePoint d = direction(piece, piece.start);
      return (end.p - begin.p) * d.p + (end.q - begin.q) * d.q > kSmall;
    }
    const double radius = length_of({piece.start.p - piece.center.p, piece.start.q - piece.center.q});
    if (piece.turn == Turn::counterclockwise && radius <= distance_ + kSmall) return false;
    const auto opening = [&](PlanePoint from, PlanePoint to) {
      return opening_of({piece.center.p - from.p, piece.center.q - from.q}, {to.p - from.p, to.q - from.q}, piece.turn);
    };
    return opening(begin, end) <= opening(piece.start, piece.end) + 1e-6;
  }

  double distance_;
  ContourSide side_;
  std::vector<PathPiece> pieces_;
};

}  // namespace

std::optional<std::vector<ContourPiece>> offset_contour(const std::vector<ContourPiece>& contour, double distance_mm,
                                                        const ContourSide& side) {
  return Offset(distance_mm, side).run(contour);
}

}  // namespace dripfeed::interpreter
