// An axis that a program never names is 0 throughout. Of one that it names, moves before its first known place are not
// drawn: so rows wait until the run has ended.
#include "server/app/checks/tool_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "checks/arcs.h"
#include "checks/machine.h"
#include "dialects/compile/dialect/execute.h"
#include "server/app/checks/machine_facts.h"
#include "server/app/checks/path_times.h"
#include "server/app/checks/workers.h"

namespace dripfeed::app {

namespace {

constexpr std::uint8_t kPlaces = 7U;  // x, y, z

PathKind kind_of(const ir::Motion& motion) {
  if (motion.kind == ir::MotionKind::rapid) return PathKind::rapid;
  if (motion.kind == ir::MotionKind::thread) return PathKind::thread;
  switch (motion.feed_mode) {
    case ir::FeedMode::per_min: return PathKind::cut_per_min;
    case ir::FeedMode::per_rev: return PathKind::cut_per_rev;
    case ir::FeedMode::inverse_time: return PathKind::cut_inverse_time;
  }
  return PathKind::cut_per_min;
}

std::array<double, 3> place_of(const checks::AxisValues& at) { return {at[0], at[1], at[2]}; }

// Of axes whose start is not known: those that the move itself puts at a known place are known at its end.
std::uint8_t unknown_at_end(const ir::Motion& motion) {
  const bool guessed = (motion.gaps & ir::kEndUnknown) != 0;
  const auto known = static_cast<std::uint16_t>(guessed ? 0U : motion.axes_commanded);
  return static_cast<std::uint8_t>(motion.axes_unknown & ~known & kPlaces);
}

// Bits of the axes in which an arc lies.
std::uint8_t plane_of(const ir::Motion& motion) {
  const checks::PlaneAxes plane = checks::axes_of(motion.plane);
  return static_cast<std::uint8_t>(1U << plane.abscissa | 1U << plane.ordinate);
}

std::uint16_t other_axes_of(const ir::Motion& motion) {
  std::uint16_t bits = 0;
  for (std::size_t i = 3; i < ir::kAxisCount; ++i)
    if (checks::moves_any(motion, {static_cast<ir::Axis>(i)})) bits |= static_cast<std::uint16_t>(1U << i);
  return bits;
}

}  // namespace

PathRecorder::PathRecorder(bool x_is_diameter, std::size_t most_points) : most_points_(most_points) {
  path_.x_is_diameter = x_is_diameter;
}

void PathRecorder::consume(std::span<const ir::Motion> motions) {
  for (const ir::Motion& motion : motions) {
    if (is_full()) return;
    if (motion.kind == ir::MotionKind::offset) work_offset_ = motion.number;
    if (motion.kind == ir::MotionKind::tool) tools_.take(motion);
    if (ir::is_move(motion.kind)) {
      const double first =
          here_ && !rows_.empty() ? static_cast<double>(rows_.size() - 1) : static_cast<double>(rows_.size());
      add(motion);
      const double last = rows_.empty() ? 0.0 : static_cast<double>(rows_.size() - 1);
      newest_ = (newest_ + 1) % kRecent;
      recent_[newest_] = {motion.place.ordinal, {std::min(first, last), last}};
    }
    if (checks::has_places(motion)) ++motions_;
  }
}

PathRecorder::RowRange PathRecorder::rows_of(std::uint64_t ordinal) const {
  for (std::size_t i = 0; i < kRecent; ++i) {
    const LastRows& one = recent_[(newest_ + kRecent - i) % kRecent];
    if (one.ordinal == ordinal) return one.rows;
  }
  return {recent_[newest_].rows.last, recent_[newest_].rows.last};
}

double PathRecorder::point_of(double row) const {
  if (points_of_rows_.empty()) return 0.0;
  const double most = static_cast<double>(points_of_rows_.size() - 1);
  const double before = std::floor(std::clamp(row, 0.0, most));
  const auto at = [&](double one) { return static_cast<double>(points_of_rows_[static_cast<std::size_t>(one)]); };
  return at(before) + (std::clamp(row, 0.0, most) - before) * (at(std::min(before + 1.0, most)) - at(before));
}

void PathRecorder::leave_out(NotDrawn why, const ir::Motion& motion) {
  NotDrawnMoves& moves = path_.not_drawn[static_cast<std::size_t>(why)];
  if (moves.count++ == 0 && motion.place.program == 0) moves.first_line = motion.place.line;
  if (motion.kind != ir::MotionKind::rapid) ++moves.cuts;
  here_.reset();
}

void PathRecorder::push(const Row& row) {
  if (rows_.size() >= most_points_) {
    path_.is_cut_off = true;
    return;
  }
  rows_.push_back(row);
  here_ = row.spot;
}

void PathRecorder::add(const ir::Motion& given) {
  if (given.machine_coordinates) return leave_out(NotDrawn::machine_coordinates, given);
  if (!checks::has_places(given)) return leave_out(NotDrawn::no_place, given);
  ir::Motion motion = given;
  if (path_.x_is_diameter) {
    motion.start[0] *= 0.5;
    motion.end[0] *= 0.5;
  }
  commanded_ |= static_cast<std::uint8_t>(motion.axes_commanded & kPlaces);
  path_.other_axes |= other_axes_of(motion);
  path_.work_offsets.insert(work_offset_);
  path_.compensated |= motion.comp != ir::CompSide::off;
  Row row{.spot = {place_of(motion.start), static_cast<std::uint8_t>(motion.axes_unknown & kPlaces)},
          .kind = PathKind::begin,
          .line = motion.place.line,
          .program = motion.place.program,
          .ordinal = motion.place.ordinal,
          .motion = motions_,
          .from = 0.0F,
          .to = 0.0F,
          .feed = 0.0F,
          .tool = tools_.current()};
  if (here_ != row.spot) push(row);
  const bool knows_arc = checks::is_arc(motion) && (row.spot.unknown & plane_of(motion)) == 0;
  row.kind = kind_of(motion);
  row.feed = static_cast<float>(row.kind == PathKind::rapid ? 0.0 : motion.feed);
  row.spot.unknown = unknown_at_end(motion);
  if (knows_arc) return add_chords(motion, row);
  row.to = 1.0F;
  row.spot.at = place_of(motion.end);
  if (here_ != row.spot) push(row);
}

void PathRecorder::add_chords(const ir::Motion& motion, Row row) {
  row.ends_move = false;
  const std::size_t first = rows_.size();
  checks::for_chords(motion, ToolPath::kArcError_mm, [&](const checks::AxisValues&, const checks::AxisValues& to) {
    row.spot.at = place_of(to);
    push(row);
  });
  if (is_full()) return;
  rows_.back().ends_move = true;
  const auto chords = static_cast<float>(rows_.size() - first);
  for (std::size_t i = first; i < rows_.size(); ++i) {
    rows_[i].from = static_cast<float>(i - first) / chords;
    rows_[i].to = static_cast<float>(i - first + 1) / chords;
  }
}

void PathRecorder::keep(const Row& row, std::uint32_t line, double length_mm) {
  for (std::size_t i = 0; i < 3; ++i) {
    const double value = row.spot.at[i];
    path_.low_mm[i] = path_.kinds.empty() ? value : std::min(path_.low_mm[i], value);
    path_.high_mm[i] = path_.kinds.empty() ? value : std::max(path_.high_mm[i], value);
  }
  for (const double value : row.spot.at) path_.points_mm.push_back(static_cast<float>(value));
  const std::uint32_t tool_before = path_.tool_changes.empty() ? UINT32_MAX : path_.tool_changes.back().tool;
  if (row.tool != tool_before) path_.tool_changes.push_back({static_cast<std::uint32_t>(path_.kinds.size()), row.tool});
  path_.kinds.push_back(row.kind);
  path_.lines.push_back(line);
  path_.feeds.push_back(row.feed);
  path_.origins.push_back({.ordinal = row.ordinal,
                           .motion = row.motion,
                           .from = row.from,
                           .to = row.to,
                           .length_mm = static_cast<float>(length_mm)});
}

void PathRecorder::keep_tools(const Followed::Run& run) {
  for (std::uint32_t i = 0; i < tools_.all().size(); ++i) {
    const ToolList::Tool& one = tools_.all()[i];
    path_.tools.push_back({.name = tools_.name_of(i, run.strings),
                           .number = one.number,
                           .first_line = run.is_of_other(one.place.program) ? 0 : one.place.line});
  }
}

ToolPath PathRecorder::finish(const Followed::Run& run) {
  keep_tools(run);
  points_of_rows_.reserve(rows_.size());
  const Spot* before = nullptr;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    Row row = rows_[i];
    points_of_rows_.push_back(path_.kinds.empty() ? 0 : static_cast<std::uint32_t>(path_.kinds.size() - 1));
    const std::uint32_t line = run.is_of_other(row.program) ? 0 : row.line;
    const bool unknown = (row.spot.unknown & commanded_) != 0;
    const bool is_move = row.kind != PathKind::begin;
    if (is_move && row.ends_move && (unknown || before == nullptr)) {
      NotDrawnMoves& moves = path_.not_drawn[static_cast<std::size_t>(NotDrawn::unknown_place)];
      if (moves.count++ == 0) moves.first_line = line;
      if (row.kind != PathKind::rapid) ++moves.cuts;
    }
    const Spot* const from = before;
    before = unknown ? nullptr : &rows_[i].spot;
    if (unknown) continue;
    if (from == nullptr || !is_move) {
      // A place that nothing leads away from is not a part of a path.
      const bool leads_on = i + 1 < rows_.size() && rows_[i + 1].kind != PathKind::begin;
      row.kind = PathKind::begin;
      row.feed = 0.0F;
      if (leads_on) {
        keep(row, line, 0.0);
        points_of_rows_.back() = static_cast<std::uint32_t>(path_.kinds.size() - 1);
      }
      continue;
    }
    const double length =
        std::hypot(row.spot.at[0] - from->at[0], row.spot.at[1] - from->at[1], row.spot.at[2] - from->at[2]);
    (row.kind == PathKind::rapid ? path_.rapid_mm : path_.cut_mm) += length;
    ToolMoves& by_tool = path_.tools[row.tool];
    (row.kind == PathKind::rapid ? by_tool.rapid_mm : by_tool.cut_mm) += length;
    ++path_.segments;
    keep(row, line, length);
    points_of_rows_.back() = static_cast<std::uint32_t>(path_.kinds.size() - 1);
  }
  rows_ = {};
  return std::move(path_);
}

