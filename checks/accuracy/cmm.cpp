// The fit is Gauss-Newton on the signed normal distances: r = n·(p - foot), its derivatives n for the shift and
// n·(turned arm) for the angle; the feet are sought again each time. A little damping keeps it where the nominal says
// nothing (along a line).
#include "checks/accuracy/cmm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "dialects/text/number.h"

namespace dripfeed::accuracy {

namespace {

constexpr int kFitSteps = 50;
constexpr double kSettled_mm = 1e-9;

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '"')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '"' || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

std::vector<std::string_view> fields_of(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t end = line.find(separator);
    fields.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) return fields;
    line.remove_prefix(end + 1);
  }
}

std::string column_name(std::string_view field) {
  std::string name;
  for (const char c : field) name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (name.ends_with("_mm")) name.resize(name.size() - 3);
  return name;
}

// What the columns of a header are for.
struct Columns {
  char separator = ',';
  std::optional<std::size_t> first;  // x or z; nominal
  std::optional<std::size_t> second;
  std::optional<std::size_t> deviation;
  bool has_points = false;
};

std::expected<Columns, std::string> read_header(std::string_view line, std::uint32_t row, CmmKind kind) {
  Columns out;
  if (line.find(',') == std::string_view::npos) out.separator = line.find(';') != std::string_view::npos ? ';' : '\t';
  const std::vector<std::string_view> fields = fields_of(line, out.separator);
  const auto find = [&](std::string_view wanted) -> std::optional<std::size_t> {
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (column_name(fields[i]) == wanted) return i;
    }
    return std::nullopt;
  };
  out.deviation = find("deviation");
  if (out.deviation) return out;
  out.first = find("nominal");
  out.second = find("measured");
  if (out.first && out.second) return out;
  out.has_points = true;
  out.first = find(kind == CmmKind::milling ? "x" : "z");
  out.second = find(kind == CmmKind::milling ? "y" : "x");
  if (out.first && out.second) return out;
  return std::unexpected(fmt::format("row {}: the header names no columns {}, nominal and measured, or deviation", row,
                                     kind == CmmKind::milling ? "x and y" : "x and z"));
}

CmmFigures figures_of(const std::vector<double>& values, const CmmTable& table) {
  CmmFigures figures;
  figures.points = values.size();
  double sum = 0.0;
  double square = 0.0;
  std::size_t largest = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += values[i];
    square += values[i] * values[i];
    if (std::fabs(values[i]) > std::fabs(values[largest])) largest = i;
  }
  const auto [low, high] = std::ranges::minmax(values);
  const auto count = static_cast<double>(values.size());
  figures.min_mm = low;
  figures.max_mm = high;
  figures.mean_mm = sum / count;
  figures.rmse_mm = std::sqrt(square / count);
  figures.max_row = table.rows[largest].row;
  return figures;
}

curves::Point left_of(curves::Point direction) {
  const curves::Point along = curves::unit(direction);
  return {-along.x, along.z};
}

using Matrix = std::array<std::array<double, 4>, 3>;

// Gauss with the largest pivot; the last column is the right side.
std::array<double, 3> solve(Matrix m) {
  for (std::size_t i = 0; i < 3; ++i) {
    std::size_t pivot = i;
    for (std::size_t row = i + 1; row < 3; ++row) {
      if (std::fabs(m[row][i]) > std::fabs(m[pivot][i])) pivot = row;
    }
    std::swap(m[i], m[pivot]);
    if (m[i][i] == 0.0) continue;
    for (std::size_t row = 0; row < 3; ++row) {
      if (row == i) continue;
      const double factor = m[row][i] / m[i][i];
      for (std::size_t k = i; k < 4; ++k) m[row][k] -= factor * m[i][k];
    }
  }
  std::array<double, 3> out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = m[i][i] != 0.0 ? m[i][3] / m[i][i] : 0.0;
  return out;
}

class Fitting {
 public:
  Fitting(const CmmTable& table, const Nearest& nearest) : table_(table), nearest_(nearest) {
    for (const CmmTable::Row& row : table.rows) centroid_ = centroid_ + row.point;
    centroid_ = 1.0 / static_cast<double>(table.rows.size()) * centroid_;
  }

  Fit run() {
    double squares = sum_of_squares();
    for (int step = 0; step < kFitSteps; ++step) {
      const curves::Point shift_before = shift_;
      const double angle_before = angle_;
      const std::array<double, 3> by = gauss_newton();
      shift_ = shift_ + curves::Point{by[0], by[1]};
      angle_ += by[2] / reach_;
      const double now = sum_of_squares();
      if (!(now <= squares)) {  // it went too far: what was found before stays
        shift_ = shift_before;
        angle_ = angle_before;
        break;
      }
      squares = now;
      if (std::hypot(by[0], by[1]) + std::fabs(by[2]) < kSettled_mm) break;
    }
    return {shift_, angle_ * 180.0 / std::numbers::pi};
  }
  [[nodiscard]] curves::Point moved(curves::Point point) const {
    const curves::Point arm = point - centroid_;
    const double c = std::cos(angle_);
    const double s = std::sin(angle_);
    return centroid_ + shift_ + curves::Point{c * arm.z - s * arm.x, s * arm.z + c * arm.x};
  }

