// Small matrices, written out.
#include "dialects/interpreter/state/frame.h"

#include "dialects/interpreter/arithmetic/arithmetic.h"

namespace dripfeed::interpreter {

namespace {

constexpr double kNothing = 1e-12;

double at(const Matrix& m, std::size_t row, std::size_t column) { return m[row * 3 + column]; }

// A turn about one axis: the two others are p and q in right-handed order.
Matrix turn_about(std::size_t axis, double angle_deg) {
  const std::size_t p = (axis + 1) % 3;
  const std::size_t q = (axis + 2) % 3;
  Matrix m = kIdentity;
  m[p * 3 + p] = m[q * 3 + q] = cosine_deg(angle_deg);
  m[p * 3 + q] = -sine_deg(angle_deg);
  m[q * 3 + p] = sine_deg(angle_deg);
  return m;
}

}  // namespace

Matrix multiply(const Matrix& a, const Matrix& b) {
  Matrix m{};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column)
      for (std::size_t k = 0; k < 3; ++k) m[row * 3 + column] += at(a, row, k) * at(b, k, column);
  return m;
}

Vector multiply(const Matrix& m, const Vector& v) {
  Vector out{};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t k = 0; k < 3; ++k) out[row] += at(m, row, k) * v[k];
  return out;
}

Matrix inverse_of(const Matrix& m) {
  const auto minor = [&m](std::size_t row, std::size_t column) {
    const std::size_t r1 = (row + 1) % 3;
    const std::size_t r2 = (row + 2) % 3;
    const std::size_t c1 = (column + 1) % 3;
    const std::size_t c2 = (column + 2) % 3;
    return at(m, r1, c1) * at(m, r2, c2) - at(m, r1, c2) * at(m, r2, c1);
  };
  const double determinant = m[0] * minor(0, 0) + m[1] * minor(0, 1) + m[2] * minor(0, 2);
  if (std::abs(determinant) < kNothing) return kIdentity;
  Matrix out{};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column) out[row * 3 + column] = minor(column, row) / determinant;
  return out;
}

Matrix rotation_of(const Vector& angles_deg) {
  return multiply(multiply(turn_about(2, angles_deg[2]), turn_about(1, angles_deg[1])), turn_about(0, angles_deg[0]));
}

Matrix rotation_in(ir::Plane plane, double angle_deg) { return turn_about(axes_of(plane).normal, angle_deg); }

// Rodrigues: cos · 1 + sin · [u]x + (1 - cos) · u uT.
Matrix rotation_about(const Vector& axis, double angle_deg) {
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  const Vector u = {axis[0] / length, axis[1] / length, axis[2] / length};
  const double c = cosine_deg(angle_deg);
  const double s = sine_deg(angle_deg);
  const Matrix cross = {0.0, -u[2], u[1], u[2], 0.0, -u[0], -u[1], u[0], 0.0};
  Matrix m{};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column)
      m[row * 3 + column] = (row == column ? c : 0.0) + s * at(cross, row, column) + (1.0 - c) * u[row] * u[column];
  return m;
}

Matrix diagonal_of(const Vector& factors) { return {factors[0], 0.0, 0.0, 0.0, factors[1], 0.0, 0.0, 0.0, factors[2]}; }

PlaneImage image_of(const Matrix& m, PlaneAxes axes) {
  const double pp = at(m, axes.p, axes.p);
  const double pq = at(m, axes.p, axes.q);
  const double qp = at(m, axes.q, axes.p);
  const double qq = at(m, axes.q, axes.q);
  const double out_of_plane = std::abs(at(m, axes.p, axes.normal)) + std::abs(at(m, axes.q, axes.normal)) +
                              std::abs(at(m, axes.normal, axes.p)) + std::abs(at(m, axes.normal, axes.q));
  const double first = std::hypot(pp, qp);
  const double second = std::hypot(pq, qq);
  const bool circles = std::abs(first - second) < 1e-9 && std::abs(pp * pq + qp * qq) < 1e-9;
  const bool tilted = !(out_of_plane < 1e-9);
  return {.tilted = tilted, .stays = !tilted && circles, .mirrored = pp * qq - pq * qp < 0.0, .scale = first};
}

bool keeps_shapes(const Matrix& m) {
  const auto product = [&](std::size_t a, std::size_t b) {
    double sum = 0.0;
    for (std::size_t row = 0; row < 3; ++row) sum += at(m, row, a) * at(m, row, b);
    return sum;
  };
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b <= a; ++b)
      if (std::abs(product(a, b) - (a == b ? product(0, 0) : 0.0)) > 1e-9) return false;
  return true;
}

}  // namespace dripfeed::interpreter
