// Stock, nominal and tools of a bound family as plain data, in mm: what the checks of accuracy and gouge measure
// against.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "dialects/curves/profile.h"
#include "dialects/family/bind.h"

namespace dripfeed::family {

// Around the z axis of the active work offset.
struct CylinderStock {
  double diameter_mm = 0.0;
  double bore_mm = 0.0;  // diameter; 0: solid
  curves::Range z_mm;
};
struct BoxStock {
  curves::Range x_mm, y_mm, z_mm;
};
using Stock = std::variant<CylinderStock, BoxStock>;

// A tool as the body names it, for the checks that need its nose.
struct ToolShape {
  std::int32_t number = 0;
  double nose_radius_mm = 0.0;  // 0: not given
  std::int32_t tip = 0;         // imaginary tip 0 to 9
};

struct Geometry {
  std::optional<Stock> stock;
  // x = f(z), x as radius, pieces in the order of z; empty when the family has none. Slopes are exact and second
  // derivatives are enclosed. The functions are pure and may be called from several threads.
  curves::Profile nominal;
  std::vector<ToolShape> tools;  // in the order of the body, each number once
};

Geometry geometry(const BoundFamily& bound);

}  // namespace dripfeed::family
