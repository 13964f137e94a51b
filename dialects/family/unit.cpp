// The table of units, and how messages state dimensions.
#include "dialects/family/unit.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "dialects/text/number.h"

namespace dripfeed::family {

namespace {

constexpr double kDegree = 180.0 / std::numbers::pi;

constexpr auto kUnits = std::to_array<Unit>({
    {"mm", kLength, 1.0},
    {"in", kLength, 25.4},
    {"deg", kAngle, 1.0},
    {"rad", kAngle, kDegree},
    {"s", kTime, 1.0},
    {"ms", kTime, 0.001},
    {"min", kTime, 60.0},
    {"rpm", kSpeed, 1.0},
    {"mm/min", kFeedPerMin, 1.0},
    {"in/min", kFeedPerMin, 25.4},
    {"mm/rev", kFeedPerRev, 1.0},
    {"in/rev", kFeedPerRev, 25.4},
    {"m/min", kSurfaceSpeed, 1.0},
    {"ft/min", kSurfaceSpeed, 0.3048},
});

struct DimensionRow {
  Dimension dimension;
  std::string_view shown;
  std::string_view unit;
};
constexpr auto kDimensions = std::to_array<DimensionRow>({
    {kRatio, "a plain number", ""},
    {kLength, "a length", "mm"},
    {kAngle, "an angle", "deg"},
    {kTime, "a time", "s"},
    {kSpeed, "a spindle speed", "rpm"},
    {kFeedPerMin, "a feed per minute", "mm/min"},
    {kFeedPerRev, "a feed per revolution", "mm/rev"},
    {kSurfaceSpeed, "a surface speed", "m/min"},
});

const DimensionRow* row_of(Dimension dimension) {
  const auto row = std::ranges::find(kDimensions, dimension, &DimensionRow::dimension);
  return row == kDimensions.end() ? nullptr : &*row;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace

std::span<const Unit> units() { return kUnits; }

const Unit* find_unit(std::string_view name) {
  const auto unit = std::ranges::find(kUnits, name, &Unit::name);
  return unit == kUnits.end() ? nullptr : &*unit;
}

std::string describe(Dimension dimension) {
  if (const DimensionRow* row = row_of(dimension)) return std::string(row->shown);
  const std::array<std::pair<std::string_view, std::int8_t>, 5> parts = {{{"mm", dimension.length},
                                                                          {"deg", dimension.angle},
                                                                          {"min", dimension.time},
                                                                          {"rev", dimension.revolution},
                                                                          {"m/min", dimension.surface}}};
  std::string out;
  for (const auto& [unit, doubled] : parts) {
    if (doubled == 0) continue;
    if (!out.empty()) out += '*';
    out += unit;
    if (doubled % 2 != 0) {
      out += fmt::format("^({}/2)", int{doubled});
    } else if (doubled != 2) {
      out += fmt::format("^{}", doubled / 2);
    }
  }
  return out;
}

std::string_view stored_unit(Dimension dimension) {
  const DimensionRow* row = row_of(dimension);
  return row == nullptr ? std::string_view() : row->unit;
}

std::optional<Quantity> parse_quantity(std::string_view text) {
  text = trimmed(text);
  const std::size_t number_end = std::min(text.find_first_not_of("+-.0123456789"), text.size());
  const std::string_view digits = text.substr(0, number_end);
  const std::optional<double> value = text::parse_number(digits);
  if (!value) return std::nullopt;
  const std::string_view unit_name = trimmed(text.substr(number_end));
  if (unit_name.empty()) return Quantity{*value, nullptr};
  const Unit* unit = find_unit(unit_name);
  if (unit == nullptr) return std::nullopt;
  return Quantity{*value, unit};
}

}  // namespace dripfeed::family
