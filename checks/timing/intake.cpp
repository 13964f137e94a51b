// Every figure that leaves here is finite and above zero, whatever a program or a profile says.
#include "checks/timing/intake.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace dripfeed::timing {

namespace {

constexpr double kShortest_mm = 1e-9;
constexpr double kSlowest_mm_s = 1e-6;
constexpr double kLongest = 1e9;  // mm of a move, s of a dwell

double cost_s(const ir::CostModel& cost, const ir::ComputeCounts& counts) {
  const double ms = ir::compute_ms(cost, counts);
  return ms > 0.0 && ms < kLongest ? ms * 1e-3 : 0.0;
}

}  // namespace

Intake::Intake(const Settings& settings, Report& report)
    : settings_(settings),
      report_(report),
      rates_(rates_of(settings.machine)),
      cost_(settings.machine.timing.cost.value_or(settings.cost)) {
  report_.cost_source = cost_.source;
  report_.cost_spread = cost_.spread;
  const checks::TimingData& own = settings.machine.timing;
  report_.cost_origin = own.cost ? own.cost_origin : std::string(cost_.origin);
  bytes_through_.reserve(settings.line_bytes.size() + 1);
  bytes_through_.push_back(0);
  for (const std::uint32_t bytes : settings.line_bytes) bytes_through_.push_back(bytes_through_.back() + bytes);
  report_missing_settings();
}

void Intake::report_missing_settings() {
  const auto report = [&](const char* sentence) { report_.not_checked.add(sentence); };
  if (!rates_.rapid_known) report("the rapid speed of an axis is not known: its rapid moves take no time");
  if (!rates_.acceleration_known) report("the acceleration of an axis is not known: it reaches every speed at once");
  if (!(rates_.sample_s > 0.0)) report("the sample time is not known: corners take no time");
  if (!(ir::compute_ms(cost_, {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}) > 0.0))
    report("what a block costs the control is not known: computing takes no time");
  const bool has_size = settings_.machine.buffer.bytes > 0 || settings_.machine.buffer.blocks > 0;
  if (settings_.line && !has_size) report("the control's buffer is not known: it is taken as without limit");
  if (settings_.line && settings_.line_bytes.empty())
    report("the length of the lines is not known: the line takes no time");
  if (settings_.line && !(settings_.line->baud > 0.0 && settings_.line->baud < kLongest))
    report("the line has no baud rate: it takes no time");
}

// What went over the line for this block: its own line, and those before it that no motion came from.
void Intake::take_line(const ir::Place& place, Row& row) {
  if (!settings_.line || place.program != 0 || place.line <= line_sent_) return;
  const auto last = std::min<std::size_t>(place.line, bytes_through_.size() - 1);
  const std::size_t before = std::min<std::size_t>(line_sent_, last);
  line_sent_ = place.line;
  row.lines = static_cast<std::uint32_t>(last - before);
  row.bytes =
      static_cast<std::uint32_t>(std::min<std::uint64_t>(bytes_through_[last] - bytes_through_[before], UINT32_MAX));
}

double Intake::event_seconds(const ir::Motion& motion) {
  switch (motion.kind) {
    case ir::MotionKind::dwell:
      rests_ = true;
      if (motion.feed >= 0.0 && motion.feed < kLongest) return motion.feed;
      report_.not_checked.add("a dwell has no time that a machine could wait: it is not counted", motion.place.line);
      return 0.0;
    case ir::MotionKind::tool: {
      rests_ = true;
      const bool changes = motion.number != std::exchange(tool_, motion.number);
      return changes ? settings_.machine.timing.tool_change_s : 0.0;
    }
    case ir::MotionKind::stop:
      report_.not_checked.add("the program stops and waits for the operator: that time is not counted",
                              motion.place.line);
      rests_ = true;
      return 0.0;
    case ir::MotionKind::spindle:
    case ir::MotionKind::coolant:
    case ir::MotionKind::end: rests_ = true; return 0.0;
    case ir::MotionKind::offset:
    case ir::MotionKind::comp:
    case ir::MotionKind::message:
    case ir::MotionKind::rapid:
    case ir::MotionKind::linear:
    case ir::MotionKind::arc_cw:
    case ir::MotionKind::arc_ccw:
    case ir::MotionKind::spline:
    case ir::MotionKind::thread: return 0.0;
  }
  return 0.0;
}

void Intake::take_move(const ir::Motion& motion, Intaken& taken) {
  const std::uint32_t line = motion.place.line;
  if (motion.axes_unknown != 0) {
    report_.not_checked.add("a move starts at a position that is not known: its length is not counted", line);
  }
  const PathShape shape = shape_of(motion, settings_.x_is_diameter);
  if (!(shape.length < kLongest)) {
    report_.not_checked.add("a move has no length that a machine could move: it is not counted", line);
    rests_ = true;
    return;
  }
  if (shape.length < kShortest_mm) {
    rests_ = rests_ || motion.exact_stop;
    return;
  }
  taken.row.is_rapid = motion.kind == ir::MotionKind::rapid;
  taken.limit_mm_s = speed_limit(shape, rates_, taken.row.is_rapid);
  taken.feed_mm_s = kNoLimit;
  if (!taken.row.is_rapid) {
    taken.feed_mm_s = feed_speed(motion, shape, settings_.x_is_diameter, settings_.machine.spindle_max_rpm);
    if (!(taken.feed_mm_s > kSlowest_mm_s)) {
      report_.not_checked.add(
          "a move has no feed, or a feed per revolution and no spindle speed: its time is not counted", line);
      rests_ = true;
      return;
    }
  }
  const double speed = std::max(std::min(taken.limit_mm_s, taken.feed_mm_s), kSlowest_mm_s);
  // Rapids are ended before anything else begins, threads begin in step with the spindle.
  const bool is_thread = motion.kind == ir::MotionKind::thread;
  const bool from_rest = rests_ || taken.row.is_rapid || was_rapid_ || is_thread;
  const double room_mm = 0.5 * std::min(length_, shape.length);
  const double corner2 = from_rest ? 0.0 : corner_speed2(direction_, shape.start_direction, rates_, room_mm);
  double acceleration = path_acceleration(shape, rates_);
  if (settings_.limit_jerk) acceleration = mean_acceleration(acceleration, path_jerk(shape, rates_), speed);
  taken.row.is_piece = true;
  report_.path_mm += shape.length;
  direction_ = shape.end_direction;
  length_ = shape.length;
  was_rapid_ = taken.row.is_rapid;
  rests_ = motion.exact_stop || is_thread;
  taken.piece = {shape.length, std::min(speed * speed, kNoLimit), corner2, acceleration};
}

Intaken Intake::take(const ir::Motion& motion) {
  Intaken taken;
  Row& row = taken.row;
  row.line = motion.place.line;
  row.is_new = first_ || motion.place.ordinal != last_ordinal_ || motion.place.program != last_program_;
  take_line(motion.place, row);
  row.compute_s = cost_s(cost_, motion.compute);
  first_ = false;
  last_ordinal_ = motion.place.ordinal;
  last_program_ = motion.place.program;
  report_.blocks = std::max(report_.blocks, motion.place.ordinal + 1);
  report_.compute_s += row.compute_s;
  if (ir::is_move(motion.kind)) {
    take_move(motion, taken);
  } else {
    row.event_s = event_seconds(motion);
  }
  return taken;
}

}  // namespace dripfeed::timing
