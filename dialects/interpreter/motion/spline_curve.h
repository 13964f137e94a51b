// The curve of a spline: ASPLINE, CSPLINE and BSPLINE of SINUMERIK (PGA, "Spline interpolation"). Pure geometry.
//
// Akima and cubic splines pass through their points; each of X Y Z is a polynomial of third degree over the length of
// the chord (the X of a diameter axis as diameter, the chord in radius values). That the parameter is the chord's
// length, Akima's weights for each axis by itself, and for BAUTO and EAUTO a cubic spline whose first and last two
// pieces are one, are not in the manual. Axes other than X Y Z move in proportion, as they do under the control's own
// choice of the spline's axes.
#pragma once

#include <optional>
#include <vector>

#include "dialects/interpreter/state/modal_state.h"

namespace dripfeed::interpreter {

// How one end of it is to be: ir/spline_use.h. A tangent without a direction is as if there was nothing said.
struct SplineEnd {
  std::int16_t kind = 0;
  std::optional<Vector> direction;  // radius values, of any length but 0; the path that the tool goes
};

class SplineCurve {
 public:
  // At least two points, none where the one before it is; `kind` as ir/spline_use.h.
  SplineCurve(std::int16_t kind, std::size_t degree, std::vector<SplinePoint> points, const SplineEnd& begin,
              const SplineEnd& end, bool x_is_diameter);

  // Whether a piece belongs to the path from point i to point i + 1; of a B spline there is one less a degree.
  [[nodiscard]] bool has_piece(std::size_t i) const { return !is_b_ || i + 1 >= order_ - 1; }
  // Of no length: a knot of a B spline that stands more than once.
  [[nodiscard]] bool is_empty(std::size_t i) const { return is_b_ && b_.knots[i + 2] <= b_.knots[i + 1]; }
  // `share` 0 to 1 of that piece.
  [[nodiscard]] AxisValues at(std::size_t i, double share) const;

 private:
  static constexpr std::size_t kSplineAxes = 3;
  using Slopes = std::vector<double>;

  void find_chords();
  void find_slopes(std::size_t axis, const SplineEnd& begin, const SplineEnd& end);
  [[nodiscard]] Slopes akima(const Slopes& chords) const;
  [[nodiscard]] Slopes cubic(const Slopes& chords, std::optional<double> first, bool first_natural,
                             std::optional<double> last, bool last_natural) const;
  void make_b(std::size_t degree);

  std::vector<SplinePoint> points_;
  bool is_b_;
  bool is_akima_;
  double factor_;  // of X
  std::size_t order_ = 4;
  std::vector<double> lengths_;             // of the chords, mm
  std::array<Slopes, kSplineAxes> slopes_;  // at the points, per mm of chord
  CurveInput b_;
};

}  // namespace dripfeed::interpreter
