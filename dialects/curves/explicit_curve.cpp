// The nearest point of x = f(z) by bracketing, then a root of the derivative.
//
//            * P                   The vertical gap d above z_P is a distance that is surely reached, so the foot lies
//            in
//            |\                    z_P - d .. z_P + d: a bracket without any search. Half the derivative of the squared
//          d | \ foot              distance is g(z) = (z - z_P) + (f(z) - x_P)·f'(z). Where d times the second
//          derivative
//      ______|__\______ f          is below 1, g rises all through the bracket and has one root: Illinois steps find
//      it.
//                                  Otherwise the bracket is scanned in 32 pieces, and each one with a minimum is
//                                  searched.
//
// A curve without bounds of its second derivative is taken as tame within a bracket of 0.2 mm if its slopes at three
// places say so, and is scanned in wider ones.
#include "dialects/curves/explicit_curve.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dripfeed::curves {

namespace {

constexpr int kPieces = 32;
constexpr int kSteps = 100;
constexpr int kNearSteps = 20;
constexpr double kRelative = 1e-13;
constexpr double kTame_mm = 0.2;

// The curve at one z, seen from the point.
struct Trial {
  double z = 0.0;
  ExplicitPoint curve;
  double gap = 0.0;       // f(z) - x_P
  double gradient = 0.0;  // g(z)
};

class Search {
 public:
  Search(const ExplicitCurve& curve, Point point) : curve_(curve), point_(point) {}

  [[nodiscard]] Trial at(double z) const {
    Trial trial{z, curve_.at(z), 0.0, 0.0};
    trial.gap = trial.curve.x - point_.x;
    // At a vertical tangent the slope is infinite; with no gap it pulls nowhere.
    trial.gradient = (z - point_.z) + (trial.gap == 0.0 ? 0.0 : trial.gap * trial.curve.slope);
    return trial;
  }
  [[nodiscard]] double square(const Trial& trial) const {
    const double dz = trial.z - point_.z;
    return dz * dz + trial.gap * trial.gap;
  }
  // Whether g surely, or for a curve without bounds most likely, rises from a to b.
  [[nodiscard]] bool rises(const Trial& a, const Trial& middle, const Trial& b) const {
    const double gap = std::max({std::fabs(a.gap), std::fabs(middle.gap), std::fabs(b.gap)}) +
                       0.5 * (b.z - a.z) * std::max(std::fabs(a.curve.slope), std::fabs(b.curve.slope));
    if (curve_.second_derivatives) {
      const Range second = curve_.second_derivatives(a.z, b.z);
      return gap * std::max(std::fabs(second.low), std::fabs(second.high)) < 1.0;
    }
    if (b.z - a.z > kTame_mm) return false;
    const auto turn = [](const Trial& p, const Trial& q) {
      return q.z > p.z ? std::fabs((q.curve.slope - p.curve.slope) / (q.z - p.z)) : 0.0;
    };
    return gap * std::max(turn(a, middle), turn(middle, b)) < 0.5;
  }
  // Root of g between a (g <= 0) and b (g >= 0), by false position with the Illinois rule; bisection where that fails.
  [[nodiscard]] Trial root(Trial a, Trial b) const {
    double at_a = a.gradient;
    double at_b = b.gradient;
    int side = 0;
    for (int step = 0; step < kSteps; ++step) {
      const double width = b.z - a.z;
      if (width <= kRelative * (std::fabs(a.z) + std::fabs(b.z)) || width < 1e-15) break;
      double z = b.z - at_b * width / (at_b - at_a);
      if (!(z > a.z && z < b.z) || step % 8 == 7) z = a.z + 0.5 * width;
      const Trial trial = at(z);
      if (trial.gradient == 0.0) return trial;
      if (trial.gradient < 0.0) {
        a = trial;
        at_a = trial.gradient;
        if (side == -1) at_b *= 0.5;
        side = -1;
      } else {
        b = trial;
        at_b = trial.gradient;
        if (side == 1) at_a *= 0.5;
        side = 1;
      }
      // Both g and its rise (at least about 1) are known: the root is this near.
      if (std::fabs(trial.gradient) < kRelative * (1.0 + std::fabs(trial.z))) return trial;
    }
    return square(a) < square(b) ? a : b;
  }
  // Where the point lies so near that g must rise by at least half of itself all over the bracket, Newton's steps with
  // the slope alone run to its one root; nothing where that is not sure.
  [[nodiscard]] std::optional<Trial> near_root(const Trial& middle) const {
    const double gap = std::fabs(middle.gap);
    const double slope = std::fabs(middle.curve.slope) + curve_.second_limit * gap;
    if (!(gap * (1.0 + slope) * curve_.second_limit < 0.5)) return std::nullopt;
    Trial trial = middle;
    for (int step = 0; step < kNearSteps; ++step) {
      const double rise = 1.0 + trial.curve.slope * trial.curve.slope;
      const double z = std::clamp(trial.z - trial.gradient / rise, curve_.z.low, curve_.z.high);
      if (std::fabs(z - trial.z) <= kRelative * (1.0 + std::fabs(z))) return trial;
      trial = at(z);
    }
    return std::nullopt;
  }
  // The best minimum among the pieces between a and b.
  [[nodiscard]] Trial scan(const Trial& a, const Trial& b) const {
    Trial nearest = square(a) <= square(b) ? a : b;
    Trial before = a;
    for (int i = 1; i <= kPieces; ++i) {
      const Trial after = i == kPieces ? b : at(a.z + (b.z - a.z) * i / kPieces);
      if (square(after) < square(nearest)) nearest = after;
      if (before.gradient <= 0.0 && after.gradient >= 0.0) {
        const Trial found = root(before, after);
        if (square(found) < square(nearest)) nearest = found;
      }
      before = after;
    }
    return nearest;
  }

