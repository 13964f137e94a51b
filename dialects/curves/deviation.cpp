// Sampling of a smooth function of t with few places, and parabolas through the best three of them.
#include "dialects/curves/deviation.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dripfeed::curves {

namespace {

constexpr int kFewest = 4;  // pieces; even, for Simpson's rule
constexpr int kMost = 128;
constexpr double kPieceLength_mm = 1.0;
constexpr double kShort_mm = 0.25;
constexpr int kRefinements = 3;
constexpr int kBisections = 30;  // of a millimetre: 1e-9 mm

struct Sample {
  double t = 0.0;
  double value = 0.0;
  bool on = false;  // on the profile, not beyond its ends
};

class Walk {
 public:
  Walk(const Profile& profile, const PathPiece& piece, Deviation& result)
      : profile_(profile), piece_(piece), result_(result) {}

  Sample at(double t) {
    const Point point = point_at(piece_, t);
    const ProfileFoot nearest = closest(profile_, point);
    if (t == 0.0) result_.first = nearest;
    if (t == 1.0) result_.last = nearest;
    const Foot& foot = nearest.foot;
    result_.overhang = std::max(result_.overhang, foot.overhang);
    if (foot.beyond != Beyond::none) return {t, foot.distance, false};
    const Extreme here{foot.distance, point, profile_.pieces[nearest.piece].tolerance};
    if (result_.points == 0) {
      result_.highest = result_.lowest = here;
      result_.z = {foot.z, foot.z};
    }
    ++result_.points;
    if (here.value > result_.highest.value) result_.highest = here;
    if (here.value < result_.lowest.value) result_.lowest = here;
    result_.z = {std::min(result_.z.low, foot.z), std::max(result_.z.high, foot.z)};
    return {t, foot.distance, true};
  }

  // Where the path passes an end of the profile: measures the last place on it.
  void find_end(Sample on, Sample off) {
    for (int i = 0; i < kBisections; ++i) {
      const Sample middle = at(0.5 * (on.t + off.t));
      (middle.on ? on : off) = middle;
    }
  }

  // The top (sign 1) or bottom (-1) near the middle one of three neighbours.
  void refine(Sample a, Sample b, Sample c, double sign, double above) {
    for (int i = 0; i < kRefinements && a.on && b.on && c.on; ++i) {
      const double left = (b.value - a.value) / (b.t - a.t);
      const double right = (c.value - b.value) / (c.t - b.t);
      const double bend = (right - left) / (c.t - a.t);
      if (!(sign * bend < 0.0)) return;
      const double top = 0.5 * (a.t + b.t) - 0.5 * left / bend;
      if (!(top > a.t && top < c.t) || std::fabs(top - b.t) < 1e-6) return;
      const double height = b.value - bend * (top - b.t) * (top - b.t);
      if (sign * height <= above && sign * b.value <= above) return;
      const Sample found = at(top);
      if (sign * found.value <= sign * b.value) {
        (top < b.t ? a : c) = found;
      } else {
        (top < b.t ? c : a) = b;
        b = found;
      }
    }
  }

 private:
  const Profile& profile_;
  const PathPiece& piece_;
  Deviation& result_;
};

int pieces_of(double length) {
  if (length < kShort_mm) return 2;
  const double wanted = std::ceil(length / kPieceLength_mm);
  return wanted >= kMost ? kMost : std::max(kFewest, 2 * static_cast<int>(std::ceil(0.5 * wanted)));
}

}  // namespace

Deviation measure(const Profile& profile, const PathPiece& piece, double refine_above) {
  Deviation result;
  const double length = length_of(piece);
  const int pieces = pieces_of(length);
  Walk walk(profile, piece, result);
  std::array<Sample, kMost + 1> samples{};
  for (int i = 0; i <= pieces; ++i) samples[static_cast<std::size_t>(i)] = walk.at(static_cast<double>(i) / pieces);

  for (std::size_t i = 0; i < static_cast<std::size_t>(pieces); ++i) {
    if (samples[i].on != samples[i + 1].on) {
      walk.find_end(samples[i].on ? samples[i] : samples[i + 1], samples[i].on ? samples[i + 1] : samples[i]);
    }
  }
  const double pair = 2.0 * length / pieces;
  for (std::size_t i = 0; i + 2 <= static_cast<std::size_t>(pieces); i += 2) {
    const Sample& a = samples[i];
    const Sample& b = samples[i + 1];
    const Sample& c = samples[i + 2];
    if (!a.on || !b.on || !c.on) continue;
    result.length += pair;
    result.integral += pair / 6.0 * (std::fabs(a.value) + 4.0 * std::fabs(b.value) + std::fabs(c.value));
    result.integral_square += pair / 6.0 * (a.value * a.value + 4.0 * b.value * b.value + c.value * c.value);
  }
  for (std::size_t i = 1; i + 1 <= static_cast<std::size_t>(pieces); ++i) {
    const Sample& a = samples[i - 1];
    const Sample& b = samples[i];
    const Sample& c = samples[i + 1];
    if (b.value >= a.value && b.value >= c.value) walk.refine(a, b, c, 1.0, refine_above);
    if (b.value <= a.value && b.value <= c.value) walk.refine(a, b, c, -1.0, refine_above);
  }
  return result;
}

Deviation measure(const Profile& profile, Point point) {
  Deviation result;
  const PathPiece piece = Segment{point, point};
  Walk(profile, piece, result).at(0.0);
  return result;
}

}  // namespace dripfeed::curves
