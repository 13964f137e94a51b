// g(t) = (C(t) - P)·C'(t) is half the derivative of the squared distance; a foot is a root at which it rises. Newton
// steps use g'(t) = C'·C' + (C - P)·C'' and are replaced by bisection where they leave the bracket.
#include "dialects/curves/parametric_curve.h"

#include <algorithm>
#include <cmath>

namespace dripfeed::curves {

namespace {

constexpr int kSteps = 60;
constexpr int kNewtonSteps = 20;
constexpr double kSettled_mm = 1e-7;  // along the curve

struct Trial {
  double t = 0.0;
  ParametricPoint curve;
  double square = 0.0;
  double gradient = 0.0;
};

Trial trial_at(const ParametricCurve& curve, Point point, double t) {
  Trial trial{t, curve.at(t), 0.0, 0.0};
  const Point offset = trial.curve.point - point;
  trial.square = dot(offset, offset);
  trial.gradient = dot(offset, trial.curve.derivative);
  return trial;
}

// Between a with g <= 0 and b with g >= 0.
Trial root(const ParametricCurve& curve, Point point, Trial a, Trial b) {
  Trial best = a.square < b.square ? a : b;
  for (int step = 0; step < kSteps && b.t - a.t > 1e-15 * (std::fabs(a.t) + std::fabs(b.t)); ++step) {
    const double rise =
        dot(best.curve.derivative, best.curve.derivative) + dot(best.curve.point - point, best.curve.second);
    double t = rise > 0.0 ? best.t - best.gradient / rise : a.t;
    if (!(t > a.t && t < b.t) || step % 6 == 5) t = a.t + 0.5 * (b.t - a.t);
    const Trial trial = trial_at(curve, point, t);
    const bool settled = trial.t == best.t || trial.gradient == 0.0;
    best = trial;
    if (settled) break;
    (trial.gradient < 0.0 ? a : b) = trial;
  }
  return std::ranges::min({best, a, b}, {}, &Trial::square);
}

ParametricFoot foot_of(const ParametricCurve& curve, Point point, const Trial& nearest) {
  const bool at_low = nearest.t <= curve.t.low;
  const bool at_high = nearest.t >= curve.t.high;
  const Point tangent = unit(nearest.curve.derivative);
  const Point offset = point - nearest.curve.point;
  const double side = cross(tangent, offset);
  ParametricFoot foot{nearest.t, nearest.curve.point, std::copysign(std::sqrt(nearest.square), side), at_low || at_high,
                      0.0};
  if (at_low) foot.overhang = std::max(0.0, -dot(offset, tangent));
  if (at_high) foot.overhang = std::max(foot.overhang, dot(offset, tangent));
  return foot;
}

}  // namespace

double curvature(const ParametricPoint& point) {
  const double speed = norm(point.derivative);
  return speed > 0.0 ? cross(point.derivative, point.second) / (speed * speed * speed) : 0.0;
}

ParametricFoot closest(const ParametricCurve& curve, Point point, int pieces) {
  Trial before = trial_at(curve, point, curve.t.low);
  Trial nearest = before;
  for (int i = 1; i <= pieces; ++i) {
    const double t = i == pieces ? curve.t.high : curve.t.low + curve.t.width() * i / pieces;
    const Trial trial = trial_at(curve, point, t);
    if (trial.square < nearest.square) nearest = trial;
    if (before.gradient <= 0.0 && trial.gradient >= 0.0) {
      const Trial found = root(curve, point, before, trial);
      if (found.square < nearest.square) nearest = found;
    }
    before = trial;
  }
  return foot_of(curve, point, nearest);
}

// Near a center of curvature the distance hardly changes along the curve: only Newton's steps settle there. Far from a
// foot they may lead anywhere, or uphill; then the step of a straight curve still leads downhill.
ParametricFoot closest_from(const ParametricCurve& curve, Point point, double t_near) {
  Trial trial = trial_at(curve, point, std::clamp(t_near, curve.t.low, curve.t.high));
  Trial nearest = trial;
  const auto step_by = [&](double slope) {
    return std::clamp(trial.t - trial.gradient / slope, curve.t.low, curve.t.high);
  };
  const double least = 1e-14 * std::max(std::fabs(curve.t.low), std::fabs(curve.t.high));
  for (int step = 0; step < kNewtonSteps; ++step) {
    const double square = dot(trial.curve.derivative, trial.curve.derivative);
    const double rise = square + dot(trial.curve.point - point, trial.curve.second);
    if (!(square > 0.0)) break;
    const bool bends_well = rise > 0.0;
    const double t = step_by(bends_well ? rise : square);
    // A shorter step cannot be distinguished from rounding; an end is arrived at all the same.
    const bool at_end = t <= curve.t.low || t >= curve.t.high;
    if (t == trial.t || (std::fabs(t - trial.t) <= least && !at_end)) break;
    Trial next = trial_at(curve, point, t);
    const bool nearer = std::fabs(next.gradient) < std::fabs(trial.gradient) && next.square <= trial.square;
    if (bends_well && !nearer) next = trial_at(curve, point, step_by(square));
    if (next.square < nearest.square || next.t <= curve.t.low || next.t >= curve.t.high) nearest = next;
    if (!(std::fabs(next.gradient) < std::fabs(trial.gradient))) break;
    trial = next;
  }
  ParametricFoot foot = foot_of(curve, point, nearest);
  const double aside = std::fabs(nearest.gradient) / std::max(norm(nearest.curve.derivative), 1e-300);
  foot.settled = foot.at_end || aside <= kSettled_mm;
  return foot;
}

}  // namespace dripfeed::curves
