// The contour is taken as lines and arcs in the plane, moved aside, and every moved element is measured against every
// element of the contour: nearer than the distance is a fault.
#include "dialects/family/offset_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "dialects/family/evaluate.h"
#include "dialects/text/number.h"

namespace dripfeed::family {

namespace {

using ir::ExpressionId;

constexpr double kEven_mm = 0.002;              // as far as numbers of a drawing are rounded
constexpr double kShortest_mm = 0.001;          // what is shorter has vanished
constexpr double kShortestOuterArc_mm = 0.005;  // what is shorter would be rounded to a full circle or to nothing
constexpr double kSmooth_mm = 0.0005;
constexpr double kNearer_mm = 0.002;  // below the distance; the corners without an arc are 0.0007 off at most
constexpr double kFullTurn = 2.0 * std::numbers::pi;
constexpr double kReversal = 0.02;  // radians

struct Vec {
  double u = 0.0;
  double v = 0.0;
};
Vec operator+(Vec a, Vec b) { return {a.u + b.u, a.v + b.v}; }
Vec operator-(Vec a, Vec b) { return {a.u - b.u, a.v - b.v}; }
Vec operator*(double k, Vec a) { return {k * a.u, k * a.v}; }
double dot(Vec a, Vec b) { return a.u * b.u + a.v * b.v; }
double cross(Vec a, Vec b) { return a.u * b.v - a.v * b.u; }
double length(Vec a) { return std::hypot(a.u, a.v); }
Vec turned(Vec a) { return {-a.v, a.u}; }

struct Piece {
  bool is_arc = false;
  bool clockwise = false;
  Vec from, to;
  Vec center = {};
  double radius = 0.0;
  double sweep = 0.0;  // of an arc: up to a full turn, in its direction
};

// From one direction to another in an arc's direction: above 0, a full turn where they are equal.
double sweep_between(Vec from, Vec to, bool clockwise) {
  double angle = std::atan2(cross(from, to), dot(from, to));
  if (clockwise) angle = -angle;
  return angle > 1e-9 ? angle : angle + kFullTurn;
}

bool reaches(const Piece& arc, Vec at) {
  const double angle = sweep_between(arc.from - arc.center, at - arc.center, arc.clockwise);
  return angle <= arc.sweep + 1e-9 || angle >= kFullTurn - 1e-9;
}

double distance_to(const Piece& piece, Vec at) {
  double nearest = std::min(length(at - piece.from), length(at - piece.to));
  if (piece.is_arc) {
    const double off = length(at - piece.center);
    if (off < 1e-12) return piece.radius;
    if (reaches(piece, at)) nearest = std::min(nearest, std::abs(off - piece.radius));
    return nearest;
  }
  const Vec along = piece.to - piece.from;
  const double part = dot(at - piece.from, along) / std::max(dot(along, along), 1e-18);
  return part <= 0.0 || part >= 1.0 ? nearest : length(at - (piece.from + part * along));
}

bool lies_on(const Piece& piece, Vec at) {
  if (piece.is_arc) return std::abs(length(at - piece.center) - piece.radius) < 1e-6 && reaches(piece, at);
  const Vec along = piece.to - piece.from;
  const double part = dot(at - piece.from, along);
  return part >= 0.0 && part <= dot(along, along);
}

void add_crossings(std::vector<Vec>& out, Vec from, Vec along, Vec center, double radius) {
  const double size = length(along);
  if (size < 1e-12) return;
  const Vec unit = (1.0 / size) * along;
  const double foot = dot(center - from, unit);
  const Vec nearest = from + foot * unit;
  out.push_back(nearest);
  const double off = length(nearest - center);
  if (off > radius) return;
  const double reach = std::sqrt(radius * radius - off * off);
  out.push_back(nearest + reach * unit);
  out.push_back(nearest - reach * unit);
}

// Places of `one` where its distance from `other` may be least, beyond the ends of both.
std::vector<Vec> candidates(const Piece& one, const Piece& other) {
  std::vector<Vec> out;
  const Vec along = one.to - one.from;
  if (!one.is_arc && !other.is_arc) {
    const Vec across = other.to - other.from;
    const double turn = cross(along, across);
    if (std::abs(turn) > 1e-12) out.push_back(one.from + (cross(other.from - one.from, across) / turn) * along);
  } else if (!one.is_arc) {
    add_crossings(out, one.from, along, other.center, other.radius);
  } else if (!other.is_arc) {
    const Vec across = other.to - other.from;
    add_crossings(out, other.from, across, one.center, one.radius);
    const double size = std::max(length(across), 1e-12);
    for (const double side : {-1.0, 1.0}) out.push_back(one.center + (side * one.radius / size) * turned(across));
  } else {
    const Vec between = other.center - one.center;
    const double size = length(between);
    if (size < 1e-9) return out;
    for (const double side : {-1.0, 1.0}) out.push_back(one.center + (side * one.radius / size) * between);
    const double a = (size * size + one.radius * one.radius - other.radius * other.radius) / (2.0 * size);
    if (std::abs(a) > one.radius) return out;
    const double reach = std::sqrt(one.radius * one.radius - a * a);
    for (const double side : {-1.0, 1.0})
      out.push_back(one.center + (a / size) * between + (side * reach / size) * turned(between));
  }
  return out;
}

double distance_between(const Piece& one, const Piece& other) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec& at : {one.from, one.to}) nearest = std::min(nearest, distance_to(other, at));
  for (const Vec& at : {other.from, other.to}) nearest = std::min(nearest, distance_to(one, at));
  for (const Vec& at : candidates(one, other))
    if (lies_on(one, at)) nearest = std::min(nearest, distance_to(other, at));
  return nearest;
}

