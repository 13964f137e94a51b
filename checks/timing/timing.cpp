// From motions to the three times. Motions become pieces of the planner's path; what the plan gives back goes, in order
// and with what is no move, through the feeder.
#include "checks/timing/timing.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "checks/timing/feeder.h"
#include "checks/timing/kinematics.h"
#include "checks/timing/planner.h"
#include "checks/timing/ring.h"
#include "dialects/text/number.h"

namespace dripfeed::timing {

namespace {

constexpr double kStall_s = 1e-6;

}  // namespace

class Timing::Work final : public PlanSink {
 public:
  explicit Work(Settings settings)
      : settings_(std::move(settings)),
        rates_(rates_of(settings_.machine)),
        cost_(settings_.machine.timing.cost.value_or(settings_.cost)),
        planner_(*this, settings_.machine.timing.look_ahead_blocks),
        feeder_(buffer_of(settings_), char_s(settings_), settings_.line ? settings_.line->latency_s : 0.0) {
    report_.cost_is_measured = cost_.measured;
    bytes_through_.reserve(settings_.line_bytes.size() + 1);
    bytes_through_.push_back(0);
    for (const std::uint32_t bytes : settings_.line_bytes) bytes_through_.push_back(bytes_through_.back() + bytes);
    say_what_is_missing();
  }

  void add(const ir::Motion& motion);
  Report finish();

 private:
  // What waits for the plan: one entry a motion.
  struct Item {
    FedBlock block;
    bool is_piece = false;  // the plan gives its time
    bool is_rapid = false;
  };

  static checks::BufferSize buffer_of(const Settings& settings) {
    checks::BufferSize buffer = settings.machine.buffer;
    // In the memory nothing but the look-ahead limits how far computing runs ahead of motion.
    if (!settings.line && buffer.blocks == 0) buffer.blocks = settings.machine.timing.look_ahead_blocks;
    return buffer;
  }
  static double char_s(const Settings& settings) {
    return settings.line && settings.line->baud > 0.0 ? settings.line->char_s() : 0.0;
  }

  void say_what_is_missing();
  std::uint64_t bytes_of(const ir::Place& place);
  void add_move(const ir::Motion& motion, Item& item);
  double event_seconds(const ir::Motion& motion);
  void planned(double duration_s, double start, double end) override;
  void drain();
  void feed(const Item& item);

