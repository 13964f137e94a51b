// A hole, seen along the drilling axis (the plane's normal; X for lathe cycles from the side):
//
//   initial ----+------------------------+---- G98 ends here
//               | rapid                  | rapid
//   R ----------+---+--------------------+---- G99 ends here
//                   | feed, in one or by pecks
//   depth ----------+ dwell, reverse, stop or shift; then back by rapid or feed
//
// Back boring goes in reverse: rapid down to R next to the hole, feed up to the depth, rapid up to the initial
// level. (Fanuc 0i-F B-64604EN-2, canned cycle for drilling; lathes B-64604EN-1.)
#include "dialects/interpreter/cycles/drilling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "dialects/interpreter/motion/events.h"
#include "dialects/interpreter/motion/move.h"
#include "dialects/interpreter/motion/polar.h"
#include "dialects/interpreter/state/axis_words.h"
#include "dialects/ir/clear_cycle.h"

namespace dripfeed::interpreter {

namespace {

using ir::Address;
using ir::DrillCycle;
using ir::MotionKind;
using ir::SpindleState;

enum class Advance : std::uint8_t { once, break_chips, clear_chips, from_below };
enum class Bottom : std::uint8_t { nothing, reverse, stop, hold, shift };
enum class Retreat : std::uint8_t { rapid, feed };

struct CycleRow {
  Advance advance;
  bool dwells;
  Bottom bottom;
  Retreat retreat;
};
// In the order of DrillCycle.
constexpr auto kCycles = std::to_array<CycleRow>({
    {Advance::once, false, Bottom::nothing, Retreat::rapid},        // drill
    {Advance::once, true, Bottom::nothing, Retreat::rapid},         // drill_dwell
    {Advance::clear_chips, true, Bottom::nothing, Retreat::rapid},  // deep_hole
    {Advance::break_chips, true, Bottom::nothing, Retreat::rapid},  // chip_break
    {Advance::once, true, Bottom::reverse, Retreat::feed},          // tap_right
    {Advance::once, true, Bottom::reverse, Retreat::feed},          // tap_left
    {Advance::once, false, Bottom::nothing, Retreat::feed},         // feed_out
    {Advance::once, true, Bottom::nothing, Retreat::feed},          // feed_out_dwell
    {Advance::once, false, Bottom::stop, Retreat::rapid},           // stop_out
    {Advance::once, true, Bottom::hold, Retreat::rapid},            // manual_out
    {Advance::once, true, Bottom::shift, Retreat::rapid},           // fine_bore
    {Advance::from_below, true, Bottom::shift, Retreat::rapid},     // back_bore
});
static_assert(kCycles.size() == static_cast<std::size_t>(DrillCycle::count_));

constexpr double kStepsAtMost = 1'000'000.0;  // pecks of all holes of a block

class Driller {
 public:
  Driller(const PlainBlock& block, const PlainBlock* letters, const BlockRules& rules, ModalState& state,
          MotionBuffer& out, BlockResult& result)
      : block_(block),
        letters_(letters),
        rules_(rules),
        state_(state),
        out_(out),
        result_(result),
        d_(state.drilling),
        row_(kCycles[static_cast<std::size_t>(d_.cycle)]),
        plane_(axes_of(state.modes.plane)),
        axis_(d_.along == ir::kDrillAlongX   ? 0
              : d_.along == ir::kDrillAlongZ ? 2
                                             : plane_.normal) {}

  void run() {
    if (!d_.entered || d_.axis != axis_) enter();
    take_words();
    if ((block_.present & (rules_.axis_addresses | bit_of(Address::r))) == 0) return;
    if (is_axis_changed()) {
      result_.notes |= kNoteCycleInFrame;
      state_.unknown |= 7U;
      return;
    }
    const double holes = repeats();
    if (pecks() && d_.peck_mm <= 0.0 && rules_.semantics.pecks_need_depth)
      return fail(text::DiagnosticId::peck_without_depth);
    if (holes * pecks_of_a_hole() > kStepsAtMost) return fail(text::DiagnosticId::limit_reached);
    for (double n = 1.0; n <= holes && result_.fault == text::DiagnosticId::count_; ++n) {
      if (n > 1.0 && letters_ != nullptr) place_ = with_coordinates_of_letters(*letters_, rules_, state_);
      hole(place_ ? *place_ : block_);
    }
  }

