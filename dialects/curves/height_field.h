// A nominal surface as heights over a region of the x-y plane: z = f(x, y). Several may lie over one another.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "dialects/curves/point.h"

namespace dripfeed::curves {

struct HeightField {
  Range x;                                      // mm
  std::function<Range(double x)> y;             // the region's y at that x; low > high: none
  std::function<double(double x, double y)> z;  // not finite: no surface there
  double tolerance = 0.0;                       // mm, downwards and sideways
};

struct SurfacePlace {
  double z = 0.0;
  double tolerance = 0.0;
};

// The last of the fields that has a surface there: later ones are carved into earlier ones.
std::optional<SurfacePlace> surface_at(std::span<const HeightField> fields, double x, double y);

}  // namespace dripfeed::curves
