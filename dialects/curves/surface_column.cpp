// The order of surface_at: from the last field to the first.
#include "dialects/curves/surface_column.h"

#include <cmath>
#include <ranges>

namespace dripfeed::curves {

SurfaceColumn::SurfaceColumn(std::span<const HeightField> fields, double x) : x_(x) {
  for (const HeightField& field : std::views::reverse(fields))
    if (field.x.contains(x)) fields_.emplace_back(&field, field.y(x));
}

std::optional<SurfacePlace> SurfaceColumn::at(double y) const {
  for (const auto& [field, range] : fields_) {
    if (!range.contains(y)) continue;
    const double z = field->z(x_, y);
    if (std::isfinite(z)) return SurfacePlace{z, field->tolerance};
  }
  return std::nullopt;
}

}  // namespace dripfeed::curves