 private:
  // The cycle begins, or goes on along another axis.
  void enter() {
    d_ = {.active = true,
          .entered = true,
          .axis = static_cast<std::uint8_t>(axis_),
          .cycle = d_.cycle,
          .along = d_.along,
          .initial = state_.position[axis_],
          .initial_known = (state_.unknown >> axis_ & 1U) == 0};
  }

  // Whether a frame turns, mirrors or stretches the drilling axis.
  [[nodiscard]] bool is_axis_changed() const {
    if (!state_.modes.has_matrix) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      const double wanted = i == axis_ ? 1.0 : 0.0;
      if (std::abs(state_.modes.matrix[axis_ * 3 + i] - wanted) > 1e-12) return true;
      if (std::abs(state_.modes.matrix[i * 3 + axis_] - wanted) > 1e-12) return true;
    }
    return false;
  }

  // --- words

  void take_words() {
    for_each_axis_word(block_, rules_, state_.modes, !state_.modes.absolute,
                       [&](std::size_t axis, double value, bool incremental) {
                         if (axis != axis_) return;
                         d_.depth = incremental ? value : value + origin();
                         d_.has_depth = true;
                         d_.depth_by_distance = incremental;
                       });
    const bool inch = state_.modes.inch;
    if (block_.has(Address::r)) {
      d_.r_by_distance = !state_.modes.absolute || rules_.semantics.drill_r_from_initial;
      const double r = rules_.length_mm(block_, Address::r, inch) * (axis_ == 0 && rules_.x_is_diameter ? 2.0 : 1.0);
      d_.r = d_.r_by_distance ? r : r + origin();
      d_.has_r = true;
    }
    if (block_.has(Address::q)) d_.peck_mm = std::abs(rules_.length_mm(block_, Address::q, inch));
    if (block_.has(Address::p)) d_.dwell_s = block_.at(Address::p) / 1000.0;
    // The Z feed per turn of the spindle, in G94 too (Mitsubishi M800 programming manual, "Synchronous tapping").
    if (row_.bottom == Bottom::reverse && block_.has(Address::rounding))
      d_.by_lead = block_.at(Address::rounding) == 1.0;
    if (row_.bottom != Bottom::shift) return;
    constexpr std::array kShiftWords = {Address::i, Address::j, Address::k};
    const bool by_words = block_.has(kShiftWords[plane_.p]) || block_.has(kShiftWords[plane_.q]);
    if (by_words) {
      d_.shift_p_mm = block_.has(kShiftWords[plane_.p]) ? rules_.length_mm(block_, kShiftWords[plane_.p], inch) : 0.0;
      d_.shift_q_mm = block_.has(kShiftWords[plane_.q]) ? rules_.length_mm(block_, kShiftWords[plane_.q], inch) : 0.0;
    } else if (block_.has(Address::q)) {
      d_.shift_p_mm = d_.peck_mm;  // the direction is a parameter; + of the first axis is usual
      d_.shift_q_mm = 0.0;
    }
  }
  // What an absolute coordinate of the drilling axis is counted from.
  [[nodiscard]] double origin() const { return state_.modes.shift[axis_] + state_.coordinate_shift[axis_]; }
  // L, or K where it is no shift; none: one hole.
  [[nodiscard]] double repeats() const {
    const bool k_is_shift = row_.bottom == Bottom::shift && state_.modes.plane != ir::Plane::xy;
    if (block_.has(Address::l)) return std::floor(block_.at(Address::l));
    return block_.has(Address::k) && !k_is_shift ? std::floor(block_.at(Address::k)) : 1.0;
  }

  // --- levels

