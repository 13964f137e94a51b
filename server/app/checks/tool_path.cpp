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
    if (ir::is_move(motion.kind)) add(motion);
  }
}

void PathRecorder::leave_out(NotDrawn why, const ir::Motion& motion) {
  NotDrawnMoves& moves = path_.not_drawn[static_cast<std::size_t>(why)];
  if (moves.count++ == 0 && motion.place.program == 0) moves.first_line = motion.place.line;
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
          .feed = 0.0F,
          .tool = tools_.current()};
  if (here_ != row.spot) push(row);
  const bool knows_arc = checks::is_arc(motion) && (row.spot.unknown & plane_of(motion)) == 0;
  row.kind = kind_of(motion);
  row.feed = static_cast<float>(row.kind == PathKind::rapid ? 0.0 : motion.feed);
  row.spot.unknown = unknown_at_end(motion);
  if (knows_arc) {
    row.ends_move = false;
    checks::for_chords(motion, ToolPath::kArcError_mm, [&](const checks::AxisValues&, const checks::AxisValues& to) {
      row.spot.at = place_of(to);
      push(row);
    });
    if (!is_full()) rows_.back().ends_move = true;
    return;
  }
  row.spot.at = place_of(motion.end);
  if (here_ != row.spot) push(row);
}

void PathRecorder::keep(const Row& row, std::uint32_t line) {
  for (std::size_t i = 0; i < 3; ++i) {
    const double value = row.spot.at[i];
    path_.low_mm[i] = path_.kinds.empty() ? value : std::min(path_.low_mm[i], value);
    path_.high_mm[i] = path_.kinds.empty() ? value : std::max(path_.high_mm[i], value);
  }
  for (const double value : row.spot.at) path_.points_mm.push_back(static_cast<float>(value));
  path_.kinds.push_back(row.kind);
  path_.lines.push_back(line);
  path_.feeds.push_back(row.feed);
}

ToolPath PathRecorder::finish(const Followed::Run& run) {
  const auto is_elsewhere = [&](std::uint32_t program) {
    return program < run.is_elsewhere.size() && run.is_elsewhere[program];
  };
  for (std::uint32_t i = 0; i < tools_.all().size(); ++i) {
    const ir::Place& place = tools_.all()[i].place;
    path_.tools.push_back(
        {.name = tools_.name_of(i, run.strings), .first_line = is_elsewhere(place.program) ? 0 : place.line});
  }
  const Spot* before = nullptr;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    Row row = rows_[i];
    const std::uint32_t line = is_elsewhere(row.program) ? 0 : row.line;
    const bool unknown = (row.spot.unknown & commanded_) != 0;
    const bool is_move = row.kind != PathKind::begin;
    if (is_move && row.ends_move && (unknown || before == nullptr)) {
      NotDrawnMoves& moves = path_.not_drawn[static_cast<std::size_t>(NotDrawn::unknown_place)];
      if (moves.count++ == 0) moves.first_line = line;
    }
    const Spot* const from = before;
    before = unknown ? nullptr : &rows_[i].spot;
    if (unknown) continue;
    if (from == nullptr || !is_move) {
      // A place that nothing leads away from is no part of a path.
      const bool leads_on = i + 1 < rows_.size() && rows_[i + 1].kind != PathKind::begin;
      row.kind = PathKind::begin;
      row.feed = 0.0F;
      if (leads_on) keep(row, line);
      continue;
    }
    const double length =
        std::hypot(row.spot.at[0] - from->at[0], row.spot.at[1] - from->at[1], row.spot.at[2] - from->at[2]);
    (row.kind == PathKind::rapid ? path_.rapid_mm : path_.cut_mm) += length;
    ToolMoves& by_tool = path_.tools[row.tool];
    (row.kind == PathKind::rapid ? by_tool.rapid_mm : by_tool.cut_mm) += length;
    ++path_.segments;
    keep(row, line);
  }
  rows_ = {};
  return std::move(path_);
}

ToolPath record_path(Examination& e, const CheckBudget& budget, ir::MotionSink* beside) {
  PathRecorder recorder(x_is_diameter(e.control, e.profile));
  e.used_up = [&recorder, in_time = time_budget(budget.seconds)] {
    if (recorder.is_full()) return fmt::format("{} points of a path", ToolPath::kMostPoints);
    return in_time ? in_time() : std::string();
  };
  std::vector<ir::MotionSink*> all = {&recorder};
  if (beside != nullptr) all.push_back(beside);
  compile::FanOut sinks(std::move(all));
  Followed followed = follow(e, sinks);
  ToolPath path = recorder.finish(followed.run);
  path.report = std::move(followed.report);
  return path;
}

Result<ToolPath> follow_path(const DiagnoseOrder& order, const Documents& documents, const CheckBudget& budget) {
  const auto opened = open_text(order, documents);
  if (!opened) return std::unexpected(opened.error());
  return record_path((*opened)->examination, budget);
}

}  // namespace dripfeed::app