class Check {
 public:
  Check(const BoundFamily& bound, std::span<const std::uint8_t> known, const OffsetContour& contour)
      : family_(*bound.family),
        contour_(contour),
        values_(bound.values.begin(), bound.values.end()),
        known_(known.begin(), known.end()) {}

  OffsetCorners corners() {
    read();
    if (!out_.fault) find_corners();
    if (!out_.fault) measure();
    if (out_.fault) out_.values.clear();
    return std::move(out_);
  }

 private:
  [[nodiscard]] bool is_known(ExpressionId id) const {
    return id == ExpressionId::none || !names_unknown(family_.arena, id, known_);
  }
  [[nodiscard]] double value(ExpressionId id) const {
    return id == ExpressionId::none ? 0.0 : evaluate(family_.arena, id, values_).value;
  }
  [[nodiscard]] Vec place(ExpressionId u, ExpressionId v) const {
    return {value(u) / (contour_.doubles_u ? 2.0 : 1.0), value(v) / (contour_.doubles_v ? 2.0 : 1.0)};
  }
  void fault(text::Span span, std::string text) {
    if (!out_.fault) out_.fault = ContourFault{span, std::move(text)};
  }
  void fault_of(std::size_t piece, std::string text) { fault(contour_.items[items_[piece]].span, std::move(text)); }
  void open(text::Span span) {
    fault(span,
          "a contour is checked before the program runs: 'offset' and its contour depend on parameters only, and on "
          "what follows from them");
  }

  void read() {
    if (!is_known(contour_.distance)) return open(contour_.span);
    distance_ = value(contour_.distance);
    if (!(distance_ >= 0.0) || !std::isfinite(distance_))
      return fault(contour_.span, "the distance of 'offset' is not below 0: 'left' and 'right' are its sides");
    std::optional<Vec> last;
    for (std::size_t n = 0; n < contour_.items.size() && !out_.fault; ++n) {
      const OffsetContour::Item& one = contour_.items[n];
      if (one.target != ir::SymbolId::none) {
        if (!is_known(one.value)) return open(one.span);
        values_[static_cast<std::size_t>(one.target)] = value(one.value);
        known_[static_cast<std::size_t>(one.target)] = 1;
        continue;
      }
      for (const ExpressionId id : {one.u, one.v, one.i, one.j, one.radius})
        if (!is_known(id)) return open(one.span);
      const Vec at = place(one.u, one.v);
      if (!std::isfinite(at.u) || !std::isfinite(at.v)) return fault(one.span, "has no place here");
      if (last)
        add(*last, at, n);
      else
        start_ = one.corner;
      last = at;
    }
  }

  void add(Vec from, Vec to, std::size_t item) {
    const OffsetContour::Item& one = contour_.items[item];
    Piece piece{.is_arc = one.is_arc, .clockwise = one.clockwise, .from = from, .to = to};
    const Vec chord = to - from;
    if (!one.is_arc) {
      if (length(chord) < kShortest_mm) return fault(one.span, "this line of the contour of 'offset' has no length");
      if (one.direction != ir::SymbolId::none)
        out_.values.emplace_back(one.direction, chord.u + chord.v > 0.0 ? 1.0 : -1.0);
    } else {
      if (one.radius != ExpressionId::none) {
        piece.radius = value(one.radius);
        if (!(piece.radius > 0.0) || !(2.0 * piece.radius >= length(chord) - kEven_mm) || length(chord) < kShortest_mm)
          return fault(one.span, "this arc of the contour does not reach its end: its radius is too small");
        const double w = std::sqrt(std::abs(piece.radius * piece.radius / dot(chord, chord) - 0.25));
        piece.center = from + 0.5 * chord + (one.clockwise ? -w : w) * turned(chord);
      } else {
        piece.center = from + Vec{value(one.i), value(one.j)};
        piece.radius = length(from - piece.center);
        if (std::abs(length(to - piece.center) - piece.radius) > kEven_mm)
          return fault(one.span, "the ends of this arc of the contour are not equally far from its center");
        if (piece.radius < kShortest_mm) return fault(one.span, "this arc of the contour has no radius");
      }
      piece.sweep = sweep_between(from - piece.center, to - piece.center, one.clockwise);
      if (length(chord) < kShortest_mm) piece.sweep = kFullTurn;
    }
    pieces_.push_back(piece);
    items_.push_back(item);
  }

