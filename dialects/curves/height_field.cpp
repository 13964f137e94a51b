// Few fields: asked one after the other, from the last.
#include "dialects/curves/height_field.h"

#include <cmath>
#include <ranges>

namespace dripfeed::curves {

std::optional<SurfacePlace> surface_at(std::span<const HeightField> fields, double x, double y) {
  for (const HeightField& field : std::views::reverse(fields)) {
    if (!field.x.contains(x) || !field.y(x).contains(y)) continue;
    const double z = field.z(x, y);
    if (std::isfinite(z)) return SurfacePlace{z, field.tolerance};
  }
  return std::nullopt;
}

}  // namespace dripfeed::curves
