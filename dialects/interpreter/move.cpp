// Axis words become end points, end points become moves.
#include "dialects/interpreter/move.h"

#include <bit>

#include "dialects/interpreter/arc.h"

namespace dripfeed::interpreter {

namespace {

using ir::Address;
using ir::Function;
using ir::MotionKind;

// Where the axis words of a block lead.
struct Target {
  AxisValues end{};
  std::uint16_t commanded = 0;    // bit per axis
  std::uint16_t incremental = 0;  // … by an increment
  std::uint16_t unknown = 0;      // named with a value that is not known
};

// Calls visit(axis, value, incremental) for each axis word that is there: mm or degrees, as programmed but for the
// diameter, which becomes what is kept.
template <class Visit>
void for_each_axis_word(const PlainBlock& block, const BlockRules& rules, const Modes& modes, bool modal_incremental,
                        Visit visit) {
  for (std::uint64_t rest = block.present & rules.axis_addresses; rest != 0; rest &= rest - 1) {
    const auto address = static_cast<Address>(std::countr_zero(rest));
    const AxisWord& word = rules.axis_words[index_of(address)];
    const bool by_mode = (block.absolute & bit_of(address)) == 0 && modal_incremental;
    const bool incremental = word.incremental || by_mode || (block.incremental & bit_of(address)) != 0;
    double value = word.rotary ? rules.angle_deg(block, address) : rules.length_mm(block, address, modes.inch);
    if (word.axis == ir::Axis::x) value *= rules.x_factor(modes, incremental);
    visit(index_of(word.axis), value, incremental);
  }
}

Target find_target(const PlainBlock& block, const BlockRules& rules, const ModalState& state, bool machine) {
  Target target{.end = state.position};
  for_each_axis_word(block, rules, state.modes, !state.modes.absolute && !machine,
                     [&](std::size_t axis, double value, bool incremental) {
                       const auto bit = static_cast<std::uint16_t>(1U << axis);
                       target.commanded |= bit;
                       if (machine) {
                         target.end[axis] = value;
                       } else if (incremental) {
                         target.end[axis] = state.position[axis] + value;
                         target.incremental |= bit;
                       } else {
                         target.end[axis] = value + state.modes.shift[axis] + state.coordinate_shift[axis];
                       }
                     });
  for (std::uint64_t rest = block.unknown & rules.axis_addresses; rest != 0; rest &= rest - 1)
    target.unknown |= static_cast<std::uint16_t>(
        1U << index_of(rules.axis_words[static_cast<std::size_t>(std::countr_zero(rest))].axis));
  return target;
}

// The plane's axes as indices: p, q and the one that stands on it.
struct PlaneAxes {
  std::size_t p;
  std::size_t q;
  std::size_t normal;
};
constexpr PlaneAxes axes_of(ir::Plane plane) {
  if (plane == ir::Plane::zx) return {2, 0, 1};
  return plane == ir::Plane::yz ? PlaneAxes{1, 2, 0} : PlaneAxes{0, 1, 2};
}
constexpr std::array kCenterAddresses = {Address::i, Address::j, Address::k};

class Mover {
 public:
  Mover(const PlainBlock& block, const BlockRules& rules, const MoveOptions& options, ModalState& state,
        MotionBuffer& out, BlockResult& result)
      : block_(block), rules_(rules), options_(options), state_(state), out_(out), result_(result) {}

  void straight(MotionKind kind, const Target& target) {
    const double feed = kind == MotionKind::rapid ? 0.0 : kind == MotionKind::thread ? lead() : state_.feed;
    emit(kind, target, feed);
  }