  // Towards the offset, of length 1.
  [[nodiscard]] Vec normal(const Piece& piece, Vec at) const {
    if (piece.is_arc) {
      const Vec outward = (1.0 / length(at - piece.center)) * (at - piece.center);
      return (piece.clockwise == contour_.is_left ? 1.0 : -1.0) * outward;
    }
    const Vec along = piece.to - piece.from;
    return (contour_.is_left ? 1.0 : -1.0) / length(along) * turned(along);
  }
  [[nodiscard]] double moved_radius(const Piece& arc) const {
    return arc.radius + (arc.clockwise == contour_.is_left ? distance_ : -distance_);
  }

  void find_corners() {
    if (pieces_.empty()) return;
    starts_.resize(pieces_.size());
    ends_.resize(pieces_.size());
    outer_.assign(pieces_.size(), false);
    for (std::size_t n = 0; n < pieces_.size(); ++n)
      if (pieces_[n].is_arc && !(moved_radius(pieces_[n]) >= kShortest_mm))
        return fault_of(n, fmt::format("this arc vanishes in the offset: its radius is {} mm and the distance {} mm",
                                       text::format_shortest(pieces_[n].radius), text::format_shortest(distance_)));
    for (std::size_t n = 0; n + 1 < pieces_.size() && !out_.fault; ++n)
      meet(n, n + 1, contour_.items[items_[n]].corner);
    if (out_.fault) return;
    const std::size_t last = pieces_.size() - 1;
    if (length(pieces_[last].to - pieces_[0].from) < kShortest_mm) return meet(last, 0, start_);
    starts_[0] = pieces_[0].from + distance_ * normal(pieces_[0], pieces_[0].from);
    ends_[last] = pieces_[last].to + distance_ * normal(pieces_[last], pieces_[last].to);
    decide(start_, Corner::open);
  }
  void decide(ir::SymbolId corner, Corner kind) { out_.values.emplace_back(corner, static_cast<double>(kind)); }

  void meet(std::size_t before, std::size_t after, ir::SymbolId corner) {
    const Piece& one = pieces_[before];
    const Piece& next = pieces_[after];
    const Vec at = one.to;
    const Vec first = normal(one, at);
    const Vec second = normal(next, next.from);
    const double angle = std::atan2(cross(first, second), dot(first, second));
    if (std::abs(angle) > std::numbers::pi - kReversal)
      return fault_of(after, "the contour of 'offset' turns back on itself here");
    const bool is_outer = contour_.is_left ? angle < 0.0 : angle > 0.0;
    if (std::abs(angle) * distance_ < kShortestOuterArc_mm || (!is_outer && !one.is_arc && !next.is_arc)) {
      ends_[before] = starts_[after] = at + (distance_ / (1.0 + dot(first, second))) * (first + second);
      return decide(corner, Corner::straight);
    }
    if (is_outer) {
      ends_[before] = at + distance_ * first;
      starts_[after] = at + distance_ * second;
      outer_[before] = true;
      return decide(corner, Corner::outer);
    }
    const auto [minus, plus] = crossings(one, next, at, first, second);
    const bool do_meet = std::isfinite(minus.u) && std::isfinite(plus.u);
    const Vec straight = at + (distance_ / (1.0 + dot(first, second))) * (first + second);
    const double off = std::max(off_moved(one, at, first, straight), off_moved(next, at, second, straight));
    if (off < (do_meet ? kSmooth_mm : kEven_mm)) {
      ends_[before] = starts_[after] = straight;
      return decide(corner, Corner::straight);
    }
    if (!do_meet)
      return fault_of(after,
                      "the offsets of this element and of the one before it do not meet: the distance is too "
                      "great for them");
    const bool takes_plus = length(plus - at) < length(minus - at);
    ends_[before] = starts_[after] = takes_plus ? plus : minus;
    decide(corner, takes_plus ? Corner::plus_root : Corner::minus_root);
  }

