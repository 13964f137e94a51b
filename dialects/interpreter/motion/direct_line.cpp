// In the plane with the axes p and q (G18: Z and X as radius) the angle counts from +p toward +q:
//
//   X or Z, ,A        one coordinate: the other follows from the line through the start
//   ,A                nothing: the end is where this line meets the next block's,
//   X Z ,A            which names its end and its own angle
//
// A corner (,C ,R) of the first of two such blocks lies where the lines meet. (Fanuc 0i-F B-64604EN-1, "Direct drawing
// dimension programming"; Mitsubishi M80 programming manual, "Linear angle command".)
#include "dialects/interpreter/motion/direct_line.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <optional>

#include "dialects/interpreter/motion/mover.h"

namespace dripfeed::interpreter {

namespace {

using ir::Address;
using ir::Function;
using ir::MotionKind;

constexpr std::uint64_t kAngle = bit_of(Address::direct_angle);
constexpr std::array kCornerWords = {Address::chamfer, Address::chamfer_length, Address::rounding};
constexpr std::uint64_t kCorners =
    bit_of(Address::chamfer) | bit_of(Address::chamfer_length) | bit_of(Address::rounding);
constexpr double kParallel = 1e-9;
constexpr double kSameDirection = 1e-3;  // of a line that both its ends and its angle give

class DirectLine {
 public:
  DirectLine(const PlainBlock& block, const BlockRules& rules, const MoveOptions& options, ModalState& state,
             MotionBuffer& out, BlockResult& result)
      : block_(block),
        rules_(rules),
        options_(options),
        state_(state),
        out_(out),
        result_(result),
        axes_(axes_of(state.modes.plane)) {}

  void run() {
    const PendingLine before = state_.line;
    state_.line = {};
    if (before.active) state_.unknown = before.unknown_before;
    Target target = find_any_target(block_, rules_, state_, options_.machine_coordinates);
    const bool p = names(target, axes_.p);
    const bool q = names(target, axes_.q);
    const bool angle_known = block_.has(Address::direct_angle);
    if (!is_line() || (target.unknown | (block_.unknown & kAngle)) != 0) return lose(target);
    if (before.active) {
      if (!p || !q || !angle_known)
        return fail(target, "the second line names no end, or no angle", ir::AlarmDetail::no_end_point);
      return two_lines(before, target);
    }
    if (!p && !q) return wait();
    if (p && q) return both_ends(target);
    one_end(target, p);
  }

 private:
  [[nodiscard]] static bool names(const Target& target, std::size_t axis) {
    return (target.commanded >> axis & 1U) != 0;
  }
  [[nodiscard]] bool is_line() const {
    const bool plain = !options_.machine_coordinates && options_.motion == Function::none && !state_.modes.has_matrix;
    const bool known = ((state_.unknown >> axes_.p | state_.unknown >> axes_.q) & 1U) == 0;
    return plain && known && state_.modes.motion == Function::linear && state_.modes.motion_modelled;
  }
  [[nodiscard]] double angle() const { return rules_.angle_deg(block_, Address::direct_angle); }
  static PlanePoint direction_of(double angle_deg) {
    const double angle = angle_deg * std::numbers::pi / 180.0;
    return {std::cos(angle), std::sin(angle)};
  }
  [[nodiscard]] double factor(std::size_t axis) const { return axis == 0 && rules_.x_is_diameter ? 2.0 : 1.0; }
  [[nodiscard]] PlanePoint point_of(const AxisValues& at) const {
    return {at[axes_.p] / factor(axes_.p), at[axes_.q] / factor(axes_.q)};
  }

  void lose(const Target& target) {
    result_.notes |= kNoteDirectAngle;
    state_.unknown |= target.commanded;
    state_.unknown |= static_cast<std::uint16_t>(1U << axes_.p | 1U << axes_.q);
    state_.tangent_known = false;
  }

  // Where the control has an alarm for it.
  void fail(const Target& target, std::string_view reason, ir::AlarmDetail detail) {
    if (!(detail == ir::AlarmDetail::not_an_end ? rules_.end_of_angle_alarm : rules_.angle_alarm)) return lose(target);
    result_.fault = text::DiagnosticId::angle_unsolved;
    result_.reason = reason;
    result_.detail = detail;
  }

