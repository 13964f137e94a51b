// Straight moves and threads, and what every move does to the state.
#include "dialects/interpreter/motion/mover.h"

#include <cmath>

#include "dialects/ir/thread_lead.h"

namespace dripfeed::interpreter {

using ir::Address;
using ir::MotionKind;

namespace {

// After a move in machine coordinates the place in the work offset is not known; an increment from an unknown place
// ends at one.
void take_position(const Target& target, const MoveOptions& options, ModalState& state, BlockResult& result) {
  if (options.machine_coordinates) {
    state.unknown |= target.commanded;
    return;
  }
  if ((state.unknown & target.incremental) != 0) result.notes |= kNoteIncrementalFromUnknown;
  const auto absolute = static_cast<std::uint16_t>(target.commanded & ~target.incremental);
  if (target.shifted != 0) [[unlikely]]
    result.notes |= kNoteShiftedIncrement;
  state.shifted &= static_cast<std::uint16_t>(~(absolute | target.stated));
  state.unknown &= static_cast<std::uint16_t>(~absolute);
  state.unknown |= target.unknown;
  state.position = target.end;
}

// Motions say their plane by its name, and the frame makes another one of it.
bool compensates_in_tilted_plane(const Modes& modes) {
  return modes.comp != ir::CompSide::off && image_of(modes.matrix, axes_of(modes.plane)).tilted;
}

// Left of the programmed path is right of its mirror image.
ir::CompSide comp_of(const Modes& modes) {
  if (!modes.has_matrix || modes.comp == ir::CompSide::off) return modes.comp;
  if (!image_of(modes.matrix, axes_of(modes.plane)).mirrored) return modes.comp;
  return modes.comp == ir::CompSide::left ? ir::CompSide::right : ir::CompSide::left;
}

// Of an offset; 0 where it is none.
std::int32_t number_of(double value) {
  constexpr double kMost = 1e6;
  return value >= 0.0 && value <= kMost ? static_cast<std::int32_t>(value) : 0;
}

bool has_lead_letter(const PlainBlock& block) {
  return block.has(Address::i) || block.has(Address::j) || block.has(Address::k);
}

}  // namespace

void fill_common(ir::Motion& motion, const ModalState& state) {
  motion.plane = state.modes.plane;
  motion.feed_mode = state.modes.feed_mode;
  motion.start = state.position;
  motion.end = state.position;
  motion.spindle = state.spindle;
  const bool no_speed = state.modes.surface_speed && state.surface_speed_m_min == 0.0;  // of which there is a limit
  motion.spindle_rpm = no_speed ? 0.0 : state.modes.surface_speed ? state.spindle_limit_rpm : state.rpm;
  motion.surface_speed_m_min = state.modes.surface_speed ? state.surface_speed_m_min : 0.0;
  motion.comp = comp_of(state.modes);
  if (motion.comp != ir::CompSide::off) motion.tool_offset = number_of(state.comp_number);
  motion.coolant = state.coolant;
  motion.length_offset = state.length_offset;
  motion.length_offset_number = state.length_offset_number;
  motion.gaps = state.gaps;
}

ir::Motion& emit_move(MotionKind kind, const Target& target, double feed, const MoveOptions& options, ModalState& state,
                      MotionBuffer& out, BlockResult& result) {
  ir::Motion& motion = out.add(kind);
  fill_common(motion, state);
  motion.end = target.end;
  motion.feed = feed;
  if (kind == MotionKind::thread) motion.feed_mode = ir::FeedMode::per_rev;
  motion.axes_commanded = target.commanded;
  motion.axes_unknown = state.unknown | target.unknown;
  if (((state.unknown & target.incremental) | target.unknown) != 0) motion.gaps |= ir::kEndUnknown;
  motion.machine_coordinates = options.machine_coordinates;
  motion.exact_stop = options.exact_stop || state.modes.exact_stop;
  if (state.modes.has_matrix && compensates_in_tilted_plane(state.modes)) [[unlikely]]
    result.notes |= kNoteCompInFrame;
  const bool stands = kind == MotionKind::thread ? feed == 0.0 : feed <= 0.0;
  if (kind != MotionKind::rapid && stands && !state.feed_unknown) result.notes |= kNoteNoFeed;
  take_position(target, options, state, result);
  return motion;
}

void Mover::straight(MotionKind kind, const Target& target) {
  const double feed = kind == MotionKind::rapid ? 0.0 : kind == MotionKind::thread ? lead() : state_.feed;
  const AxisValues start = state_.position;
  const std::uint16_t unknown_before = state_.unknown;
  emit(kind, target, feed);
  if (kind != MotionKind::linear) return end_contour();
  for (std::size_t axis = 0; axis < 3; ++axis) state_.tangent[axis] = radius_of(axis, target.end[axis] - start[axis]);
  // An axis outside the plane may be one that the machine has not got.
  const auto unknown = static_cast<std::uint16_t>(unknown_before | state_.unknown);
  const PlaneAxes axes = axes_of(state_.modes.plane);
  state_.tangent_known = (unknown & 7U) == 0 || ((unknown >> axes.p | unknown >> axes.q) & 1U) == 0;
  finish_corner();
}

// Where K, I or J is the lead, F is its change; otherwise F is the lead and K the change. The lead counts along the
// axis that moves most. (SINUMERIK PG, "Thread cutting with increasing or decreasing lead"; Fanuc 0i-F B-64604EN-1,
// "Variable lead threading".)
void Mover::changing_thread(const Target& target) {
  const bool by_letters = !rules_.semantics.arc_radius_is_r;
  const double first = by_letters && !has_lead_letter(block_) ? 0.0 : by_letters ? lead() : state_.feed;
  const double change = lead_change(by_letters ? Address::f : Address::k);
  double travel = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    travel = std::max(travel, std::abs(radius_of(axis, target.end[axis] - state_.position[axis])));
  const bool known = ((state_.unknown | target.unknown) & target.commanded) == 0;
  if (first < 0.0 || (known && first > 0.0 && travel > 0.0 && !(ir::lead_after(first, change, travel) > 0.0))) {
    result_.fault = text::DiagnosticId::thread_invalid;
    result_.reason = first < 0.0 ? "its lead is below 0" : "its lead falls to 0 before its end";
    return;
  }
  emit(MotionKind::thread, target, first).center[0] = change;
  end_contour();
}

double Mover::lead_change(ir::Address address) const {
  const bool inch = address == Address::f ? state_.modes.inch_feed : state_.modes.inch;
  const bool counted = (block_.in_increments & bit_of(address)) != 0;
  // A parameter decides what a number without a point counts; G70 and F what unit the change is in.
  if (!block_.has(address) || counted || inch != state_.modes.inch) result_.notes |= kNoteLeadChange;
  if (!block_.has(address)) return 0.0;
  const double change = rules_.length_mm(block_, address, inch);
  // The code itself states the direction.
  if (address == Address::f && change < 0.0) result_.notes |= kNoteLeadChange;
  return state_.modes.lead_shrinks ? -change : change;
}

void Mover::end_contour() {
  state_.tangent_known = false;
  leave_corners();
}

void Mover::leave_corners() {
  if (has_corner_word()) result_.notes |= kNoteCornerNotComputed;
  drop_corner();
}

bool Mover::starts_unknown(PlaneAxes axes) const {
  return ((state_.unknown >> axes.p | state_.unknown >> axes.q) & 1U) != 0;
}

// No arc can be written, but where it ends may be known.
void Mover::lose(const Target& target, std::uint64_t note) {
  result_ = {};
  result_.notes |= note;
  state_.tangent_known = false;
  drop_corner();
  take_position(target, options_, state_, result_);
}

PlanePoint Mover::point_of(const AxisValues& at, PlaneAxes axes) const {
  return {radius_of(axes.p, at[axes.p]), radius_of(axes.q, at[axes.q])};
}

// End minus start in the plane, radius values.
PlanePoint Mover::chord(PlaneAxes axes, const Target& target) const {
  return {radius_of(axes.p, target.end[axes.p] - state_.position[axes.p]),
          radius_of(axes.q, target.end[axes.q] - state_.position[axes.q])};
}

// Of a thread: K, I or J where one is given, otherwise F.
double Mover::lead() const {
  for (const Address address : {Address::k, Address::i, Address::j})
    if (block_.has(address)) return rules_.length_mm(block_, address, state_.modes.inch);
  return state_.feed;
}

ir::Motion& Mover::emit(MotionKind kind, const Target& target, double feed) {
  return emit_move(kind, target, feed, options_, state_, out_, result_);
}

void Mover::fail(text::DiagnosticId id, double first, double second) {
  result_.fault = id;
  result_.first = first;
  result_.second = second;
}

std::optional<PlanePoint> Mover::fail_center(text::DiagnosticId id, double first, double second) {
  fail(id, first, second);
  return std::nullopt;
}

}  // namespace dripfeed::interpreter