  [[nodiscard]] double r_level() const {
    if (!d_.has_r) return d_.initial;
    return d_.r_by_distance ? d_.initial + d_.r : d_.r;
  }
  [[nodiscard]] bool keeps_clear() const { return d_.along == ir::kDrillKeepsClear; }
  // Where G98 ends.
  [[nodiscard]] double clear_level() const { return keeps_clear() ? std::max(d_.initial, r_level()) : d_.initial; }
  [[nodiscard]] double bottom() const { return d_.depth_by_distance ? r_level() + d_.depth : d_.depth; }
  [[nodiscard]] bool r_known() const { return d_.initial_known || (d_.has_r && !d_.r_by_distance); }
  [[nodiscard]] bool bottom_known() const { return !d_.depth_by_distance || r_known(); }
  [[nodiscard]] bool pecks() const {
    return row_.advance == Advance::break_chips || row_.advance == Advance::clear_chips;
  }
  [[nodiscard]] double pecks_of_a_hole() const {
    const double peck = kept(d_.peck_mm);
    return pecks() && peck > 0.0 ? std::ceil(std::abs(bottom() - r_level()) / peck) + 1.0 : 1.0;
  }
  // Millimetres along the axis as it is kept.
  [[nodiscard]] double kept(double length_mm) const {
    return axis_ == 0 && rules_.x_is_diameter ? length_mm * 2.0 : length_mm;
  }

  // --- one hole

  // `place`: the block whose words say where.
  void hole(const PlainBlock& place) {
    if (keeps_clear() && d_.initial < r_level()) rapid(r_level(), r_known());
    position(place);
    if (!d_.has_depth) {
      result_.notes |= kNoteHoleWithoutDepth;
      return;
    }
    if (row_.advance == Advance::from_below) return bore_back();
    const SpindleState before = state_.spindle;
    if (row_.bottom == Bottom::reverse) turn(cutting_direction());
    rapid(r_level(), r_known());
    advance();
    if (row_.dwells && d_.dwell_s > 0.0) dwell();
    if (row_.bottom == Bottom::reverse) turn(opposite(cutting_direction()));
    if (row_.bottom == Bottom::stop || row_.bottom == Bottom::hold || row_.bottom == Bottom::shift)
      turn(SpindleState::stopped);
    if (row_.bottom == Bottom::hold) emit_event(MotionKind::stop, state_, out_).number = 0;
    if (row_.bottom == Bottom::shift) shift(1.0);
    if (row_.retreat == Retreat::feed && keeps_clear())
      feed(state_.modes.return_to_r ? r_level() : clear_level(), r_known());
    else if (row_.retreat == Retreat::feed)
      feed(r_level(), r_known());
    go_back();
    if (row_.bottom == Bottom::shift) shift(-1.0);
    turn(before);
  }

  // The axes other than the drilling axis, all at once.
  void position(const PlainBlock& place) {
    const auto own = static_cast<std::uint16_t>(1U << axis_);
    Target target = find_any_target(place, rules_, state_, false);
    target.end[axis_] = state_.position[axis_];
    target.commanded &= static_cast<std::uint16_t>(~own);
    target.incremental &= static_cast<std::uint16_t>(~own);
    target.unknown &= static_cast<std::uint16_t>(~own);
    go(MotionKind::rapid, target);
  }

  // From the R level to the bottom. The sign of a peck is the direction's.
  void advance() {
    const double begin = r_level();
    const double end = bottom();
    const double length = std::abs(end - begin);
    const double peck = kept(d_.peck_mm);
    if (!pecks() || peck <= 0.0 || peck >= length) return feed(end, bottom_known());
    const double sign = end > begin ? 1.0 : -1.0;
    const auto count = static_cast<std::uint32_t>(std::ceil(length / peck - 1e-9));
    for (std::uint32_t n = 1; n < count; ++n) {
      const double depth = begin + sign * peck * n;
      feed(depth, bottom_known());
      if (row_.advance == Advance::break_chips) {
        rapid(depth - sign * std::min(kept(rules_.semantics.chip_break_retract_mm), peck * n), bottom_known());
      } else {
        rapid(begin, r_known());
        rapid(depth - sign * std::min(kept(rules_.semantics.peck_clearance_mm), peck * n), bottom_known());
      }
    }
    feed(end, bottom_known());
  }

