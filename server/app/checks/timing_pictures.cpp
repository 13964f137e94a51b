// Under the curves the stretches that something else than motion limited.
#include "server/app/checks/timing_pictures.h"

#include <utility>

#include <fmt/format.h>

namespace dripfeed::app {

namespace {

// What limited the stretches, where it was not motion.
std::vector<plot::Area> stretch_areas(const timing::Report& report) {
  std::vector<plot::Area> areas;
  for (const timing::Stretch& one : report.stretches) {
    if (one.limiter == timing::Limiter::motion) continue;
    areas.push_back({.name = fmt::format("limited by {}", timing::name_of(one.limiter)),
                     .x_low = one.start_s,
                     .x_high = one.start_s + one.duration_s,
                     .y_low = {},
                     .y_high = {}});
  }
  return areas;
}

plot::Plot time_plot(const timing::Report& report, const std::string& title, std::string y) {
  return {.title = title,
          .x = {.title = "time, s"},
          .y = {.title = std::move(y), .low = 0.0},
          .areas = stretch_areas(report)};
}

}  // namespace

plot::Plot feed_plot(const timing::Report& report, const std::string& title) {
  plot::Plot plot = time_plot(report, title, "speed along the path, mm/min");
  plot::Series series;
  for (const timing::CurvePoint& one : report.curve) series.points.push_back({one.time_s, one.speed_mm_s * 60.0});
  plot.series.push_back(std::move(series));
  return plot;
}

plot::Plot buffer_plot(const timing::Report& report, const std::string& title) {
  const bool in_bytes = report.is_fed;
  plot::Plot plot =
      time_plot(report, title, in_bytes ? "bytes in the control's buffer" : "blocks in the control's buffer");
  plot::Series series;
  series.mark = plot::Mark::steps;
  for (const timing::CurvePoint& one : report.curve) {
    const std::uint64_t level = in_bytes ? one.buffered_bytes : one.buffered_blocks;
    series.points.push_back({one.time_s, static_cast<double>(level)});
  }
  plot.series.push_back(std::move(series));
  return plot;
}

}  // namespace dripfeed::app