 private:
  const ExplicitCurve& curve_;
  Point point_;
};

Foot foot_of(const ExplicitCurve& curve, const Search& search, const Trial& nearest, Point point) {
  Foot foot{nearest.z, nearest.curve, 0.0, Beyond::none, 0.0};
  const Point offset = point - foot.point();
  const double slope = nearest.curve.slope;
  const Point tangent = std::isfinite(slope) ? unit({1.0, slope}) : Point{0.0, std::copysign(1.0, slope)};
  double above = 0.0;
  if (curve.z.contains(point.z)) {
    above = point.x - search.at(point.z).curve.x;  // above the graph at its own z: above it
  } else {
    above = cross(tangent, offset);
  }
  foot.distance = std::copysign(norm(offset), above);
  const double overhang = dot(offset, tangent);
  const double least = 1e-9 + 1e-7 * norm(offset);
  if (nearest.z <= curve.z.low && overhang < -least) {
    foot.beyond = Beyond::low;
    foot.overhang = -overhang;
  } else if (nearest.z >= curve.z.high && overhang > least) {
    foot.beyond = Beyond::high;
    foot.overhang = overhang;
  }
  return foot;
}

}  // namespace

double second_limit_of(const ExplicitCurve& curve) {
  if (!curve.second_derivatives) return std::numeric_limits<double>::infinity();
  const Range second = curve.second_derivatives(curve.z.low, curve.z.high);
  const double limit = std::max(std::fabs(second.low), std::fabs(second.high));
  return std::isnan(limit) ? std::numeric_limits<double>::infinity() : limit;
}

Foot closest(const ExplicitCurve& curve, Point point) {
  const Search search(curve, point);
  const Trial middle = search.at(std::clamp(point.z, curve.z.low, curve.z.high));
  const double reach = std::sqrt(search.square(middle));
  if (reach == 0.0) return foot_of(curve, search, middle, point);
  if (curve.z.contains(point.z)) {
    if (const std::optional<Trial> found = search.near_root(middle)) return foot_of(curve, search, *found, point);
  }
  const Trial low = search.at(std::max(curve.z.low, point.z - reach));
  const Trial high = search.at(std::min(curve.z.high, point.z + reach));
  Trial nearest = middle;
  if (!search.rises(low, middle, high)) {
    nearest = search.scan(low, high);
  } else if (low.gradient >= 0.0) {
    nearest = low;
  } else if (high.gradient <= 0.0) {
    nearest = high;
  } else if (middle.gradient != 0.0) {
    nearest = middle.gradient > 0.0 ? search.root(low, middle) : search.root(middle, high);
  }
  if (search.square(middle) < search.square(nearest)) nearest = middle;
  return foot_of(curve, search, nearest, point);
}

}  // namespace dripfeed::curves