  // How far a place lies from the moved line or circle of a piece, of which a place and its normal are given.
  [[nodiscard]] double off_moved(const Piece& piece, Vec at, Vec across, Vec place) const {
    return std::abs(piece.is_arc ? length(place - piece.center) - moved_radius(piece)
                                 : dot(place - at, across) - distance_);
  }
  // As the program computes them, see offset_reader.cpp. Not a number where they do not meet.
  [[nodiscard]] std::pair<Vec, Vec> crossings(const Piece& one, const Piece& next, Vec at, Vec first,
                                              Vec second) const {
    if (one.is_arc && next.is_arc) {
      const Vec between = next.center - one.center;
      const double square = dot(between, between);
      const double r1 = moved_radius(one);
      const double r2 = moved_radius(next);
      const double along = (square + r1 * r1 - r2 * r2) / (2.0 * square);
      const Vec middle = one.center + along * between;
      const Vec aside = std::sqrt(r1 * r1 / square - along * along) * turned(between);
      return {middle - aside, middle + aside};
    }
    const Piece& arc = one.is_arc ? one : next;
    const Vec across = one.is_arc ? second : first;
    const Vec to_center = arc.center - at;
    const double off = dot(to_center, across) - distance_;
    const double reach = std::sqrt(moved_radius(arc) * moved_radius(arc) - off * off);
    const double foot = dot(to_center, turned(across));
    const Vec from = at + distance_ * across;
    return {from + (foot - reach) * turned(across), from + (foot + reach) * turned(across)};
  }

  void measure() {
    for (std::size_t n = 0; n < pieces_.size() && !out_.fault; ++n) {
      Piece moved = pieces_[n];
      moved.from = starts_[n];
      moved.to = ends_[n];
      if (moved.is_arc) {
        moved.radius = moved_radius(moved);
        moved.sweep = sweep_between(moved.from - moved.center, moved.to - moved.center, moved.clockwise);
        const bool is_full = pieces_[n].sweep >= kFullTurn - 1e-9 && length(moved.to - moved.from) < kShortest_mm;
        if (is_full) moved.sweep = kFullTurn;
        if (!is_full && (moved.sweep * moved.radius < kShortest_mm ||
                         moved.sweep > pieces_[n].sweep + kEven_mm / moved.radius + 1e-6))
          vanishes(n);
      } else if (dot(moved.to - moved.from, pieces_[n].to - pieces_[n].from) <
                 kShortest_mm * length(pieces_[n].to - pieces_[n].from)) {
        vanishes(n);
      }
      moved_.push_back(moved);
    }
    for (std::size_t n = 0; n < pieces_.size() && !out_.fault; ++n) {
      keep_away(moved_[n], n, "the offset of this element");
      if (outer_[n]) keep_away(corner_arc(n), n, "the arc around the end of this element");
    }
  }
  void vanishes(std::size_t n) {
    fault_of(n, fmt::format("this {} vanishes in the offset: its neighbours meet before it at a distance of {} mm",
                            pieces_[n].is_arc ? "arc" : "line", text::format_shortest(distance_)));
  }
  [[nodiscard]] Piece corner_arc(std::size_t n) const {
    const std::size_t next = n + 1 == pieces_.size() ? 0 : n + 1;
    Piece arc{.is_arc = true, .clockwise = contour_.is_left, .from = ends_[n], .to = starts_[next]};
    arc.center = pieces_[n].to;
    arc.radius = distance_;
    arc.sweep = sweep_between(arc.from - arc.center, arc.to - arc.center, arc.clockwise);
    return arc;
  }
  void keep_away(const Piece& moved, std::size_t n, std::string_view what) {
    for (std::size_t other = 0; other < pieces_.size() && !out_.fault; ++other) {
      const double nearest = distance_between(moved, pieces_[other]);
      if (nearest >= distance_ - kNearer_mm) continue;
      fault_of(n, fmt::format("{} comes as near as {} mm to the {} that leads to line {}, "
                              "nearer than its distance of {} mm",
                              what, text::format_fixed(nearest, 3), pieces_[other].is_arc ? "arc" : "line",
                              family_.source.position(contour_.items[items_[other]].span.begin).line,
                              text::format_shortest(distance_)));
    }
  }

  const Family& family_;
  const OffsetContour& contour_;
  std::vector<double> values_;
  std::vector<std::uint8_t> known_;
  double distance_ = 0.0;
  std::vector<Piece> pieces_;
  std::vector<std::size_t> items_;  // of each piece
  std::vector<Vec> starts_;         // of each moved piece
  std::vector<Vec> ends_;
  std::vector<Piece> moved_;
  std::vector<bool> outer_;  // an arc follows it
  ir::SymbolId start_ = ir::SymbolId::none;
  OffsetCorners out_;
};

}  // namespace

OffsetCorners corners_of(const BoundFamily& bound, std::span<const std::uint8_t> known, const OffsetContour& contour) {
  return Check(bound, known, contour).corners();
}

}  // namespace dripfeed::family
