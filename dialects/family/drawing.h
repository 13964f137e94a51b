// What people see next to a family's values: for each view the lines of stock, nominal and outline, and where its
// parameters are seen. Plain data in mm; x of a lathe is a radius. A picture, which nothing is checked against.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/family/bind.h"

namespace dripfeed::family {

struct DrawnPoint {
  double across_mm = 0.0;
  double up_mm = 0.0;
};

enum class DrawnOf : std::uint8_t { stock, nominal, outline };
inline constexpr std::array<std::string_view, 3> kDrawnOfNames = {"stock", "nominal", "outline"};

struct DrawnLine {
  DrawnOf of = DrawnOf::outline;
  std::vector<DrawnPoint> points;
};
struct DrawnCircle {
  DrawnOf of = DrawnOf::outline;
  DrawnPoint center;
  double diameter_mm = 0.0;
};

struct DrawnDimension {
  std::string parameter;
  DimensionKind kind = DimensionKind::length;
  std::string value;  // with its unit, as its default was written
  DrawnPoint from, to;
  DrawnPoint at = {};  // angle: its corner
};

struct DrawnView {
  std::string_view axes;  // "zx": the first one across
  std::vector<DrawnLine> lines;
  std::vector<DrawnCircle> circles;
  std::vector<DrawnDimension> dimensions;
};

// One view for each pair of axes that an outline or a dimension names, in the order of the text. What cannot be
// computed with these values is left out.
std::vector<DrawnView> drawing(const BoundFamily& bound);

}  // namespace dripfeed::family
