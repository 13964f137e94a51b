// Micrometres: deviations are small.
#include "checks/accuracy/picture.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "dialects/text/number.h"

namespace dripfeed::accuracy {

namespace {

constexpr double kMicrometres = 1000.0;

}  // namespace

plot::Plot deviation_plot(const Report& report) {
  plot::Plot figure{.title = "deviation from the nominal",
                    .x = {report.in_plane ? "along the path, mm" : "z, mm"},
                    .y = {"deviation, micrometres"}};
  plot::Series series{report.surface ? "surface cut" : "path", {}};
  const TracePoint* largest = nullptr;
  for (const TracePoint& point : report.trace) {
    series.points.push_back({point.along_mm, kMicrometres * point.value_mm});
    if (largest == nullptr || std::abs(point.value_mm) > std::abs(largest->value_mm)) largest = &point;
  }
  figure.series = {std::move(series)};
  if (largest != nullptr) {
    const Figures& figures = report.figures();
    figure.notes = {{{largest->along_mm, kMicrometres * largest->value_mm},
                     fmt::format("{} mm, line {}", text::format_fixed(figures.max_signed_mm, 4), figures.max_line)}};
  }
  return figure;
}

}  // namespace dripfeed::accuracy