  void arc(MotionKind kind, Target target) {
    const PlaneAxes axes = axes_of(state_.modes.plane);
    if (has_unknown_parts(target)) return lose(target);
    const Turn turn = kind == MotionKind::arc_ccw ? Turn::counterclockwise : Turn::clockwise;
    const std::optional<PlanePoint> center = find_center(axes, turn, target);
    if (!center.has_value()) return starts_unknown(axes) ? lose(target) : void();
    const PlanePoint to_end = chord(axes, target);
    const double start_radius = length_of(*center);
    const double end_radius = length_of({to_end.p - center->p, to_end.q - center->q});
    const bool fits = std::abs(start_radius - end_radius) <= rules_.semantics.arc_tolerance_mm;
    if (!fits && starts_unknown(axes)) return lose(target);
    if (!fits) return fail(text::DiagnosticId::arc_radius_mismatch, start_radius, end_radius);
    if (block_.has(Address::turns) && block_.at(Address::turns) >= 1.0)
      emit_turns(kind, axes, *center, opening_of(*center, to_end, turn), target);
    emit_arc(kind, axes, *center, target);
  }

 private:
  // Whether a word that the arc is made of has a value that is not known.
  [[nodiscard]] bool has_unknown_parts(const Target& target) const {
    constexpr std::uint64_t kParts = bit_of(Address::i) | bit_of(Address::j) | bit_of(Address::k) |
                                     bit_of(Address::r) | bit_of(Address::arc_radius) |
                                     bit_of(Address::opening_angle) | bit_of(Address::turns);
    return target.unknown != 0 || (block_.unknown & kParts) != 0;
  }
  [[nodiscard]] bool starts_unknown(PlaneAxes axes) const {
    return ((state_.unknown >> axes.p | state_.unknown >> axes.q) & 1U) != 0;
  }
  // No arc can be said, but where it ends may be known.
  void lose(const Target& target) {
    result_ = {};
    result_.notes |= kNoteArcNotComputed;
    settle(target);
  }

  // End minus start in the plane, radius values.
  [[nodiscard]] PlanePoint chord(PlaneAxes axes, const Target& target) const {
    return {radius_of(axes.p, target.end[axes.p] - state_.position[axes.p]),
            radius_of(axes.q, target.end[axes.q] - state_.position[axes.q])};
  }
  [[nodiscard]] double radius_of(std::size_t axis, double value) const {
    return axis == 0 && rules_.x_is_diameter ? value / 2.0 : value;
  }
  [[nodiscard]] double kept_of(std::size_t axis, double value) const {
    return axis == 0 && rules_.x_is_diameter ? value * 2.0 : value;
  }

  // By radius, by opening angle, or by I J K; sets the fault and gives nothing when there is none.
  std::optional<PlanePoint> find_center(PlaneAxes axes, Turn turn, Target& target) {
    const Address radius_address = rules_.semantics.arc_radius_is_r ? Address::r : Address::arc_radius;
    const double tolerance = rules_.semantics.arc_tolerance_mm;
    const PlanePoint to_end = chord(axes, target);
    std::optional<double> radius;
    if (block_.has(radius_address)) {
      radius = rules_.length_mm(block_, radius_address, state_.modes.inch);
    } else if (!has_center()) {
      if (block_.has(Address::opening_angle))
        radius = radius_by_opening(length_of(to_end), block_.at(Address::opening_angle));
      if (!radius.has_value()) return fail_center(text::DiagnosticId::arc_without_center, 0.0, 0.0);
    }
    if (radius.has_value()) {
      const auto center = center_by_radius(to_end, *radius, turn, tolerance);
      return center.has_value() ? center
                                : fail_center(text::DiagnosticId::arc_radius_mismatch, std::abs(*radius),
                                              length_of(to_end) - std::abs(*radius));
    }
    const PlanePoint center{center_word(axes.p), center_word(axes.q)};
    if (block_.has(Address::opening_angle)) end_by_angle(axes, center, turn, target);
    return center;
  }
  [[nodiscard]] bool has_center() const {
    return (block_.present & (bit_of(Address::i) | bit_of(Address::j) | bit_of(Address::k))) != 0;
  }
  // I, J or K as centre minus start; a position (I=AC) is a coordinate of its axis, so a diameter on such an axis.
  [[nodiscard]] double center_word(std::size_t axis) const {
    const Address address = kCenterAddresses[axis];
    if (!block_.has(address)) return 0.0;
    const double value = rules_.length_mm(block_, address, state_.modes.inch);
    if ((block_.absolute & bit_of(address)) == 0) return value;
    const double kept = axis == 0 ? value * rules_.x_factor(state_.modes, false) : value;
    return radius_of(axis, kept + state_.modes.shift[axis] + state_.coordinate_shift[axis] - state_.position[axis]);
  }
  void end_by_angle(PlaneAxes axes, PlanePoint center, Turn turn, Target& target) {
    const PlanePoint end = end_by_opening(center, block_.at(Address::opening_angle), turn);
    target.end[axes.p] = state_.position[axes.p] + kept_of(axes.p, end.p);
    target.end[axes.q] = state_.position[axes.q] + kept_of(axes.q, end.q);
    target.commanded |= static_cast<std::uint16_t>((1U << axes.p) | (1U << axes.q));
  }

