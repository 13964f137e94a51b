// Blocks of one move each, in absolute coordinates.
#include "dialects/interpreter/cycles/mill_tool.h"

#include <cmath>

#include "dialects/interpreter/arithmetic/arithmetic.h"
#include "dialects/interpreter/motion/move.h"
#include "dialects/interpreter/motion/polar.h"

namespace dripfeed::interpreter {

namespace {

constexpr double kSamePlace_mm = 1e-9;

bool are_same(PlanePoint a, PlanePoint b) { return length_of({a.p - b.p, a.q - b.q}) < kSamePlace_mm; }

}  // namespace

MillTool::MillTool(const BlockRules& rules, ModalState& state, MotionBuffer& out, BlockResult& result)
    : rules_(rules),
      state_(state),
      out_(out),
      result_(result),
      axes_(axes_of(state.modes.plane)),
      modes_(state.modes),
      feed_(state.feed),
      rounding_mm_(state.modal_rounding_mm) {
  state_.modes.motion_given = true;
  state_.modal_rounding_mm = 0.0;
}

void MillTool::go_to_place(const ir::MillPlace& place) {
  place_ = place;
  cosine_ = cosine_deg(place.angle_deg);
  sine_ = sine_deg(place.angle_deg);
}

void MillTool::finish(bool place_is_known) {
  state_.modes = modes_;
  state_.feed = feed_;
  state_.modal_rounding_mm = rounding_mm_;
  state_.tangent_known = false;
  if (!place_is_known) state_.unknown |= static_cast<std::uint16_t>(1U << axes_.p | 1U << axes_.q);
}

PlanePoint MillTool::in_program(PlanePoint local) const {
  return {place_.first + cosine_ * local.p - sine_ * local.q, place_.second + sine_ * local.p + cosine_ * local.q};
}

bool MillTool::is_known() const {
  const unsigned needed = state_.modes.has_matrix ? 7U : 1U << axes_.p | 1U << axes_.q;
  return (state_.unknown & needed) == 0;
}

PlanePoint MillTool::from_program() const {
  const Vector at = programmed_position(rules_, state_);
  const PlanePoint from = {at[axes_.p] - place_.first, at[axes_.q] - place_.second};
  return {cosine_ * from.p + sine_ * from.q, cosine_ * from.q - sine_ * from.p};
}

void MillTool::put(PlanePoint to) {
  const PlanePoint there = in_program(to);
  put_coordinate(made_, rules_, state_, axes_.p, there.p);
  put_coordinate(made_, rules_, state_, axes_.q, there.q);
  at_ = to;
}

void MillTool::put_level(double z) { put_coordinate(made_, rules_, state_, axes_.normal, z); }

void MillTool::put_arc(PlanePoint center) {
  const PlanePoint there = in_program(center);
  put_center(made_, rules_, state_, axes_.p, there.p);
  put_center(made_, rules_, state_, axes_.q, there.q);
}

void MillTool::move(ir::Function motion, double feed) {
  state_.modes.motion = motion;
  if (feed > 0.0) state_.feed = feed;
  interpreter::move(made_, rules_, {}, state_, out_, result_);
  made_.clear();
}

void MillTool::rapid(PlanePoint to) {
  if (is_known() && are_same(from_program(), to)) {
    at_ = to;
    return;
  }
  put(to);
  move(ir::Function::rapid, 0.0);
}

void MillTool::rapid_level(double z) {
  const unsigned needed = state_.modes.has_matrix ? 7U : 1U << axes_.normal;
  const bool is_there = std::abs(programmed_position(rules_, state_)[axes_.normal] - z) < kSamePlace_mm;
  if ((state_.unknown & needed) == 0 && is_there) return;
  put_level(z);
  move(ir::Function::rapid, 0.0);
}

void MillTool::cut(PlanePoint to, double feed) {
  if (are_same(at_, to)) return;
  put(to);
  move(ir::Function::linear, feed);
}

void MillTool::cut_level(double z, double feed) {
  put_level(z);
  move(ir::Function::linear, feed);
}

void MillTool::cut(PlanePoint to, double z, double feed) {
  put(to);
  put_level(z);
  move(ir::Function::linear, feed);
}

void MillTool::arc(PlanePoint to, PlanePoint center, Turn turn, double feed) {
  if (are_same(at_, to)) return;
  put(to);
  put_arc(center);
  move(turn == Turn::counterclockwise ? ir::Function::arc_ccw : ir::Function::arc_cw, feed);
}

void MillTool::helix(PlanePoint to, PlanePoint center, double z, Turn turn, double feed) {
  put(to);
  put_level(z);
  put_arc(center);
  move(turn == Turn::counterclockwise ? ir::Function::arc_ccw : ir::Function::arc_cw, feed);
}

}  // namespace dripfeed::interpreter
