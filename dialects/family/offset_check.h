// What the corners of an `offset` are, and whether every place of it has its distance from the contour.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "dialects/family/contour_check.h"

namespace dripfeed::family {

struct OffsetCorners {
  std::vector<std::pair<ir::SymbolId, double>> values;  // of its symbols: a Corner, or a direction
  std::optional<ContourFault> fault;                    // with one there are no values
};

// With these values; `known` has one entry a symbol.
OffsetCorners corners_of(const BoundFamily& bound, std::span<const std::uint8_t> known, const OffsetContour& contour);

}  // namespace dripfeed::family
