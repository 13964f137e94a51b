// Height fields over the places of one x: what depends on x alone is computed once. The fields must outlive it.
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "dialects/curves/height_field.h"

namespace dripfeed::curves {

class SurfaceColumn {
 public:
  SurfaceColumn(std::span<const HeightField> fields, double x);
  // As surface_at.
  [[nodiscard]] std::optional<SurfacePlace> at(double y) const;

 private:
  double x_;
  std::vector<std::pair<const HeightField*, Range>> fields_;  // that have this x, the last first
};

}  // namespace dripfeed::curves