  // TURN=n: n full circles before the arc; every axis outside the plane advances in proportion to the angle.
  void emit_turns(MotionKind kind, PlaneAxes axes, PlanePoint center, double opening_deg, const Target& target) {
    const auto turns = static_cast<std::uint32_t>(std::min(block_.at(Address::turns), 999.0));
    const double total_deg = opening_deg + 360.0 * turns;
    const AxisValues start = state_.position;
    for (std::uint32_t i = 1; i <= turns; ++i) {
      Target part = target;
      for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis) {
        const bool in_plane = axis == axes.p || axis == axes.q;
        part.end[axis] =
            in_plane ? start[axis] : start[axis] + (target.end[axis] - start[axis]) * 360.0 * i / total_deg;
      }
      emit_arc(kind, axes, center, part);
    }
  }

  void emit_arc(MotionKind kind, PlaneAxes axes, PlanePoint center, const Target& target) {
    ir::Motion& motion = emit(kind, target, state_.feed);
    motion.center[axes.p] = center.p;
    motion.center[axes.q] = center.q;
  }

  // Of a thread: K, I or J where one is given, otherwise F.
  [[nodiscard]] double lead() const {
    for (const Address address : {Address::k, Address::i, Address::j})
      if (block_.has(address)) return rules_.length_mm(block_, address, state_.modes.inch);
    return state_.feed;
  }

  ir::Motion& emit(MotionKind kind, const Target& target, double feed) {
    ir::Motion& motion = out_.add(kind);
    fill_common(motion, state_);
    motion.end = target.end;
    motion.feed = feed;
    if (kind == MotionKind::thread) motion.feed_mode = ir::FeedMode::per_rev;
    motion.axes_commanded = target.commanded;
    motion.axes_unknown = state_.unknown | target.unknown;
    motion.machine_coordinates = options_.machine_coordinates;
    motion.exact_stop = options_.exact_stop || state_.modes.exact_stop;
    if (kind != MotionKind::rapid && feed == 0.0 && !state_.feed_unknown) result_.notes |= kNoteNoFeed;
    settle(target);
    return motion;
  }

  // After a move in machine coordinates the place in the work offset is not known; an increment from an unknown place
  // ends at one.
  void settle(const Target& target) {
    if (options_.machine_coordinates) {
      state_.unknown |= target.commanded;
      return;
    }
    if ((state_.unknown & target.incremental) != 0) result_.notes |= kNoteIncrementalFromUnknown;
    state_.unknown &= static_cast<std::uint16_t>(~(target.commanded & ~target.incremental));
    state_.unknown |= target.unknown;
    state_.position = target.end;
  }

  void fail(text::DiagnosticId id, double first, double second) {
    result_.fault = id;
    result_.first = first;
    result_.second = second;
  }
  std::optional<PlanePoint> fail_center(text::DiagnosticId id, double first, double second) {
    fail(id, first, second);
    return std::nullopt;
  }

