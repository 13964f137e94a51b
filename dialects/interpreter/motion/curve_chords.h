// A curve as chords: each lies within kCurveChord_mm of it, as far as kDeepest halvings go (a circle of 50 m).
#pragma once

#include <algorithm>
#include <cmath>

#include "dialects/interpreter/state/modal_state.h"

namespace dripfeed::interpreter {

inline constexpr double kCurveChord_mm = 0.001;

// How far a point lies from a chord; a diameter counts as it is kept, which is the stricter.
inline double aside_of_chord(const AxisValues& a, const AxisValues& b, const AxisValues& p) {
  double along = 0.0;
  double length = 0.0;
  for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis) {
    along += (b[axis] - a[axis]) * (p[axis] - a[axis]);
    length += (b[axis] - a[axis]) * (b[axis] - a[axis]);
  }
  const double share = length > 0.0 ? std::clamp(along / length, 0.0, 1.0) : 0.0;
  double sum = 0.0;
  for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis) {
    const double d = p[axis] - a[axis] - share * (b[axis] - a[axis]);
    sum += d * d;
  }
  return std::sqrt(sum);
}

// `at(u)` gives a point of the curve, `emit(point)` takes the end of each chord from u0 to u1 in turn.
template <class At, class Emit>
class CurveChords {
 public:
  CurveChords(const At& at, const Emit& emit) : at_(at), emit_(emit) {}
  void run(double u0, double u1) { halve(u0, at_(u0), u1, at_(u1), 0); }

 private:
  static constexpr int kDeepest = 14;  // halvings

  // Looked at in three places, so that a curve that crosses its chord in the middle is seen.
  void halve(double u0, const AxisValues& a, double u1, const AxisValues& b, int depth) {
    const double middle = 0.5 * (u0 + u1);
    const AxisValues m = at_(middle);
    bool flat = depth >= 2 && aside_of_chord(a, b, m) <= kCurveChord_mm;
    for (const double share : {0.25, 0.75})
      flat = flat && aside_of_chord(a, b, at_(u0 + share * (u1 - u0))) <= kCurveChord_mm;
    if (flat || depth >= kDeepest) return emit_(b);
    halve(u0, a, middle, m, depth + 1);
    halve(middle, m, u1, b, depth + 1);
  }

  const At& at_;
  const Emit& emit_;
};

}  // namespace dripfeed::interpreter
