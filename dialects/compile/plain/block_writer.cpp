// One function a kind of motion, by a table. Motion codes are stated when they change, arcs always; feeds when they or
// their mode change. Positions are absolute and in mm, as motions have them.
#include "dialects/compile/plain/block_writer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dialects/compile/dialect/motion_codes.h"
#include "dialects/ir/cycle.h"

namespace dripfeed::compile {

namespace {

using ir::Address;
using ir::Function;
using ir::MotionKind;

Function function_of(ir::FeedMode mode) {
  switch (mode) {
    case ir::FeedMode::per_min: return Function::feed_per_min;
    case ir::FeedMode::per_rev: return Function::feed_per_rev;
    case ir::FeedMode::inverse_time: return Function::feed_inverse_time;
  }
  return Function::none;
}

Function function_of(ir::CoolantState state) {
  switch (state) {
    case ir::CoolantState::off: return Function::coolant_off;
    case ir::CoolantState::mist: return Function::coolant_mist;
    case ir::CoolantState::flood: return Function::coolant_flood;
  }
  return Function::none;
}

// A piece of a curve is its chord.
Function function_of(const ir::Motion& motion) {
  if (motion.kind == MotionKind::thread) return motion.center[0] != 0.0 ? Function::thread_changing : Function::thread;
  return plain_function_of(motion.kind).value_or(Function::linear);
}

}  // namespace

BlockWriter::BlockWriter(ir::Program& program, const ir::Control& control, const interpreter::RunNames& names,
                         bool inch)
    : program_(program), control_(control), names_(names), emit_(program), unit_mm_(inch ? 25.4 : 1.0) {}

void BlockWriter::safe_start(ir::Plane plane, ir::FeedMode feed_mode) {
  plane_ = plane;
  feed_mode_ = feed_mode;
  add(unit_mm_ == 1.0 ? Function::unit_mm : Function::unit_inch);
  add(function_of(plane));
  add(Function::absolute);
  add(function_of(feed_mode));
  add(Function::comp_off);
  if (control_.kind != ir::MachineKind::mill) {
    add(control_.semantics.power_on_diameter == ir::DiameterMode::radius ? Function::diameter_off
                                                                         : Function::diameter_on);
  }
  emit_.set_line(0);
  block();
}

void BlockWriter::block() {
  for (const family::EmittedCode& code : std::exchange(carried_.codes, {})) codes_.push_back(code);
  for (const CarriedWord& word : std::exchange(carried_.words, {})) {
    if (std::ranges::find(words_, word.address, &family::EmittedWord::address) != words_.end()) continue;
    words_.push_back({word.address, emit_.constant(word.value), word.mode});
  }
  emit_.block(codes_, words_);
  codes_.clear();
  words_.clear();
}

void BlockWriter::carry(const CarriedWords& words) {
  carried_.codes.insert(carried_.codes.end(), words.codes.begin(), words.codes.end());
  carried_.words.insert(carried_.words.end(), words.words.begin(), words.words.end());
}

void BlockWriter::write_alone(const CarriedWords& words, std::uint32_t line) {
  flush(line);
  emit_.set_line(line);
  carry(words);
  block();
}

void BlockWriter::flush(std::uint32_t line) {
  if (carried_.codes.empty() && carried_.words.empty()) return;
  emit_.set_line(line);
  block();
}

void BlockWriter::forget(std::uint32_t line) {
  flush(line);
  motion_ = Function::none;
  feed_ = 0.0;
}

void BlockWriter::event_block(Function function) {
  add(function);
  block();
}

void BlockWriter::write(const ir::Motion& motion, std::uint32_t line) {
  emit_.set_line(line);
  switch (motion.kind) {
    case MotionKind::rapid:
    case MotionKind::linear:
    case MotionKind::arc_cw:
    case MotionKind::arc_ccw:
    case MotionKind::spline:  // of curves that are not interpreted the run reports
    case MotionKind::thread: return move(motion);
    case MotionKind::dwell:
      add(Function::dwell);
      add(Address::f, motion.feed);
      return block();
    case MotionKind::offset:
      work_offset_ = motion.number;
      add(Function::work_offset, static_cast<std::int16_t>(motion.number));
      return block();
    case MotionKind::tool: return tool(motion);
    // Compensation begins and ends with a move: its code waits for the next one.
    case MotionKind::comp: return carry({{{function_of(motion.comp), 0}}, {}});
    case MotionKind::spindle: return spindle(motion);
    case MotionKind::coolant: return event_block(function_of(motion.coolant));
    case MotionKind::message: return message(motion);
    case MotionKind::stop: return event_block(motion.number == 0 ? Function::program_stop : Function::optional_stop);
    case MotionKind::end: flush(line); return emit_.program_end();
  }
}

// The cycle goes to the place of the hole itself, and back to where its feed began; rapids after that are blocks.
void BlockWriter::write_tap(std::span<const ir::Motion> hole, std::uint32_t line) {
  constexpr std::size_t kZ = 2;
  const auto cuts = [](const ir::Motion& m) { return m.kind == MotionKind::linear; };
  const auto in = std::ranges::find_if(hole, cuts);
  emit_.set_line(line);
  restate(*in);
  if (in->feed_mode != feed_mode_) add(function_of(in->feed_mode));
  feed_mode_ = in->feed_mode;
  add(Function::return_to_r);
  const bool right = in->spindle == ir::SpindleState::clockwise;
  add(Function::drill, ir::drill_argument(right ? ir::DrillCycle::tap_right : ir::DrillCycle::tap_left));
  for (std::size_t axis = 0; axis < kZ; ++axis)
    if ((in->axes_unknown & (1U << axis)) == 0) add_length(kAxisAddresses[axis], in->start[axis]);
  add_length(Address::z, in->end[kZ]);
  add_length(Address::r, in->start[kZ]);
  add(Address::f, in->feed / unit_mm_);
  block();
  add(Function::rapid);
  event_block(Function::cycle_off);
  motion_ = Function::rapid;
  feed_ = 0.0;
  const auto out = std::find_if(in + 1, hole.end(), cuts);
  for (const ir::Motion& after : hole.subspan(static_cast<std::size_t>(out - hole.begin()) + 1))
    if (after.kind == MotionKind::rapid) write(after, line);
}

void BlockWriter::write_return(std::uint32_t line) {
  flush(line);
  emit_.set_line(line);
  emit_.subprogram_return();
}

void BlockWriter::plane(const ir::Motion& motion) {
  if (motion.plane == plane_) return;
  plane_ = motion.plane;
  add(function_of(motion.plane));
}

// A thread's F is its lead, whatever the mode; inverse time is given in every block.
bool BlockWriter::has_feed(const ir::Motion& motion) const {
  if (motion.kind == MotionKind::rapid || motion.feed == 0.0) return true;
  return motion.kind != MotionKind::thread && motion.feed_mode == feed_mode_ &&
         motion.feed_mode != ir::FeedMode::inverse_time && motion.feed == feed_;
}

void BlockWriter::feed(const ir::Motion& motion) {
  if (has_feed(motion)) return;
  const bool thread = motion.kind == MotionKind::thread;
  const bool same_mode = thread || motion.feed_mode == feed_mode_;
  if (!same_mode) add(function_of(motion.feed_mode));
  if (!thread) feed_mode_ = motion.feed_mode;
  // The lead of a thread is no feed on a control that has a word of its own for it.
  feed_ = thread ? 0.0 : motion.feed;
  const double unit = motion.feed_mode == ir::FeedMode::inverse_time ? 1.0 : unit_mm_;
  add(thread && counts_along_x(motion) ? Address::i : Address::f, motion.feed / unit);
}

// The lead of a cone counts along the axis that moves more; controls that name it by a letter say so by I.
bool BlockWriter::counts_along_x(const ir::Motion& motion) const {
  const double factor = control_.semantics.power_on_diameter == ir::DiameterMode::radius ? 1.0 : 2.0;
  const double x = std::abs(motion.end[0] - motion.start[0]) / factor;
  return (motion.axes_unknown & 5U) == 0 && x > std::abs(motion.end[2] - motion.start[2]);
}

// The plane's two axes only; a zero is stated, too, so that no control asks for it.
void BlockWriter::center(const ir::Motion& motion) {
  for (std::size_t axis = 0; axis < kCenterAddresses.size(); ++axis)
    if (is_in_plane(motion.plane, axis)) add_length(kCenterAddresses[axis], motion.center[axis]);
}

bool BlockWriter::states_positions_alone(const ir::Motion& motion) const {
  const bool straight = ir::is_move(motion.kind) && !is_arc(motion.kind) && motion.kind != MotionKind::thread;
  return straight && has_moved_ && !restates_ && function_of(motion) == motion_ && has_feed(motion) &&
         !motion.machine_coordinates && !motion.exact_stop && carried_.empty() && unit_mm_ == 1.0;
}

void BlockWriter::move(const ir::Motion& motion) {
  const Function function = function_of(motion);
  restate(motion);
  has_moved_ = true;
  // Controls refuse a thread while the feed is a time.
  if (motion.kind == MotionKind::thread && feed_mode_ == ir::FeedMode::inverse_time) {
    feed_mode_ = motion.feed_mode;
    event_block(function_of(motion.feed_mode));
  }
  if (is_arc(motion.kind)) plane(motion);
  if (motion.machine_coordinates) add(Function::machine_coordinates);
  if (motion.exact_stop) add(Function::exact_stop_once);
  if (function != motion_ || is_arc(motion.kind) || motion.kind == MotionKind::thread) add(function);
  motion_ = function;
  const std::uint16_t named = axes_to_name(motion);
  for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis) {
    if ((named & (1U << axis)) == 0) continue;
    if (ir::is_rotary_axis(kAxisAddresses[axis]))
      add(kAxisAddresses[axis], motion.end[axis]);
    else
      add_length(kAxisAddresses[axis], motion.end[axis]);
  }
  if (is_arc(motion.kind)) center(motion);
  feed(motion);
  if (function == Function::thread_changing) add_length(Address::k, motion.center[0]);
  block();
}

