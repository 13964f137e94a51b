// Angles along an arc are measured in its own sense of turning, from its start, so that both senses share the code.
#include "dialects/curves/arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dripfeed::curves {

namespace {

constexpr double kFull = 2.0 * std::numbers::pi;
constexpr double kSamePoint_mm = 1e-9;

double angle_of(Point v) { return std::atan2(v.x, v.z); }

// 0 .. 2π, not 2π itself.
double wrapped(double angle) {
  const double rest = std::fmod(angle, kFull);
  const double positive = rest < 0.0 ? rest + kFull : rest;
  return positive >= kFull ? 0.0 : positive;
}

// How far `angle` comes after the start, in the arc's sense, 0 .. 2π.
double along(const Arc& arc, double angle) {
  return wrapped(arc.sweep < 0.0 ? arc.start_angle - angle : angle - arc.start_angle);
}

}  // namespace

Point Arc::at(double t) const {
  const double angle = start_angle + t * sweep;
  return center + Point{radius * std::cos(angle), radius * std::sin(angle)};
}

Point Arc::direction(double t) const {
  const double angle = start_angle + t * sweep;
  const Point left{-std::sin(angle), std::cos(angle)};
  return sweep < 0.0 ? -1.0 * left : left;
}

Arc arc_between(Point start, Point end, Point center, Turn turn) {
  Arc arc{center, 0.5 * (distance(start, center) + distance(end, center)), angle_of(start - center), 0.0};
  const double end_angle = angle_of(end - center);
  double sweep = kFull;
  if (distance(start, end) >= kSamePoint_mm) {
    sweep = wrapped(turn == Turn::counterclockwise ? end_angle - arc.start_angle : arc.start_angle - end_angle);
  }
  arc.sweep = turn == Turn::counterclockwise ? sweep : -sweep;
  return arc;
}

double closest_parameter(const Arc& arc, Point point) {
  const double sweep = std::fabs(arc.sweep);
  if (!(sweep > 0.0) || point == arc.center) return 0.0;
  const double angle = along(arc, angle_of(point - arc.center));
  if (angle <= sweep) return angle / sweep;
  return distance(point, arc.at(0.0)) <= distance(point, arc.at(1.0)) ? 0.0 : 1.0;
}

double distance(const Arc& arc, Point point) { return distance(arc.at(closest_parameter(arc, point)), point); }

Box box_of(const Arc& arc) {
  const Point a = arc.at(0.0);
  const Point b = arc.at(1.0);
  Box box{{std::min(a.z, b.z), std::max(a.z, b.z)}, {std::min(a.x, b.x), std::max(a.x, b.x)}};
  const double sweep = std::fabs(arc.sweep);
  const auto reaches = [&](double angle) { return along(arc, angle) <= sweep; };
  if (reaches(0.0)) box.z.high = arc.center.z + arc.radius;
  if (reaches(std::numbers::pi)) box.z.low = arc.center.z - arc.radius;
  if (reaches(0.5 * std::numbers::pi)) box.x.high = arc.center.x + arc.radius;
  if (reaches(1.5 * std::numbers::pi)) box.x.low = arc.center.x - arc.radius;
  return box;
}

}  // namespace dripfeed::curves
