// Points know their motion and their part of it, so that no motion is kept.
#include "server/app/checks/path_times.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace dripfeed::app {

namespace {

constexpr float kNotKnown = std::numeric_limits<float>::quiet_NaN();

// More than a path has points: others are events between moves.
constexpr std::size_t kMostMotions = 4 * ToolPath::kMostPoints;

PathTimes times_of(const std::vector<PointOrigin>& origins, const timing::Report& report) {
  constexpr double kPerMinute = 60.0;
  PathTimes out;
  out.cycle_s = report.cycle_s;
  out.notes = report.not_checked.list();
  out.times_s.reserve(origins.size());
  out.speeds_mm_min.reserve(origins.size());
  if (report.is_fed) out.buffer.reserve(origins.size());
  for (const PointOrigin& one : origins) {
    const bool known = one.motion < report.motion_times.size();
    const timing::MotionTime motion = known ? report.motion_times[one.motion] : timing::MotionTime{};
    const double whole_s = motion.end_s - motion.start_s;
    const double lasts_s = whole_s * static_cast<double>(one.to - one.from);
    const double time_s = motion.start_s + whole_s * static_cast<double>(one.to);
    out.times_s.push_back(known ? static_cast<float>(time_s) : kNotKnown);
    const bool has_speed = lasts_s > 0.0 && one.length_mm > 0.0F;
    out.speeds_mm_min.push_back(
        has_speed ? static_cast<float>(static_cast<double>(one.length_mm) / lasts_s * kPerMinute) : kNotKnown);
    if (report.is_fed)
      out.buffer.push_back(static_cast<std::uint32_t>(std::min<std::uint64_t>(motion.buffered_bytes, UINT32_MAX)));
  }
  return out;
}

// The larger one of each block, in the order of the run.
std::vector<accuracy::BlockDeviation> largest_of_each(std::vector<accuracy::BlockDeviation> all) {
  std::ranges::stable_sort(all, {}, &accuracy::BlockDeviation::ordinal);
  std::vector<accuracy::BlockDeviation> out;
  for (const accuracy::BlockDeviation& one : all) {
    if (out.empty() || out.back().ordinal != one.ordinal)
      out.push_back(one);
    else if (std::fabs(one.value_mm) > std::fabs(out.back().value_mm))
      out.back().value_mm = one.value_mm;
  }
  return out;
}

PathDeviations deviations_of(const ToolPath& path, accuracy::Report& report) {
  PathDeviations out{.values_mm = {}, .of_surface = report.surface.has_value(), .notes = report.not_checked.list()};
  const auto blocks = largest_of_each(std::move(report.of_blocks));
  out.values_mm.reserve(path.origins.size());
  auto next = blocks.begin();
  for (std::size_t i = 0; i < path.origins.size(); ++i) {
    while (next != blocks.end() && next->ordinal < path.origins[i].ordinal) ++next;
    const bool is_cut = path.kinds[i] != PathKind::begin && path.kinds[i] != PathKind::rapid;
    const bool is_measured = is_cut && next != blocks.end() && next->ordinal == path.origins[i].ordinal;
    out.values_mm.push_back(is_measured ? static_cast<float>(next->value_mm) : kNotKnown);
  }
  return out;
}

}  // namespace

PathTimer::PathTimer(const Examination& e) : surfaces_(e, SurfaceScope::of_each_block, skipped_) {
  if (e.profile == nullptr) {
    why_no_times_ = "no machine is named: its axes decide";
    return;
  }
  auto settings = timing_settings(e, e.source.text());
  if (!settings) {
    why_no_times_ = settings.error();
    return;
  }
  settings->most_motion_times = kMostMotions;
  timing_ = std::make_unique<timing::Timing>(std::move(*settings));
}

std::vector<ir::MotionSink*> PathTimer::sinks() const {
  std::vector<ir::MotionSink*> all = surfaces_.sinks();
  if (timing_) all.push_back(timing_.get());
  return all;
}

void PathTimer::finish(const Examination& e, ToolPath& path) {
  path.why_no_times = std::move(why_no_times_);
  if (timing_) path.times = times_of(path.origins, timing_->finish());
  checks::CheckReport checks;
  Pictures pictures;
  surfaces_.finish(checks, pictures);
  if (checks.accuracy) path.deviations = deviations_of(path, *checks.accuracy);
  path.origins = {};
  const std::vector<checks::Tool> tools = tools_of(e);
  for (ToolMoves& one : path.tools) {
    const auto known = std::ranges::find(tools, one.number, &checks::Tool::number);
    if (one.number != 0 && known != tools.end()) one.shape = *known;
  }
}

}  // namespace dripfeed::app