  const PlainBlock& block_;
  const BlockRules& rules_;
  const MoveOptions& options_;
  ModalState& state_;
  MotionBuffer& out_;
  BlockResult& result_;
};

}  // namespace

void fill_common(ir::Motion& motion, const ModalState& state) {
  motion.plane = state.modes.plane;
  motion.feed_mode = state.modes.feed_mode;
  motion.start = state.position;
  motion.end = state.position;
  motion.spindle = state.spindle;
  motion.spindle_rpm = state.modes.surface_speed ? state.spindle_limit_rpm : state.rpm;
  motion.surface_speed_m_min = state.modes.surface_speed ? state.surface_speed_m_min : 0.0;
  motion.comp = state.modes.comp;
  motion.coolant = state.coolant;
}

void move(const PlainBlock& block, const BlockRules& rules, const MoveOptions& options, ModalState& state,
          MotionBuffer& out, BlockResult& result) {
  const Target target = find_target(block, rules, state, options.machine_coordinates);
  if (!state.modes.motion_modelled) {
    result.notes |= kNoteMoveNotModelled;
    state.unknown |= target.commanded;
    return;
  }
  if (!state.modes.motion_given) {
    result.notes |= kNoteMotionWithoutCode;
    state.modes.motion_given = true;  // said once
  }
  Mover mover(block, rules, options, state, out, result);
  const Function motion = state.modes.motion;
  if (motion == Function::arc_cw || motion == Function::arc_ccw)
    return mover.arc(motion == Function::arc_cw ? MotionKind::arc_cw : MotionKind::arc_ccw, target);
  mover.straight(motion == Function::linear   ? MotionKind::linear
                 : motion == Function::thread ? MotionKind::thread
                                              : MotionKind::rapid,
                 target);
}

void return_to_reference(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out,
                         BlockResult& result) {
  const Target target = find_target(block, rules, state, false);
  const auto absolute = static_cast<std::uint16_t>(target.commanded & ~target.incremental);
  // An increment of nothing (G91 G28 Z0) names the axis only: there is no move to the intermediate point.
  if (target.end != state.position || (state.unknown & absolute) != 0)
    Mover(block, rules, {}, state, out, result).straight(MotionKind::rapid, target);
  result.notes &= ~kNoteIncrementalFromUnknown;
  result.notes |= kNoteReferenceUnknown;
  forget_positions(block, rules, state);
}

void forget_positions(const PlainBlock& block, const BlockRules& rules, ModalState& state) {
  for (std::uint64_t rest = (block.present | block.numbered | block.unknown) & rules.axis_addresses; rest != 0; rest &= rest - 1)
    state.unknown |= static_cast<std::uint16_t>(
        1U << index_of(rules.axis_words[static_cast<std::size_t>(std::countr_zero(rest))].axis));
}

void shift_locally(const PlainBlock& block, const BlockRules& rules, bool whole, bool add, ModalState& state) {
  if (!add && (whole || (block.present & rules.axis_addresses) == 0)) state.modes.shift = {};
  for_each_axis_word(block, rules, state.modes, false, [&](std::size_t axis, double value, bool incremental) {
    state.modes.shift[axis] = add || incremental ? state.modes.shift[axis] + value : value;
  });
}

void set_coordinates(const PlainBlock& block, const BlockRules& rules, ModalState& state) {
  for_each_axis_word(block, rules, state.modes, false, [&](std::size_t axis, double value, bool incremental) {
    const auto bit = static_cast<std::uint16_t>(1U << axis);
    if (incremental) {
      state.coordinate_shift[axis] -= value;
    } else if ((state.unknown & bit) != 0) {
      state.position[axis] = value + state.modes.shift[axis];
      state.coordinate_shift[axis] = 0.0;
      state.unknown &= static_cast<std::uint16_t>(~bit);
    } else {
      state.coordinate_shift[axis] = state.position[axis] - value - state.modes.shift[axis];
    }
  });
}

}  // namespace dripfeed::interpreter
