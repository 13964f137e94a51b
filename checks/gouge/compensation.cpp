// How two compensated pieces join, seen along the path with the tool on its left:
//
//      hollow: both are trimmed        outer, arc           outer, straight
//        |   |                         .---- led            X------ led
//        |   | led                    /                     |   X: where the led lines meet; a corner sharper than
//        |   X------                 |  .------ path        |  .------ path      a right angle: a radius beyond
//        '---------- path            |  | tool's side: left |  |
//
// The start-up ends, and the departure begins, perpendicular to the contour.
#include "checks/gouge/compensation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "checks/arcs.h"

namespace dripfeed::gouge {

namespace {

using curves::Arc;
using curves::PathPiece;
using curves::Point;
using curves::Segment;

constexpr double kSame_mm = 1e-6;
constexpr double kNoDistance_mm = 1e-9;
constexpr double kStraightOn = 1e-6;   // sine of the angle at a corner that is none
constexpr double kSmallGap_mm = 5e-3;  // centres of arcs are rounded: what joins this well is joined straight
constexpr std::size_t kMostWaiting = 256;

Point start_of(const ir::Motion& move) { return {move.start[0], move.start[1]}; }
Point end_of(const ir::Motion& move) { return {move.end[0], move.end[1]}; }
double side_of(ir::CompSide side) { return side == ir::CompSide::left ? 1.0 : -1.0; }
Point left_of(Point direction) { return {-direction.x, direction.z}; }

PathPiece path_of(const ir::Motion& move) {
  if (!checks::is_arc(move)) return Segment{start_of(move), end_of(move)};
  const Point center = start_of(move) + Point{move.center[0], move.center[1]};
  const auto turn = move.kind == ir::MotionKind::arc_ccw ? curves::Turn::counterclockwise : curves::Turn::clockwise;
  return curves::arc_between(start_of(move), end_of(move), center, turn);
}

bool moves_in_plane(const ir::Motion& move) {
  if (curves::distance(start_of(move), end_of(move)) > kNoDistance_mm) return true;
  return checks::is_arc(move) && std::hypot(move.center[0], move.center[1]) > kNoDistance_mm;
}

// Next to the path by `by`, to the left where positive; an arc that has no radius left keeps a hair of one.
PathPiece parallel_path(const PathPiece& path, double by) {
  if (const auto* segment = std::get_if<Segment>(&path)) {
    const Point shift = by * left_of(segment->direction());
    return Segment{segment->a + shift, segment->b + shift};
  }
  Arc arc = std::get<Arc>(path);
  arc.radius = std::max(kNoDistance_mm, arc.radius - (arc.sweep > 0.0 ? by : -by));
  return arc;
}

// -π..π
double wrapped(double angle) { return std::remainder(angle, 2.0 * std::numbers::pi); }

// Where a move begins, before its own path.
ir::Motion at_start_of(const ir::Motion& move, ir::MotionKind kind) {
  ir::Motion standing = move;
  standing.kind = kind == ir::MotionKind::rapid ? kind : ir::MotionKind::linear;
  standing.end = standing.start;
  return standing;
}

// Where `at`, a point of the line or circle, lies on the piece; near the one end or the other of an arc.
double parameter_of(const PathPiece& piece, Point at, bool near_end) {
  if (const auto* segment = std::get_if<Segment>(&piece)) {
    const Point run = segment->b - segment->a;
    return curves::dot(at - segment->a, run) / curves::dot(run, run);
  }
  const auto& arc = std::get<Arc>(piece);
  const double angle = std::atan2(at.x - arc.center.x, at.z - arc.center.z);
  const double end_angle = arc.start_angle + arc.sweep;
  if (near_end) return 1.0 - wrapped(end_angle - angle) / arc.sweep;
  return wrapped(angle - arc.start_angle) / arc.sweep;
}

// Beyond its ends a segment goes on straight.
Point place_on(const PathPiece& piece, double at) {
  if (const auto* segment = std::get_if<Segment>(&piece)) return segment->a + at * (segment->b - segment->a);
  return std::get<Arc>(piece).at(at);
}

PathPiece between(const PathPiece& piece, double from, double to) {
  if (std::holds_alternative<Segment>(piece)) return Segment{place_on(piece, from), place_on(piece, to)};
  return curves::part_of(piece, from, to);
}

// The crossing of both lines or circles that is nearest to `near`.
std::optional<Point> crossing(const PathPiece& one, const PathPiece& other, Point near) {
  std::vector<Point> found;
  const auto* a = std::get_if<Segment>(&one);
  const auto* b = std::get_if<Segment>(&other);
  if (a != nullptr && b != nullptr) {
    const Point along = a->direction();
    const double sine = curves::cross(along, b->direction());
    if (std::fabs(sine) < kStraightOn) return std::nullopt;
    return a->a + curves::cross(b->a - a->a, b->direction()) / sine * along;
  }
  if (a != nullptr || b != nullptr) {
    const Segment& line = a != nullptr ? *a : *b;
    const Arc& circle = std::get<Arc>(a != nullptr ? other : one);
    const Point along = line.direction();
    const double foot = curves::dot(circle.center - line.a, along);
    const Point middle = line.a + foot * along;
    const double under = circle.radius * circle.radius - curves::dot(circle.center - middle, circle.center - middle);
    if (under < 0.0) return std::nullopt;
    found = {middle + std::sqrt(under) * along, middle - std::sqrt(under) * along};
  } else {
    const Arc& c = std::get<Arc>(one);
    const Arc& d = std::get<Arc>(other);
    const Point away = d.center - c.center;
    const double distance = curves::norm(away);
    if (distance < kNoDistance_mm) return std::nullopt;
    const double foot = (c.radius * c.radius - d.radius * d.radius + distance * distance) / (2.0 * distance);
    const double under = c.radius * c.radius - foot * foot;
    if (under < 0.0) return std::nullopt;
    const Point along = curves::unit(away);
    found = {c.center + foot * along + std::sqrt(under) * left_of(along),
             c.center + foot * along - std::sqrt(under) * left_of(along)};
  }
  return curves::distance(found[0], near) <= curves::distance(found[1], near) ? found[0] : found[1];
}

}  // namespace

Compensation::Piece Compensation::piece_of(const ir::Motion& move, double radius) {
  Piece piece{.move = move, .path = path_of(move), .led = {}, .radius = radius, .start_up_from = {}};
  if (const auto* arc = std::get_if<Arc>(&piece.path)) {
    const bool inside = (arc->sweep > 0.0) == (move.comp == ir::CompSide::left);
    if (inside && !(arc->radius > radius + kNoDistance_mm))
      notes_.add("an arc is tighter than the cutter: the control would alarm, the axis was taken to turn on the spot",
                 move.place.line);
  }
  piece.led = parallel_path(piece.path, side_of(move.comp) * radius);
  return piece;
}

void Compensation::add(const ir::Motion& move, double radius_mm) {
  constexpr std::uint16_t kPlane = 3U;
  const bool known = (move.axes_unknown & kPlane) == 0;
  if (known && !moves_in_plane(move)) {
    if (pending_ && waiting_.size() == kMostWaiting) flush();
    if (pending_) {
      if (!waiting_.empty())
        notes_.add(
            "several blocks without a move in the plane follow one another under compensation: the control was "
            "taken to look beyond them",
            move.place.line);
      waiting_.push_back(move);
    } else {
      emit_straight(move, start_of(move) + offset_, end_of(move) + offset_);
    }
    return;
  }
  if (move.comp == ir::CompSide::off) {
    flush();
    return lead_away(move);
  }
  if (!known) {
    flush();
    offset_ = {};
    pending_ = Piece{.move = move,
                     .path = Segment{end_of(move), end_of(move)},
                     .led = {},
                     .radius = radius_mm,
                     .is_start_up = true,
                     .has_path = false,
                     .start_up_from = end_of(move)};
    return;
  }
  Piece next = piece_of(move, radius_mm);
  if (pending_) return join(std::move(next));
  if (checks::is_arc(move)) {
    notes_.add("compensation begins with an arc: the control would alarm", move.place.line);
    emit_straight(at_start_of(move, move.kind), start_of(move) + offset_, place_on(next.led, 0.0));
  } else {
    next.is_start_up = true;
    next.start_up_from = start_of(move) + offset_;
  }
  pending_ = std::move(next);
}

void Compensation::join(Piece next) {
  const Piece before = *pending_;
  const Point begin = place_on(next.led, 0.0);
  if (before.is_start_up) {
    close_at(begin);
    pending_ = std::move(next);
    return;
  }
  const Point corner = curves::point_at(before.path, 1.0);
  const Point in = curves::direction_at(before.path, 1.0);
  const Point out = curves::direction_at(next.path, 0.0);
  const double side = side_of(next.move.comp);
  const double turn = side * curves::cross(in, out);  // > 0: towards the tool, a hollow corner
  const bool same_tool = before.move.comp == next.move.comp && before.radius == next.radius;
  const bool meets = curves::distance(place_on(before.led, 1.0), begin) <= kSmallGap_mm;
  const auto join_straight = [&] {
    close(1.0);
    emit_straight(at_start_of(next.move, before.move.kind), place_on(before.led, 1.0), begin);
  };
  if (!same_tool || meets) {
    join_straight();
  } else if (turn > 0.0) {
    const auto meet = crossing(before.led, next.led, corner);
    if (meet) {
      next.from = parameter_of(next.led, *meet, false);
      close(parameter_of(before.led, *meet, true));
    } else {
      notes_.add("the offset paths do not meet in a corner: the control would alarm", next.move.place.line);
      join_straight();
    }
  } else {
    close(1.0);
    pass_outer_corner(before, next);
  }
  pending_ = std::move(next);
}

void Compensation::pass_outer_corner(const Piece& before, const Piece& after) {
  const Point from = place_on(before.led, 1.0);
  const Point to = place_on(after.led, 0.0);
  const Point in = curves::direction_at(before.path, 1.0);
  const Point out = curves::direction_at(after.path, 0.0);
  if (corner_ == OuterCorner::arc && before.move.kind != ir::MotionKind::rapid) {
    const auto turn = before.move.comp == ir::CompSide::left ? curves::Turn::clockwise : curves::Turn::counterclockwise;
    const Point corner = curves::point_at(before.path, 1.0);
    return emit_piece(at_start_of(after.move, before.move.kind), curves::arc_between(from, to, corner, turn));
  }
  // tan(angle/2), at most the radius's own length: a right angle.
  const double cosine = std::clamp(curves::dot(in, out), -1.0, 1.0);
  const double half = cosine > -1.0 ? std::sqrt((1.0 - cosine) / (1.0 + cosine)) : 1.0;
  const double reach = before.radius * std::min(1.0, half);
  const ir::Motion straight = at_start_of(after.move, before.move.kind);
  emit_straight(straight, from, from + reach * in);
  emit_straight(straight, from + reach * in, to - reach * out);
  emit_straight(straight, to - reach * out, to);
}

void Compensation::close(double to) {
  const Piece piece = *std::exchange(pending_, std::nullopt);
  const Point end = place_on(piece.led, to);
  if (to > piece.from) {
    emit_piece(piece.move, between(piece.led, piece.from, to));
  } else {
    if (curves::distance(place_on(piece.led, piece.from), end) > kSame_mm)
      notes_.add("a move is shorter than the cutter needs in its corners: the control would alarm, or cut too deep",
                 piece.move.place.line);
    emit_straight(piece.move, place_on(piece.led, piece.from), end);
  }
  end_waiting(end_of(piece.move), end);
}

void Compensation::close_at(Point at) {
  const Piece piece = *std::exchange(pending_, std::nullopt);
  if (piece.has_path) {
    emit_straight(piece.move, piece.start_up_from, at);
  } else {
    ir::Motion move = piece.move;
    move.comp = ir::CompSide::off;
    move.start[0] = move.end[0] = at.z;
    move.start[1] = move.end[1] = at.x;
    out_.push_back(move);
  }
  end_waiting(end_of(piece.move), at);
}

// The axis stands where it ended while others move.
void Compensation::end_waiting(Point programmed, Point led) {
  offset_ = led - programmed;
  for (const ir::Motion& move : waiting_) emit_straight(move, led, led);
  waiting_.clear();
}

void Compensation::flush() {
  if (!pending_) return;
  if (!pending_->is_start_up) return close(1.0);
  close_at(pending_->has_path ? place_on(pending_->led, 1.0) : pending_->start_up_from);
}

void Compensation::forget() {
  flush();
  offset_ = {};
}

// Without compensation again: straight from where the axis stands to the programmed end.
void Compensation::lead_away(const ir::Motion& move) {
  const bool off_the_path = curves::norm(offset_) > kNoDistance_mm;
  if (checks::is_arc(move) && off_the_path)
    notes_.add("compensation ends with an arc: the control would alarm, it was taken as a line", move.place.line);
  const bool known = (move.axes_unknown & 3U) == 0;
  if (known && off_the_path) {
    emit_straight(move, start_of(move) + offset_, end_of(move));
  } else {
    out_.push_back(move);
  }
  offset_ = {};
}

void Compensation::emit_straight(const ir::Motion& like, Point from, Point to) {
  ir::Motion move = like;
  const bool stands =
      curves::distance(from, to) <= kNoDistance_mm && std::fabs(like.end[2] - like.start[2]) <= kNoDistance_mm;
  if (stands && like.axes_unknown == 0) return;
  if (checks::is_arc(move)) move.kind = ir::MotionKind::linear;
  move.comp = ir::CompSide::off;
  move.start[0] = from.z;
  move.start[1] = from.x;
  move.end[0] = to.z;
  move.end[1] = to.x;
  out_.push_back(move);
}

void Compensation::emit_piece(const ir::Motion& move, const PathPiece& piece) {
  const auto* arc = std::get_if<Arc>(&piece);
  const Point from = curves::point_at(piece, 0.0);
  const Point to = curves::point_at(piece, 1.0);
  // An arc of no length would be taken for a full circle.
  if (arc == nullptr || arc->length() <= kSame_mm) return emit_straight(move, from, to);
  ir::Motion led = move;
  led.comp = ir::CompSide::off;
  led.plane = ir::Plane::xy;
  led.kind = arc->sweep > 0.0 ? ir::MotionKind::arc_ccw : ir::MotionKind::arc_cw;
  led.start[0] = from.z;
  led.start[1] = from.x;
  led.end[0] = to.z;
  led.end[1] = to.x;
  led.center = {arc->center.z - from.z, arc->center.x - from.x, 0.0};
  out_.push_back(led);
}

}  // namespace dripfeed::gouge