  void bore_back() {
    const SpindleState before = state_.spindle == SpindleState::stopped ? SpindleState::clockwise : state_.spindle;
    turn(SpindleState::stopped);
    shift(1.0);
    rapid(r_level(), r_known());
    shift(-1.0);
    turn(before);
    feed(bottom(), bottom_known());
    if (d_.dwell_s > 0.0) dwell();
    turn(SpindleState::stopped);
    shift(1.0);
    return_to_initial();
    shift(-1.0);
    turn(before);
  }

  void go_back() {
    if (state_.modes.return_to_r) return rapid(r_level(), r_known());
    return_to_initial();
  }
  void return_to_initial() {
    if (d_.initial_known) return rapid(clear_level(), true);
    result_.notes |= kNoteLevelUnknown;
    state_.unknown |= static_cast<std::uint16_t>(1U << axis_);
  }

  // --- motions and events

  void rapid(double level, bool known) { along(MotionKind::rapid, level, known); }
  void feed(double level, bool known) { along(d_.by_lead ? MotionKind::thread : MotionKind::linear, level, known); }
  void along(MotionKind kind, double level, bool known) {
    const auto bit = static_cast<std::uint16_t>(1U << axis_);
    Target target{.end = state_.position, .commanded = bit, .incremental = known ? std::uint16_t{0} : bit};
    target.end[axis_] = level;
    go(kind, target);
  }
  void shift(double sign) {
    Target target{.end = state_.position};
    target.commanded = target.incremental = static_cast<std::uint16_t>(1U << plane_.p | 1U << plane_.q);
    target.end[plane_.p] += sign * d_.shift_p_mm;
    target.end[plane_.q] += sign * d_.shift_q_mm;
    go(MotionKind::rapid, target);
  }
  // A move of no length from a known place is none.
  void go(MotionKind kind, const Target& target) {
    if (target.commanded == 0 || result_.fault != text::DiagnosticId::count_) return;
    if (target.end == state_.position && (state_.unknown & target.commanded & ~target.incremental) == 0) return;
    emit_move(kind, target, kind == MotionKind::rapid ? 0.0 : state_.feed, {}, state_, out_, result_);
  }
  void dwell() { emit_event(MotionKind::dwell, state_, out_).feed = d_.dwell_s; }
  void turn(SpindleState to) {
    if (state_.spindle == to) return;
    state_.spindle = to;
    announce(state_, out_);
  }
  [[nodiscard]] SpindleState cutting_direction() const {
    return d_.cycle == DrillCycle::tap_left ? SpindleState::counterclockwise : SpindleState::clockwise;
  }
  static SpindleState opposite(SpindleState state) {
    return state == SpindleState::clockwise ? SpindleState::counterclockwise : SpindleState::clockwise;
  }
  void fail(text::DiagnosticId id) { result_.fault = id; }

  const PlainBlock& block_;
  const PlainBlock* letters_;
  std::optional<PlainBlock> place_;  // of a hole that is not the first
  const BlockRules& rules_;
  ModalState& state_;
  MotionBuffer& out_;
  BlockResult& result_;
  Drilling& d_;
  const CycleRow& row_;
  PlaneAxes plane_;
  std::size_t axis_;
};

}  // namespace

void begin_drilling(std::int16_t argument, ModalState& state) {
  state.drilling.active = true;
  state.drilling.along = argument >= ir::kDrillKeepsClear ? ir::kDrillKeepsClear
                         : argument >= ir::kDrillAlongX   ? ir::kDrillAlongX
                         : argument >= ir::kDrillAlongZ   ? ir::kDrillAlongZ
                                                          : std::int16_t{0};
  state.drilling.cycle = static_cast<DrillCycle>(argument - state.drilling.along);
}

void drill_holes(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out,
                 BlockResult& result, const PlainBlock* letters) {
  Driller(block, letters, rules, state, out, result).run();
}

}  // namespace dripfeed::interpreter
