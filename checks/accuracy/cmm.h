// Points that a coordinate measuring machine took, against the nominal: minimum, maximum, mean and root mean square of
// the deviations, and the same after a best fit in the plane.
#pragma once

#include <cstdint>
#include <expected>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/curves/parametric_curve.h"
#include "dialects/curves/point.h"
#include "dialects/curves/profile.h"

namespace dripfeed::accuracy {

enum class CmmKind : std::uint8_t { turning, milling };

struct CmmTable {
  struct Row {
    std::uint32_t row = 0;   // of the text, 1-based
    curves::Point point;     // turning: z and radius; milling: x and y
    double deviation = 0.0;  // where the table has deviations instead of points
  };
  bool has_points = false;
  std::vector<Row> rows;
};

// CSV with a header: columns x and y (milling) or x and z (turning; x a diameter where `x_is_diameter`), or nominal and
// measured, or deviation; separated by commas, semicolons or tabs; others are passed over. `_mm` after a name is
// allowed, empty lines are skipped. The error names row and column.
std::expected<CmmTable, std::string> read_cmm(std::string_view csv, CmmKind kind, bool x_is_diameter);

// The place of the nominal that is nearest to a point, and the unit normal there on whose side deviations are positive.
struct NearestPlace {
  curves::Point foot;
  curves::Point normal;
  double distance = 0.0;
};
using Nearest = std::function<NearestPlace(curves::Point)>;
Nearest nearest_on(const curves::Profile& profile);
Nearest nearest_on(const std::vector<curves::ParametricCurve>& curves);

struct CmmFigures {
  std::uint64_t points = 0;
  double min_mm = 0.0;  // signed
  double max_mm = 0.0;
  double mean_mm = 0.0;
  double rmse_mm = 0.0;
  std::uint32_t max_row = 0;  // of the largest in size
};

// How the points are moved onto the nominal: turned about their centroid, then shifted.
struct Fit {
  curves::Point shift;
  double angle_deg = 0.0;
};

struct CmmReport {
  CmmFigures measured;
  std::optional<CmmFigures> fitted;
  Fit fit;
};

// `nearest` is needed for tables of points only; a best fit, too. The table must have rows.
CmmReport measure_cmm(const CmmTable& table, const Nearest& nearest, bool best_fit);

}  // namespace dripfeed::accuracy
