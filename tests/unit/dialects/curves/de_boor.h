// The functions of a NURBS curve or surface by their definition: slow, and nothing of the code that is tested.
#pragma once

#include <cstddef>
#include <vector>

namespace dripfeed::curves {

// N_i,p(t) by Cox and de Boor; the last span is closed.
inline double basis(const std::vector<double>& knots, std::size_t i, std::size_t degree, double t) {
  if (degree == 0) {
    const bool last = t == knots.back() && knots[i] < knots[i + 1] && knots[i + 1] == knots.back();
    return (knots[i] <= t && t < knots[i + 1]) || last ? 1.0 : 0.0;
  }
  double sum = 0.0;
  if (knots[i + degree] > knots[i]) {
    sum += (t - knots[i]) / (knots[i + degree] - knots[i]) * basis(knots, i, degree - 1, t);
  }
  if (knots[i + degree + 1] > knots[i + 1]) {
    sum += (knots[i + degree + 1] - t) / (knots[i + degree + 1] - knots[i + 1]) * basis(knots, i + 1, degree - 1, t);
  }
  return sum;
}

}  // namespace dripfeed::curves