 private:
  [[nodiscard]] double sum_of_squares() const {
    double sum = 0.0;
    for (const CmmTable::Row& row : table_.rows) {
      const double away = nearest_(moved(row.point)).distance;
      sum += away * away;
    }
    return sum;
  }
  // The angle is scaled by the points' reach, so that all three unknowns are lengths.
  std::array<double, 3> gauss_newton() {
    reach_ = 1e-9;
    for (const CmmTable::Row& row : table_.rows) reach_ = std::max(reach_, curves::distance(row.point, centroid_));
    Matrix m{};
    for (const CmmTable::Row& row : table_.rows) {
      const curves::Point at = moved(row.point);
      const NearestPlace place = nearest_(at);
      const curves::Point arm = at - centroid_ - shift_;
      const std::array<double, 3> slope = {place.normal.z, place.normal.x,
                                           curves::dot(place.normal, {-arm.x, arm.z}) / reach_};
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) m[i][k] += slope[i] * slope[k];
        m[i][3] -= slope[i] * place.distance;
      }
    }
    for (std::size_t i = 0; i < 3; ++i) m[i][i] += 1e-9 * static_cast<double>(table_.rows.size());
    return solve(m);
  }

  const CmmTable& table_;
  const Nearest& nearest_;
  curves::Point centroid_;
  curves::Point shift_;
  double angle_ = 0.0;
  double reach_ = 1.0;
};

}  // namespace

std::expected<CmmTable, std::string> read_cmm(std::string_view csv, CmmKind kind, bool x_is_diameter) {
  CmmTable table;
  std::optional<Columns> columns;
  for (std::uint32_t row = 1; !csv.empty(); ++row) {
    const std::string_view line = csv.substr(0, csv.find('\n'));
    csv.remove_prefix(std::min(csv.size(), line.size() + 1));
    if (trimmed(line).empty()) continue;
    if (!columns) {
      auto header = read_header(line, row, kind);
      if (!header) return std::unexpected(header.error());
      columns = *header;
      table.has_points = columns->has_points;
      continue;
    }
    const std::vector<std::string_view> fields = fields_of(line, columns->separator);
    std::string fault;
    const auto number = [&](std::size_t column) {
      if (column >= fields.size()) {
        fault = fmt::format("row {}, column {}: nothing is there", row, column + 1);
        return 0.0;
      }
      const std::optional<double> value = text::parse_number(fields[column]);
      if (!value) fault = fmt::format("row {}, column {}: '{}' is not a number", row, column + 1, fields[column]);
      return value.value_or(0.0);
    };
    CmmTable::Row out{row, {}, 0.0};
    if (columns->deviation) {
      out.deviation = number(*columns->deviation);
    } else {
      const double first = number(*columns->first);
      const double second = fault.empty() ? number(*columns->second) : 0.0;
      out.deviation = second - first;
      out.point = {first, kind == CmmKind::turning && x_is_diameter ? 0.5 * second : second};
    }
    if (!fault.empty()) return std::unexpected(fault);
    table.rows.push_back(out);
  }
  if (table.rows.empty()) return std::unexpected(std::string("there are no rows of points"));
  return table;
}

Nearest nearest_on(const curves::Profile& profile) {
  return [profile](curves::Point point) {
    const curves::Foot foot = curves::closest(profile, point).foot;
    return NearestPlace{foot.point(), left_of({1.0, foot.curve.slope}), foot.distance};
  };
}

Nearest nearest_on(const std::vector<curves::ParametricCurve>& curves) {
  constexpr int kSearchPieces = 512;
  return [curves](curves::Point point) {
    NearestPlace best;
    bool found = false;
    for (const curves::ParametricCurve& curve : curves) {
      const curves::ParametricFoot foot = curves::closest(curve, point, kSearchPieces);
      if (found && std::fabs(foot.distance) >= std::fabs(best.distance)) continue;
      best = {foot.point, left_of(curve.at(foot.t).derivative), foot.distance};
      found = true;
    }
    return best;
  };
}

CmmReport measure_cmm(const CmmTable& table, const Nearest& nearest, bool best_fit) {
  CmmReport report;
  std::vector<double> values;
  for (const CmmTable::Row& row : table.rows) {
    values.push_back(table.has_points ? nearest(row.point).distance : row.deviation);
  }
  report.measured = figures_of(values, table);
  if (!best_fit || !table.has_points) return report;
  Fitting fitting(table, nearest);
  report.fit = fitting.run();
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = nearest(fitting.moved(table.rows[i].point)).distance;
  }
  report.fitted = figures_of(values, table);
  return report;
}

}  // namespace dripfeed::accuracy