Followed follow_within(Examination& e, const CheckBudget& budget, const PathRecorder& recorder, ir::MotionSink& sink) {
  e.used_up = [&recorder, in_time = time_budget(budget.seconds)] {
    if (recorder.is_full()) return fmt::format("{} points of a path", ToolPath::kMostPoints);
    return in_time ? in_time() : std::string();
  };
  return follow(e, sink);
}

ToolPath record_path(Examination& e, const CheckBudget& budget, std::vector<ir::MotionSink*> more_sinks) {
  PathRecorder recorder(x_is_diameter(e.control, e.profile));
  more_sinks.insert(more_sinks.begin(), &recorder);
  compile::FanOut sinks(std::move(more_sinks));
  Followed followed = follow_within(e, budget, recorder, sinks);
  ToolPath path = recorder.finish(followed.run);
  path.report = std::move(followed.report);
  return path;
}

Result<ToolPath> follow_path(const DiagnoseOrder& order, const Documents& documents, const CheckBudget& budget) {
  const auto opened = open_text(order, documents);
  if (!opened) return std::unexpected(opened.error());
  Examination& e = (*opened)->examination;
  const std::vector<std::string> stated = std::exchange(e.assumed, {});
  PathTimer timer(e);
  ToolPath path = record_path(e, budget, timer.sinks());
  timer.finish(e, path);
  // It is nothing that the moves depend on.
  for (const std::string& one : stated)
    if (path.deviations) path.deviations->notes.push_back({one, 0});
  return path;
}

}  // namespace dripfeed::app
