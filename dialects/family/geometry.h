// Stock and nominal of a bound family as plain data, in mm: what the checks of accuracy and gouge measure against.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <variant>
#include <vector>

#include "dialects/family/bind.h"

namespace dripfeed::family {

struct Interval {
  double low = 0.0;
  double high = 0.0;
};

// Around the z axis of the active work offset.
struct CylinderStock {
  double diameter_mm = 0.0;
  double bore_mm = 0.0;  // diameter; 0: solid
  Interval z_mm;
};
struct BoxStock {
  Interval x_mm, y_mm, z_mm;
};
using Stock = std::variant<CylinderStock, BoxStock>;

struct ProfilePoint {
  double x_mm = 0.0;   // as the machine's x is: a diameter where Geometry::x_is_diameter
  double slope = 0.0;  // dx/dz, exact (by differentiation of the expression)
};

// One piece of the nominal, x = f(z). The function is pure and may be called from several threads.
struct NominalPiece {
  Interval z_mm;
  double tolerance_mm = 0.0;
  std::function<ProfilePoint(double z_mm)> at;
};

// A tool as the body names it, for the checks that need its nose.
struct ToolShape {
  std::int32_t number = 0;
  double nose_radius_mm = 0.0;  // 0: not given
  std::int32_t tip = 0;         // imaginary tip 0 to 9
};

struct Geometry {
  bool x_is_diameter = false;
  std::optional<Stock> stock;
  std::vector<NominalPiece> nominal;  // in the order of the text
  std::vector<ToolShape> tools;       // in the order of the body, each number once
};

Geometry geometry(const BoundFamily& bound);

}  // namespace dripfeed::family
