// What the contour of a `rough` must be, so that its passes meet it once and cut nothing away that stays.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "dialects/family/bind.h"

namespace dripfeed::family {

struct ContourFault {
  text::Span span;
  std::string text;
};

// With these values; `known` has one entry a symbol. Nothing where it can be roughed.
std::optional<ContourFault> fault_of_contour(const BoundFamily& bound, std::span<const std::uint8_t> known,
                                             const RoughContour& contour);

}  // namespace dripfeed::family