void BlockWriter::tool(const ir::Motion& motion) {
  constexpr std::uint32_t kNoName = 0xFFFFFFFFU;
  const bool same = motion.number == tool_number_ && motion.text == tool_name_;
  const bool changes = (motion.axes_commanded & ir::kOrdersChange) != 0;
  const bool with_offset = control_.semantics.tool_word == ir::ToolWord::number_and_offset;
  const bool by_t = with_offset || control_.kind == ir::MachineKind::lathe;
  const bool ordered = (motion.axes_commanded & ir::kOrdersTool) != 0 || (changes && !by_t);
  const bool states = !same || ordered;
  const bool edge = (motion.axes_commanded & ir::kOrdersEdge) != 0;
  restates_ = restates_ || (has_moved_ && (!same || changes));
  // A changer stops the spindle (M6), whatever a run takes it for: only the program orders it to turn with the next
  // tool, which may be a probe. A turret leaves it turning.
  restates_speed_ = restates_ && !changes && control_.kind == ir::MachineKind::lathe;
  tool_number_ = motion.number;
  tool_name_ = motion.text;
  if (motion.text != kNoName) {
    ir::Expression name;
    name.op = ir::Operator::string;
    name.string = program_.strings.add(names_.strings[motion.text]);
    if (states) words_.push_back({Address::t, program_.add(name)});
  } else if (with_offset && (states || motion.tool_offset != tool_offset_)) {
    add(Address::t, motion.number * 100.0 + motion.tool_offset);
  } else if (!with_offset && states) {
    add(Address::t, motion.number);
  }
  // Without a D the control takes the edge that it usually does (MD20270): D0 would leave the tool's length out.
  if (control_.semantics.d_selects_edge &&
      (edge || (motion.tool_offset != 0 && (states || motion.tool_offset != tool_offset_))))
    add(Address::d, motion.tool_offset);
  tool_offset_ = motion.tool_offset;
  if (changes) add(Function::tool_change);
  if (!codes_.empty() || !words_.empty()) block();
}