  void wait() {
    PendingLine line{.active = true, .angle_deg = angle(), .unknown_before = state_.unknown};
    for (const Address corner : kCornerWords) {
      if (!block_.has(corner)) continue;
      line.corner = bit_of(corner);
      line.corner_value = rules_.length_mm(block_, corner, state_.modes.inch);
    }
    state_.line = line;
    state_.unknown |= static_cast<std::uint16_t>(1U << axes_.p | 1U << axes_.q);
  }

  void go(const PlainBlock& block, const Target& target) {
    Mover(block, rules_, options_, state_, out_, result_).straight(MotionKind::linear, target);
  }

  void both_ends(const Target& target) {
    const PlanePoint from = point_of(state_.position);
    const PlanePoint to = point_of(target.end);
    const PlanePoint chord{to.p - from.p, to.q - from.q};
    const PlanePoint wanted = direction_of(angle());
    const double across = chord.p * wanted.q - chord.q * wanted.p;
    if (std::abs(across) > kSameDirection * length_of(chord))
      return fail(target, "the end does not lie on the line", ir::AlarmDetail::not_an_end);
    go(block_, target);
  }

  void one_end(Target target, bool p) {
    const PlanePoint from = point_of(state_.position);
    const PlanePoint to = point_of(target.end);
    const PlanePoint direction = direction_of(angle());
    const double run = p ? direction.p : direction.q;
    const double named = p ? to.p - from.p : to.q - from.q;
    if (std::abs(run) < kParallel) return fail(target, "the line never reaches the coordinate", ir::AlarmDetail::none);
    const double other = named / run * (p ? direction.q : direction.p);
    const std::size_t axis = p ? axes_.q : axes_.p;
    target.end[axis] = ((p ? from.q : from.p) + other) * factor(axis);
    target.commanded |= static_cast<std::uint16_t>(1U << axis);
    go(block_, target);
  }

  // Where the line from the start meets the one that ends at the target.
  void two_lines(const PendingLine& first, const Target& target) {
    const PlanePoint from = point_of(state_.position);
    const PlanePoint to = point_of(target.end);
    const PlanePoint a = direction_of(first.angle_deg);
    const PlanePoint b = direction_of(angle());
    const double turn = a.p * b.q - a.q * b.p;
    if (std::abs(turn) < kParallel) return fail(target, "the two lines are parallel", ir::AlarmDetail::none);
    const double along = ((to.p - from.p) * b.q - (to.q - from.q) * b.p) / turn;
    Target meeting{.end = state_.position};
    meeting.end[axes_.p] = (from.p + along * a.p) * factor(axes_.p);
    meeting.end[axes_.q] = (from.q + along * a.q) * factor(axes_.q);
    meeting.commanded = static_cast<std::uint16_t>(1U << axes_.p | 1U << axes_.q);
    PlainBlock earlier = block_;
    earlier.present &= ~kCorners;
    earlier.in_increments &= ~kCorners;
    if (first.corner != 0) {
      // length_mm turns the word's inches into mm; the kept value is in mm already.
      const double written = state_.modes.inch ? first.corner_value / 25.4 : first.corner_value;
      earlier.set(static_cast<Address>(std::countr_zero(first.corner)), written);
    }
    go(earlier, meeting);
    go(block_, target);
  }

  const PlainBlock& block_;
  const BlockRules& rules_;
  const MoveOptions& options_;
  ModalState& state_;
  MotionBuffer& out_;
  BlockResult& result_;
  PlaneAxes axes_;
};

}  // namespace

bool is_direct_line(const PlainBlock& block, const ModalState& state) {
  return ((block.present | block.unknown) & kAngle) != 0 || state.line.active;
}

void move_direct(const PlainBlock& block, const BlockRules& rules, const MoveOptions& options, ModalState& state,
                 MotionBuffer& out, BlockResult& result) {
  DirectLine(block, rules, options, state, out, result).run();
}

}  // namespace dripfeed::interpreter
