// Seen from above the swept area is a capsule. Over a place at `along` and `across` of the line the height is
//
//    min over τ in [0, length] of  z0 + slope·τ + rise(sqrt(across² + (τ - along)²)),
//
// convex in τ, because the lower side is. Level lines have the minimum where the axis passes next; the flat mill at an
// end of the stretch over which it covers the place; the ball mill at τ = along - slope·c/sqrt(1 + slope²) with
// c² = radius² - across². For the bull nose the derivative is bisected.
#include "checks/gouge/sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dripfeed::gouge {

namespace {

constexpr double kUpright_mm = 1e-9;
constexpr int kBisections = 40;

}  // namespace

Sweep::Sweep(const Cutter& cutter, const Point3& from, const Point3& to) : cutter_(cutter), from_(from), to_(to) {
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  length_ = std::hypot(dx, dy);
  z_low_ = std::min(from.z, to.z);
  upright_ = length_ < kUpright_mm;
  level_ = from.z == to.z;
  if (upright_) {
    length_ = 0.0;
    from_.z = z_low_;  // the lower end covers all that the upper one does
  } else {
    dir_x_ = dx / length_;
    dir_y_ = dy / length_;
    slope_ = (to.z - from.z) / length_;
  }
}

double Sweep::y_low() const { return std::min(from_.y, to_.y) - cutter_.radius; }
double Sweep::y_high() const { return std::max(from_.y, to_.y) + cutter_.radius; }

std::optional<Sweep::Row> Sweep::start_row(double y) const {
  const double away = y - from_.y;
  if (std::fabs(away) > cutter_.radius) return std::nullopt;
  const double half = std::sqrt(cutter_.radius * cutter_.radius - away * away);
  return Row{from_.x - half, from_.x + half};
}

// The capsule is convex: a row meets it in one stretch, whose ends lie on a disk or on a side.
std::optional<Sweep::Row> Sweep::row(double y) const {
  Row out{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const auto include = [&out](double x) {
    out.low = std::min(out.low, x);
    out.high = std::max(out.high, x);
  };
  for (const Point3& end : {from_, to_}) {
    const double away = y - end.y;
    if (std::fabs(away) > cutter_.radius) continue;
    const double half = std::sqrt(cutter_.radius * cutter_.radius - away * away);
    include(end.x - half);
    include(end.x + half);
  }
  if (!upright_ && dir_y_ != 0.0) {
    for (const double side : {-1.0, 1.0}) {
      const double start_x = from_.x - side * cutter_.radius * dir_y_;
      const double start_y = from_.y + side * cutter_.radius * dir_x_;
      const double along = (y - start_y) / dir_y_;
      if (along >= 0.0 && along <= length_) include(start_x + along * dir_x_);
    }
  }
  if (out.low > out.high) return std::nullopt;
  return out;
}

Sweep::Place Sweep::seen_from_start(double x, double y) const {
  const double along = (x - from_.x) * dir_x_ + (y - from_.y) * dir_y_;
  const double across = (y - from_.y) * dir_x_ - (x - from_.x) * dir_y_;
  return {along, across * across};
}

std::optional<double> Sweep::share_until(double x, double y) const {
  const auto [along, across_square] = seen_from_start(x, y);
  const double room = cutter_.radius * cutter_.radius - across_square;
  if (room < 0.0) return std::nullopt;
  const double half = std::sqrt(room);
  const double first = std::max(0.0, along - half);
  if (first > std::min(length_, along + half)) return std::nullopt;
  return length_ > 0.0 ? first / length_ : 0.0;
}

double Sweep::share_before(double x, double y) const { return upright_ ? 1.0 : share_until(x, y).value_or(1.0); }

double Sweep::lowest_before(double x, double y, double share) const {
  const auto [along, across_square] = seen_from_start(x, y);
  const double half = std::sqrt(std::max(0.0, cutter_.radius * cutter_.radius - across_square));
  const double at = slope_ >= 0.0 ? std::max(0.0, along - half) : std::min({length_, along + half, share * length_});
  return from_.z + slope_ * at;
}

double Sweep::lowest(double x, double y) const {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto [along, across_square] = seen_from_start(x, y);
  const double room = cutter_.radius * cutter_.radius - across_square;
  if (room < 0.0) return infinity;
  if (upright_ || level_) {
    const double past = along - std::clamp(along, 0.0, length_);
    const double square = past * past + across_square;
    if (square > cutter_.radius * cutter_.radius) return infinity;
    return from_.z + (cutter_.corner > 0.0 ? cutter_.rise(std::sqrt(square)) : 0.0);
  }
  const double half = std::sqrt(room);
  const double first = std::max(0.0, along - half);
  const double last = std::min(length_, along + half);
  if (first > last) return infinity;
  if (cutter_.corner == 0.0) return from_.z + slope_ * (slope_ >= 0.0 ? first : last);
  if (cutter_.corner == cutter_.radius) {
    const double at = std::clamp(along - slope_ * half / std::sqrt(1.0 + slope_ * slope_), first, last);
    const double past = at - along;
    return from_.z + slope_ * at + cutter_.radius - std::sqrt(std::max(0.0, room - past * past));
  }
  return lowest_of_round(along, across_square);
}

double Sweep::lowest_of_round(double along, double across_square) const {
  const double half = std::sqrt(std::max(0.0, cutter_.radius * cutter_.radius - across_square));
  double first = std::max(0.0, along - half);
  double last = std::min(length_, along + half);
  const double flat = cutter_.radius - cutter_.corner;
  // slope + rise'(r)·(τ - along)/r grows with τ.
  const auto gradient = [&](double at) {
    const double distance = std::sqrt(across_square + (at - along) * (at - along));
    const double beyond = distance - flat;
    if (!(beyond > 0.0)) return slope_;
    const double under = cutter_.corner * cutter_.corner - beyond * beyond;
    const double steep = under > 0.0 ? beyond / std::sqrt(under) : 1e12;
    return slope_ + steep * (at - along) / distance;
  };
  for (int i = 0; i < kBisections && first < last; ++i) {
    const double middle = 0.5 * (first + last);
    (gradient(middle) < 0.0 ? first : last) = middle;
  }
  const double at = 0.5 * (first + last);
  return from_.z + slope_ * at + cutter_.rise(std::sqrt(across_square + (at - along) * (at - along)));
}

}  // namespace dripfeed::gouge