  Settings settings_;
  AxisRates rates_;
  ir::CostModel cost_;
  Planner planner_;
  Feeder feeder_;
  Report report_;
  Ring<Item> items_;
  std::vector<std::uint64_t> bytes_through_;  // of the lines 1 .. index
  std::uint32_t line_sent_ = 0;
  std::uint64_t last_ordinal_ = 0;
  std::uint32_t last_program_ = 0;
  bool first_ = true;
  AxisVector direction_{};  // at the end of the last move
  bool rests_ = true;       // the next move starts from rest
  bool was_rapid_ = false;
  std::int32_t tool_ = -1;
};

void Timing::Work::say_what_is_missing() {
  const auto say = [&](const char* sentence) { report_.not_checked.add(sentence); };
  if (!rates_.rapid_known) say("the rapid speed of an axis is not known: its rapid moves take no time");
  if (!rates_.acceleration_known) say("the acceleration of an axis is not known: it reaches every speed at once");
  if (!(rates_.sample_s > 0.0)) say("the sample time is not known: corners take no time");
  if (!(ir::compute_ms(cost_, {1, 1, 1, 1, 1}) > 0.0))
    say("what a block costs the control is not known: computing takes no time");
  const bool has_size = settings_.machine.buffer.bytes > 0 || settings_.machine.buffer.blocks > 0;
  if (settings_.line && !has_size) say("the control's buffer is not known: it is taken as without limit");
  if (settings_.line && settings_.line_bytes.empty())
    say("the length of the lines is not known: the line takes no time");
}

// Bytes that went over the line for this block: its own line, and those before it that no motion came from.
std::uint64_t Timing::Work::bytes_of(const ir::Place& place) {
  if (!settings_.line || place.program != 0 || place.line <= line_sent_) return 0;
  const auto last = std::min<std::size_t>(place.line, bytes_through_.size() - 1);
  const std::size_t before = std::min<std::size_t>(line_sent_, last);
  line_sent_ = place.line;
  return bytes_through_[last] - bytes_through_[before];
}

double Timing::Work::event_seconds(const ir::Motion& motion) {
  switch (motion.kind) {
    case ir::MotionKind::dwell: rests_ = true; return std::max(0.0, motion.feed);
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

void Timing::Work::add_move(const ir::Motion& motion, Item& item) {
  const std::uint32_t line = motion.place.line;
  if (motion.axes_unknown != 0) {
    report_.not_checked.add("a move starts at a place that is not known: its way is not counted", line);
  }
  const PathShape shape = shape_of(motion, settings_.x_is_diameter);
  if (!(shape.length > 0.0)) {
    rests_ = rests_ || motion.exact_stop;
    return;
  }
  item.is_rapid = motion.kind == ir::MotionKind::rapid;
  double speed = speed_limit(shape, rates_, item.is_rapid);
  if (!item.is_rapid) {
    const double feed = feed_speed(motion, shape, settings_.x_is_diameter, settings_.machine.spindle_max_rpm);
    if (!(feed > 0.0)) {
      report_.not_checked.add(
          "a move has no feed, or a feed per revolution and no spindle speed: its time is not counted", line);
      rests_ = true;
      return;
    }
    speed = std::min(speed, feed);
  }
  // Rapids are ended before anything else begins, threads begin in step with the spindle.
  const bool is_thread = motion.kind == ir::MotionKind::thread;
  const bool from_rest = rests_ || item.is_rapid || was_rapid_ || is_thread;
  const double corner2 = from_rest ? 0.0 : corner_speed2(direction_, shape.start_direction, rates_);
  item.is_piece = true;
  report_.path_mm += shape.length;
  direction_ = shape.end_direction;
  was_rapid_ = item.is_rapid;
  rests_ = motion.exact_stop || is_thread;
  planner_.append({shape.length, std::min(speed * speed, kNoLimit), corner2, path_acceleration(shape, rates_)});
}

void Timing::Work::add(const ir::Motion& motion) {
  Item item;
  item.block.line = motion.place.line;
  item.block.is_new = first_ || motion.place.ordinal != last_ordinal_ || motion.place.program != last_program_;
  item.block.bytes = bytes_of(motion.place);
  item.block.compute_s = ir::compute_ms(cost_, motion.compute) * 1e-3;
  first_ = false;
  last_ordinal_ = motion.place.ordinal;
  last_program_ = motion.place.program;
  report_.blocks = std::max(report_.blocks, motion.place.ordinal + 1);
  report_.compute_s += item.block.compute_s;
  if (ir::is_move(motion.kind)) {
    // The piece may give out those before it, never itself: so its item may come after.
    add_move(motion, item);
  } else {
    item.block.motion_s = event_seconds(motion);
    if (rests_) planner_.finish();
  }
  items_.push_back(item);
  drain();
}

void Timing::Work::planned(double duration_s, double /*start*/, double /*end*/) {
  drain();
  Item& item = items_.front();  // every piece given out has its item here, and drain() stopped at it
  item.block.motion_s = duration_s;
  if (item.is_rapid) report_.rapid_s += duration_s;
  feed(item);
  items_.pop_front();
}

// What waits for no plan, up to the first piece.
void Timing::Work::drain() {
  while (!items_.empty() && !items_.front().is_piece) {
    feed(items_.front());
    items_.pop_front();
  }
}

void Timing::Work::feed(const Item& item) {
  report_.motion_s += item.block.motion_s;
  const double waited_s = feeder_.feed(item.block);
  if (waited_s <= kStall_s) return;
  if (report_.stalls++ == 0) report_.first_stall_line = item.block.line;
  report_.stall_s += waited_s;
  report_.findings.add(text::DiagnosticId::line_starves, {0, item.block.line, 0}, waited_s, 0.0,
                       [&] { return std::vector<std::string>{text::format_fixed(waited_s, 3)}; });
}

Report Timing::Work::finish() {
  planner_.finish();
  drain();
  if (settings_.line && settings_.line->baud > 0.0) {
    report_.line_s = settings_.line->latency_s + static_cast<double>(bytes_through_.back()) * settings_.line->char_s();
  }
  report_.cycle_s = feeder_.end_s();
  return std::move(report_);
}

Timing::Timing(Settings settings) : work_(std::make_unique<Work>(std::move(settings))) {}
Timing::~Timing() = default;

void Timing::consume(std::span<const ir::Motion> motions) {
  for (const ir::Motion& motion : motions) work_->add(motion);
}

Report Timing::finish() { return work_->finish(); }

}  // namespace dripfeed::timing
