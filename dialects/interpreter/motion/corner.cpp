// Between two lines the corner is a triangle: with the angle phi by which the path turns, a rounding of radius r takes
// r · tan(phi / 2) off each, a chamfer with the edge f takes f / (2 cos(phi / 2)). With an arc, the centre of the
// rounding is where the two pieces, set off by r to the side to which the path turns, meet next to the corner.
#include "dialects/interpreter/motion/corner.h"

#include <array>
#include <cmath>

namespace dripfeed::interpreter {

namespace {

constexpr double kNothing = 1e-9;

PlanePoint operator+(PlanePoint a, PlanePoint b) { return {a.p + b.p, a.q + b.q}; }
PlanePoint operator-(PlanePoint a, PlanePoint b) { return {a.p - b.p, a.q - b.q}; }
PlanePoint operator*(double k, PlanePoint a) { return {k * a.p, k * a.q}; }
double dot(PlanePoint a, PlanePoint b) { return a.p * b.p + a.q * b.q; }
double cross(PlanePoint a, PlanePoint b) { return a.p * b.q - a.q * b.p; }
PlanePoint left_of(PlanePoint a) { return {-a.q, a.p}; }

PlanePoint unit(PlanePoint a) {
  const double length = length_of(a);
  return length < kNothing ? PlanePoint{} : (1.0 / length) * a;
}

// The direction of the path at a point of the piece.
PlanePoint direction_at(const PathPiece& piece, PlanePoint at) {
  if (!piece.is_arc) return unit(piece.end - piece.start);
  const PlanePoint outward = unit(at - piece.center);
  return piece.turn == Turn::counterclockwise ? left_of(outward) : -1.0 * left_of(outward);
}

// Set off to the left by `distance`: a line through a point, or a circle.
struct OffsetCurve {
  bool is_circle = false;
  PlanePoint point;
  PlanePoint direction;
  double radius = 0.0;  // about `point`
};
OffsetCurve offset_of(const PathPiece& piece, double distance) {
  if (!piece.is_arc) {
    const PlanePoint direction = direction_at(piece, piece.start);
    return {.is_circle = false, .point = piece.start + distance * left_of(direction), .direction = direction};
  }
  const double radius = length_of(piece.start - piece.center);
  const double toward_center = piece.turn == Turn::counterclockwise ? distance : -distance;
  return {.is_circle = true, .point = piece.center, .direction = {}, .radius = radius - toward_center};
}

// Where two offset curves meet: up to two points.
struct Meeting {
  std::array<PlanePoint, 2> points{};
  int count = 0;
};
Meeting line_and_circle(const OffsetCurve& line, const OffsetCurve& circle) {
  const PlanePoint to_line = line.point - circle.point;
  const double along = dot(to_line, line.direction);
  const double rest = along * along - (dot(to_line, to_line) - circle.radius * circle.radius);
  if (rest < 0.0) return {};
  const double root = std::sqrt(rest);
  return {{line.point + (-along - root) * line.direction, line.point + (-along + root) * line.direction}, 2};
}
Meeting circle_and_circle(const OffsetCurve& a, const OffsetCurve& b) {
  const PlanePoint between = b.point - a.point;
  const double distance = length_of(between);
  if (distance < kNothing) return {};
  const double along = (distance * distance + a.radius * a.radius - b.radius * b.radius) / (2.0 * distance);
  const double rest = a.radius * a.radius - along * along;
  if (rest < 0.0) return {};
  const PlanePoint direction = unit(between);
  const PlanePoint foot = a.point + along * direction;
  const double root = std::sqrt(rest);
  return {{foot + root * left_of(direction), foot + -root * left_of(direction)}, 2};
}
Meeting meet(const OffsetCurve& a, const OffsetCurve& b) {
  if (a.is_circle && b.is_circle) return circle_and_circle(a, b);
  if (a.is_circle || b.is_circle) return a.is_circle ? line_and_circle(b, a) : line_and_circle(a, b);
  const double turn = cross(a.direction, b.direction);
  if (std::abs(turn) < kNothing) return {};
  const double along = cross(b.point - a.point, b.direction) / turn;
  return {{a.point + along * a.direction, {}}, 1};
}

// The point of the piece that is next to the centre of the rounding.
PlanePoint touch(const PathPiece& piece, PlanePoint center) {
  if (!piece.is_arc) {
    const PlanePoint direction = direction_at(piece, piece.start);
    return piece.start + dot(center - piece.start, direction) * direction;
  }
  return piece.center + length_of(piece.start - piece.center) * unit(center - piece.center);
}

bool lies_on(const PathPiece& piece, PlanePoint point) {
  if (!piece.is_arc) {
    const double along = dot(point - piece.start, direction_at(piece, piece.start));
    return along >= -kNothing && along <= length_of(piece.end - piece.start) + kNothing;
  }
  const PlanePoint center = piece.center - piece.start;
  return opening_of(center, point - piece.start, piece.turn) <=
         opening_of(center, piece.end - piece.start, piece.turn) + kNothing;
}

std::optional<Corner> rounding_between(const PathPiece& first, const PathPiece& second, double radius, bool left) {
  const double side = left ? radius : -radius;
  const Meeting meeting = meet(offset_of(first, side), offset_of(second, side));
  std::optional<PlanePoint> center;
  for (int i = 0; i < meeting.count; ++i) {
    const PlanePoint point = meeting.points[static_cast<std::size_t>(i)];
    if (!center || length_of(point - first.end) < length_of(*center - first.end)) center = point;
  }
  if (!center) return std::nullopt;
  const Corner corner{.from = touch(first, *center),
                      .to = touch(second, *center),
                      .is_arc = true,
                      .center = *center,
                      .turn = left ? Turn::counterclockwise : Turn::clockwise};
  if (!lies_on(first, corner.from) || !lies_on(second, corner.to)) return std::nullopt;
  return corner;
}

// What a corner takes off each of two lines that turn by phi.
double leg_of(CornerKind kind, double size_mm, double phi) {
  if (kind == CornerKind::rounding) return size_mm * std::tan(phi / 2.0);
  return kind == CornerKind::chamfer_leg ? size_mm : size_mm / (2.0 * std::cos(phi / 2.0));
}

}  // namespace

TooShort too_short_for(const PathPiece& first, const PathPiece& second, CornerKind kind, double size_mm) {
  if (first.is_arc || second.is_arc || size_mm < kNothing || kind == CornerKind::none) return TooShort::none;
  const PlanePoint before = direction_at(first, first.end);
  const PlanePoint after = direction_at(second, second.start);
  const double turn = cross(before, after);
  if (std::abs(turn) < kNothing) return TooShort::none;
  const double leg = leg_of(kind, size_mm, std::atan2(std::abs(turn), dot(before, after)));
  if (leg > length_of(first.end - first.start) + kNothing) return TooShort::first;
  return leg > length_of(second.end - second.start) + kNothing ? TooShort::second : TooShort::none;
}

std::optional<Corner> corner_between(const PathPiece& first, const PathPiece& second, CornerKind kind, double size_mm) {
  const PlanePoint before = direction_at(first, first.end);
  const PlanePoint after = direction_at(second, second.start);
  const double turn = cross(before, after);
  if (std::abs(turn) < kNothing || size_mm < kNothing || kind == CornerKind::none) return std::nullopt;
  if (kind == CornerKind::rounding) return rounding_between(first, second, size_mm, turn > 0.0);
  if (first.is_arc || second.is_arc) return std::nullopt;
  const double phi = std::atan2(std::abs(turn), dot(before, after));
  const double leg = leg_of(kind, size_mm, phi);
  if (leg > length_of(first.end - first.start) + kNothing || leg > length_of(second.end - second.start) + kNothing)
    return std::nullopt;
  return Corner{.from = first.end - leg * before, .to = first.end + leg * after, .is_arc = false, .center = {}};
}

}  // namespace dripfeed::interpreter