void BlockWriter::spindle(const ir::Motion& motion) {
  const std::uint16_t orders = motion.axes_commanded;
  const bool stands = motion.spindle == ir::SpindleState::stopped;
  if (orders == ir::kOrdersLimit) return speed_limit(motion.spindle_rpm);
  const bool goes_on = motion.spindle == spindle_ && surface_speed_ == (motion.surface_speed_m_min > 0.0);
  if (orders == ir::kOrdersSpeed && (stands || goes_on)) {
    speed(motion);
  } else if (!stands) {
    speed(motion);
    add(motion.spindle == ir::SpindleState::clockwise ? Function::spindle_cw : Function::spindle_ccw);
  } else {
    add((orders & ir::kOrdersOrientation) != 0 ? Function::spindle_orient : Function::spindle_stop);
  }
  spindle_ = motion.spindle;
  restates_speed_ = false;
  if (!codes_.empty() || !words_.empty()) block();
}

void BlockWriter::speed_limit(double limit_rpm) {
  if (!(limit_rpm > 0.0)) return;
  limit_rpm_ = limit_rpm;
  add(Address::spindle_limit, limit_rpm);
  block();
}

void BlockWriter::speed(const ir::Motion& motion) {
  const bool surface = motion.surface_speed_m_min > 0.0;
  if (surface || surface_speed_ || control_.kind != ir::MachineKind::mill)
    add(surface ? Function::surface_speed_on : Function::surface_speed_off);
  const bool was_surface = std::exchange(surface_speed_, surface);
  constexpr double kFoot_m = 0.3048;
  const double speed_unit_m = unit_mm_ == 1.0 ? 1.0 : kFoot_m;
  // A speed that a surface speed left is left by it here, too, and is no whole number.
  if (surface)
    add(Address::s, motion.surface_speed_m_min / speed_unit_m);
  else if (motion.spindle_rpm > 0.0 && (!was_surface || motion.spindle_rpm == std::round(motion.spindle_rpm)))
    add(Address::s, motion.spindle_rpm);
  if (!surface || !(motion.spindle_rpm > 0.0) || motion.spindle_rpm == limit_rpm_) return;
  limit_rpm_ = motion.spindle_rpm;
  add(Address::spindle_limit, motion.spindle_rpm);
}

// What waits for a block goes into the move's.
void BlockWriter::restate(const ir::Motion& motion) {
  if (!restates_ || motion.machine_coordinates) return;
  if (restates_speed_ && motion.spindle != ir::SpindleState::stopped) {
    CarriedWords waiting = std::exchange(carried_, {});
    ir::Motion turning = motion;
    turning.axes_commanded = ir::kOrdersSpindle;
    limit_rpm_ = 0.0;
    spindle(turning);
    carried_ = std::move(waiting);
  }
  restates_ = restates_speed_ = false;
  add(Function::absolute);
  add(function_of(motion.plane));
  add(function_of(motion.feed_mode));
  if (work_offset_ >= 0) add(Function::work_offset, static_cast<std::int16_t>(work_offset_));
  plane_ = motion.plane;
  feed_mode_ = motion.feed_mode;
  motion_ = Function::none;
  feed_ = 0.0;
}

void BlockWriter::message(const ir::Motion& motion) {
  const bool clears = motion.text >= names_.strings.size();
  emit_.message(clears ? std::string_view() : std::string_view(names_.strings[motion.text]));
}

}  // namespace dripfeed::compile
