// Axis words become end points, end points become moves.
#include "dialects/interpreter/move.h"

#include <bit>

#include "dialects/interpreter/arc.h"
#include "dialects/interpreter/corner.h"
#include "dialects/interpreter/polar.h"

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

// Under a frame that turns, the words name programmed coordinates; those that are not named stay as they are there. A
// coordinate that is not known makes every axis unknown that it is mixed into.
Target find_target_in_frame(const PlainBlock& block, const BlockRules& rules, const ModalState& state) {
  Target target{.end = state.position};
  Vector programmed = programmed_position(rules, state);
  const Matrix back = inverse_of(state.modes.matrix);
  const auto mixed = [](const Matrix& m, std::uint32_t unknown) {
    std::uint32_t out = 0;
    for (std::uint32_t row = 0; row < 3; ++row)
      for (std::uint32_t column = 0; column < 3; ++column)
        if ((unknown >> column & 1U) != 0 && std::abs(m[row * 3 + column]) > 1e-12) out |= 1U << row;
    return out;
  };
  std::uint32_t unknown = mixed(back, state.unknown & 7U);
  bool turned = false;
  for_each_axis_word(
      block, rules, state.modes, !state.modes.absolute, [&](std::size_t axis, double value, bool incremental) {
        const auto bit = static_cast<std::uint16_t>(1U << axis);
        if (axis < 3) {
          const double radius = axis == 0 && rules.x_is_diameter ? value / 2.0 : value;
          programmed[axis] = incremental ? programmed[axis] + radius : radius;
          if (!incremental) unknown &= ~std::uint32_t{bit};
          turned = true;
          return;
        }
        target.commanded |= bit;
        if (incremental) target.incremental |= bit;
        target.end[axis] =
            incremental ? state.position[axis] + value : value + state.modes.shift[axis] + state.coordinate_shift[axis];
      });
  for (std::uint64_t rest = block.unknown & rules.axis_addresses; rest != 0; rest &= rest - 1)
    unknown |= 1U << index_of(rules.axis_words[static_cast<std::size_t>(std::countr_zero(rest))].axis);
  if (!turned && (unknown & 7U) == 0) return target;
  const Vector at = multiply(state.modes.matrix, programmed);
  target.unknown = static_cast<std::uint16_t>(mixed(state.modes.matrix, unknown & 7U) | (unknown & ~7U));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double kept = (axis == 0 && rules.x_is_diameter ? 2.0 : 1.0) * at[axis] + state.modes.shift[axis] +
                        state.coordinate_shift[axis];
    const auto bit = static_cast<std::uint16_t>(1U << axis);
    if ((target.unknown & bit) != 0 || kept == target.end[axis]) continue;
    target.end[axis] = kept;
    target.commanded |= bit;
  }
  return target;
}

constexpr std::array kCenterAddresses = {Address::i, Address::j, Address::k};

class Mover {
 public:
  Mover(const PlainBlock& block, const BlockRules& rules, const MoveOptions& options, ModalState& state,
        MotionBuffer& out, BlockResult& result)
      : block_(block), rules_(rules), options_(options), state_(state), out_(out), result_(result) {}

  void straight(MotionKind kind, const Target& target) {
    const double feed = kind == MotionKind::rapid ? 0.0 : kind == MotionKind::thread ? lead() : state_.feed;
    const AxisValues start = state_.position;
    emit(kind, target, feed);
    if (kind != MotionKind::linear) {
      state_.tangent_known = false;
      if (has_corner_word()) result_.notes |= kNoteCornerNotComputed;
      return drop_corner();
    }
    for (std::size_t axis = 0; axis < 3; ++axis) state_.tangent[axis] = radius_of(axis, target.end[axis] - start[axis]);
    state_.tangent_known = (state_.unknown & 7U) == 0;
    finish_corner();
  }

  // CIP: through the point that I1 J1 K1 name.
  void arc_via(Target target) {
    const PlaneAxes axes = axes_of(state_.modes.plane);
    constexpr std::array kVia = {Address::via_i, Address::via_j, Address::via_k};
    const bool known =
        !starts_unknown(axes) && target.unknown == 0 &&
        (block_.unknown & (bit_of(Address::via_i) | bit_of(Address::via_j) | bit_of(Address::via_k))) == 0;
    if (!known) return lose(target);
    if (state_.modes.has_matrix) return lose(target, kNoteArcInFrame);
    AxisValues via = state_.position;
    for (std::size_t axis = 0; axis < kVia.size(); ++axis) {
      if (!block_.has(kVia[axis])) continue;
      const bool absolute = (block_.absolute & bit_of(kVia[axis])) != 0;
      const bool adds = !absolute && (!state_.modes.absolute || (block_.incremental & bit_of(kVia[axis])) != 0);
      double value = rules_.length_mm(block_, kVia[axis], state_.modes.inch);
      if (axis == 0) value *= rules_.x_factor(state_.modes, adds);
      via[axis] =
          adds ? state_.position[axis] + value : value + state_.modes.shift[axis] + state_.coordinate_shift[axis];
    }
    const bool tilted = std::abs(via[axes.normal] - state_.position[axes.normal]) > 1e-9 ||
                        std::abs(target.end[axes.normal] - state_.position[axes.normal]) > 1e-9;
    if (tilted) return lose(target, kNoteArcInFrame);
    const PlanePoint a = {radius_of(axes.p, via[axes.p] - state_.position[axes.p]),
                          radius_of(axes.q, via[axes.q] - state_.position[axes.q])};
    const PlanePoint b = chord(axes, target);
    const double area = 2.0 * (a.p * b.q - a.q * b.p);
    if (std::abs(area) < 1e-9) return straight(MotionKind::linear, target);  // three points of a line
    const double aa = a.p * a.p + a.q * a.q;
    const double bb = b.p * b.p + b.q * b.q;
    const PlanePoint center = {(b.q * aa - a.q * bb) / area, (a.p * bb - b.p * aa) / area};
    emit_arc(area > 0.0 ? MotionKind::arc_ccw : MotionKind::arc_cw, axes, center, target);
  }

  // CT: leaves the move before it without a corner.
  void arc_tangent(const Target& target) {
    const PlaneAxes axes = axes_of(state_.modes.plane);
    if (starts_unknown(axes) || target.unknown != 0 || !state_.tangent_known) return lose(target);
    const PlanePoint way = {state_.tangent[axes.p], state_.tangent[axes.q]};
    const PlanePoint to_end = chord(axes, target);
    const PlanePoint left = {-way.q, way.p};
    const double aside = left.p * to_end.p + left.q * to_end.q;
    if (length_of(way) < 1e-9 || std::abs(aside) < 1e-9 * length_of(way)) return straight(MotionKind::linear, target);
    const double factor = (to_end.p * to_end.p + to_end.q * to_end.q) / (2.0 * aside);
    emit_arc(aside > 0.0 ? MotionKind::arc_ccw : MotionKind::arc_cw, axes, {factor * left.p, factor * left.q}, target);
  }

  void arc(MotionKind kind, Target target) {
    const PlaneAxes axes = axes_of(state_.modes.plane);
    if (has_unknown_parts(target)) return lose(target);
    if (state_.modes.has_matrix) {
      image_ = image_of(state_.modes.matrix, axes);
      if (!image_.stays) return lose(target, kNoteArcInFrame);
      if (image_.mirrored) kind = kind == MotionKind::arc_ccw ? MotionKind::arc_cw : MotionKind::arc_ccw;
    }
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
    constexpr std::uint64_t kParts = bit_of(Address::i) | bit_of(Address::j) | bit_of(Address::k) | bit_of(Address::r) |
                                     bit_of(Address::arc_radius) | bit_of(Address::opening_angle) |
                                     bit_of(Address::turns);
    const PlaneAxes axes = axes_of(state_.modes.plane);
    return ((target.unknown >> axes.p | target.unknown >> axes.q) & 1U) != 0 || (block_.unknown & kParts) != 0;
  }
  [[nodiscard]] bool starts_unknown(PlaneAxes axes) const {
    return ((state_.unknown >> axes.p | state_.unknown >> axes.q) & 1U) != 0;
  }
  // No arc can be said, but where it ends may be known.
  void lose(const Target& target, std::uint32_t note = kNoteArcNotComputed) {
    result_ = {};
    result_.notes |= note;
    state_.tangent_known = false;
    drop_corner();
    settle(target);
  }

  // --- chamfers and roundings

  [[nodiscard]] PlanePoint point_of(const AxisValues& at, PlaneAxes axes) const {
    return {radius_of(axes.p, at[axes.p]), radius_of(axes.q, at[axes.q])};
  }
  [[nodiscard]] PathPiece piece_of(const ir::Motion& motion, PlaneAxes axes) const {
    PathPiece piece{.start = point_of(motion.start, axes), .end = point_of(motion.end, axes), .center = {}};
    piece.is_arc = motion.kind == MotionKind::arc_cw || motion.kind == MotionKind::arc_ccw;
    piece.turn = motion.kind == MotionKind::arc_ccw ? Turn::counterclockwise : Turn::clockwise;
    piece.center = {piece.start.p + motion.center[axes.p], piece.start.q + motion.center[axes.q]};
    return piece;
  }
  void put_point(AxisValues& at, PlaneAxes axes, PlanePoint point) const {
    at[axes.p] = kept_of(axes.p, point.p);
    at[axes.q] = kept_of(axes.q, point.q);
  }
  // Moves that lie in the plane alone and whose places are known.
  [[nodiscard]] static bool is_flat(const ir::Motion& motion, PlaneAxes axes) {
    if (motion.axes_unknown != 0 && (motion.axes_unknown & 7U) != 0) return false;
    for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis)
      if (axis != axes.p && axis != axes.q && motion.start[axis] != motion.end[axis]) return false;
    return !motion.machine_coordinates;
  }

  void drop_corner() {
    if (state_.corner.kind != 0) result_.notes |= kNoteCornerNotComputed;
    state_.corner = {};
    out_.hold(false);
  }

  // The last motion of the buffer is the move behind the corner that waits, and may have a corner at its own end.
  void finish_corner() {
    if (state_.corner.kind != 0) insert_corner();
    const auto [kind, size] = wanted_corner();
    state_.corner = {};
    if (kind != CornerKind::none) state_.corner = {static_cast<std::uint8_t>(kind), size, out_.used() - 1};
    out_.hold(kind != CornerKind::none);
  }

  [[nodiscard]] bool has_corner_word() const {
    return (block_.present &
            (bit_of(Address::chamfer) | bit_of(Address::chamfer_length) | bit_of(Address::rounding))) != 0;
  }

  [[nodiscard]] std::pair<CornerKind, double> wanted_corner() const {
    struct Row {
      Address address;
      CornerKind kind;
    };
    constexpr Row kRows[] = {{Address::chamfer, CornerKind::chamfer_leg},
                             {Address::chamfer_length, CornerKind::chamfer_edge},
                             {Address::rounding, CornerKind::rounding}};
    for (const Row& row : kRows)
      if (block_.has(row.address)) return {row.kind, rules_.length_mm(block_, row.address, state_.modes.inch)};
    if (state_.modal_rounding_mm > 0.0) return {CornerKind::rounding, state_.modal_rounding_mm};
    return {CornerKind::none, 0.0};
  }

  void insert_corner() {
    const PlaneAxes axes = axes_of(state_.modes.plane);
    const ir::Motion before = out_.at(state_.corner.motion);
    ir::Motion after = out_.at(out_.used() - 1);
    const auto kind = static_cast<CornerKind>(state_.corner.kind);
    std::optional<Corner> corner;
    if (before.plane == after.plane && is_flat(before, axes) && is_flat(after, axes))
      corner = corner_between(piece_of(before, axes), piece_of(after, axes), kind, state_.corner.size_mm);
    if (!corner.has_value()) {
      // A modal rounding has nothing to do where the way goes on without a corner.
      if (state_.modal_rounding_mm == 0.0) result_.notes |= kNoteCornerNotComputed;
      return;
    }
    put_point(out_.at(state_.corner.motion).end, axes, corner->from);
    ir::Motion& between = out_.at(out_.used() - 1);
    between.kind = !corner->is_arc                          ? MotionKind::linear
                   : corner->turn == Turn::counterclockwise ? MotionKind::arc_ccw
                                                            : MotionKind::arc_cw;
    put_point(between.start, axes, corner->from);
    put_point(between.end, axes, corner->to);
    between.center = {};
    if (corner->is_arc) {
      between.center[axes.p] = corner->center.p - corner->from.p;
      between.center[axes.q] = corner->center.q - corner->from.q;
    }
    between.compute = {};
    const PlanePoint was = point_of(after.start, axes);
    put_point(after.start, axes, corner->to);
    after.center[axes.p] += was.p - corner->to.p;
    after.center[axes.q] += was.q - corner->to.q;
    if (after.kind == MotionKind::linear) after.center = {};
    out_.add(after.kind) = after;
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
      radius = rules_.length_mm(block_, radius_address, state_.modes.inch) * image_.scale;
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
    const PlanePoint center = center_of_words(axes);
    if (block_.has(Address::opening_angle)) end_by_angle(axes, center, turn, target);
    return center;
  }
  [[nodiscard]] bool has_center() const {
    return (block_.present & (bit_of(Address::i) | bit_of(Address::j) | bit_of(Address::k))) != 0;
  }
  // Centre minus start in the active work offset.
  [[nodiscard]] PlanePoint center_of_words(PlaneAxes axes) const {
    const PlanePoint center{center_word(axes.p), center_word(axes.q)};
    if (!state_.modes.has_matrix) return center;
    const Matrix& m = state_.modes.matrix;
    return {m[axes.p * 3 + axes.p] * center.p + m[axes.p * 3 + axes.q] * center.q,
            m[axes.q * 3 + axes.p] * center.p + m[axes.q * 3 + axes.q] * center.q};
  }
  // I, J or K as centre minus start; a position (I=AC) is a coordinate of its axis, so a diameter on such an axis.
  [[nodiscard]] double center_word(std::size_t axis) const {
    const Address address = kCenterAddresses[axis];
    if (!block_.has(address)) return 0.0;
    const double value = rules_.length_mm(block_, address, state_.modes.inch);
    if ((block_.absolute & bit_of(address)) == 0) return value;
    const double kept = axis == 0 ? value * rules_.x_factor(state_.modes, false) : value;
    if (state_.modes.has_matrix) return radius_of(axis, kept) - programmed_position(rules_, state_)[axis];
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
    const PlanePoint to_end = chord(axes, target);
    ir::Motion& motion = emit(kind, target, state_.feed);
    motion.center[axes.p] = center.p;
    motion.center[axes.q] = center.q;
    const PlanePoint outward = {to_end.p - center.p, to_end.q - center.q};
    const double sign = kind == MotionKind::arc_ccw ? 1.0 : -1.0;
    state_.tangent = {};
    state_.tangent[axes.p] = -sign * outward.q;
    state_.tangent[axes.q] = sign * outward.p;
    state_.tangent_known = (state_.unknown & 7U) == 0;
    finish_corner();
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
  PlaneImage image_;  // of the arc's plane under the frame
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

namespace {

PlainBlock with_coordinates_only(const PlainBlock& block, const BlockRules& rules, ModalState& state) {
  constexpr std::uint64_t kPolar = bit_of(Address::polar_angle) | bit_of(Address::polar_radius);
  PlainBlock made = with_coordinates(block, rules, state);
  made.present &= ~kPolar;
  made.unknown &= ~kPolar;
  return made;
}

void move_by(Mover& mover, Function motion, const Target& target, BlockResult& result) {
  if (motion == Function::arc_cw || motion == Function::arc_ccw)
    return mover.arc(motion == Function::arc_cw ? MotionKind::arc_cw : MotionKind::arc_ccw, target);
  if (motion == Function::arc_via) return mover.arc_via(target);
  if (motion == Function::arc_tangent) return mover.arc_tangent(target);
  const bool threads = motion == Function::thread || motion == Function::tap || motion == Function::tap_retract;
  if (motion == Function::spline) result.notes |= kNoteSpline;
  mover.straight(motion == Function::linear   ? MotionKind::linear
                 : threads                    ? MotionKind::thread
                 : motion == Function::spline ? MotionKind::spline
                                              : MotionKind::rapid,
                 target);
}

}  // namespace

void move(const PlainBlock& block, const BlockRules& rules, const MoveOptions& options, ModalState& state,
          MotionBuffer& out, BlockResult& result) {
  if (has_polar_words(block))
    return move(with_coordinates_only(block, rules, state), rules, options, state, out, result);
  const bool in_frame = state.modes.has_matrix && !options.machine_coordinates;
  const Target target = in_frame ? find_target_in_frame(block, rules, state)
                                 : find_target(block, rules, state, options.machine_coordinates);
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
  move_by(mover, options.motion != Function::none ? options.motion : state.modes.motion, target, result);
  if (block.has(Address::measuring)) {
    result.notes |= kNoteMeasuring;
    state.unknown |= target.commanded;
    state.tangent_known = false;
  }
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
  for (std::uint64_t rest = (block.present | block.numbered | block.unknown) & rules.axis_addresses; rest != 0;
       rest &= rest - 1)
    state.unknown |= static_cast<std::uint16_t>(
        1U << index_of(rules.axis_words[static_cast<std::size_t>(std::countr_zero(rest))].axis));
}

namespace {

// ATRANS under a frame that turns: along the programmed axes.
void shift_in_frame(const PlainBlock& block, const BlockRules& rules, ModalState& state) {
  Vector by{};
  for_each_axis_word(block, rules, state.modes, false, [&](std::size_t axis, double value, bool) {
    if (axis < by.size())
      by[axis] = axis == 0 && rules.x_is_diameter ? value / 2.0 : value;
    else
      state.modes.shift[axis] += value;
  });
  const Vector turned = multiply(state.modes.matrix, by);
  for (std::size_t axis = 0; axis < turned.size(); ++axis)
    state.modes.shift[axis] += axis == 0 && rules.x_is_diameter ? 2.0 * turned[axis] : turned[axis];
}

}  // namespace

void change_frame(const PlainBlock& block, const BlockRules& rules, Function function, bool replace,
                  ModalState& state) {
  constexpr std::array kLetters = {Address::x, Address::y, Address::z};
  Vector values{};
  std::array<bool, 3> named{};
  for (std::size_t axis = 0; axis < values.size(); ++axis) {
    named[axis] = block.has(kLetters[axis]);
    values[axis] = named[axis] ? block.at(kLetters[axis]) : 0.0;
  }
  Matrix change = kIdentity;
  if (function == Function::rotate) {
    change = block.has(Address::frame_angle) ? rotation_in(state.modes.plane, block.at(Address::frame_angle))
                                             : rotation_of(values);
  } else {
    Vector factors = {1.0, 1.0, 1.0};
    for (std::size_t axis = 0; axis < factors.size(); ++axis)
      if (named[axis]) factors[axis] = function == Function::mirror ? -1.0 : values[axis];
    change = diagonal_of(factors);
  }
  if (replace) state.modes.shift = {};
  state.modes.matrix = replace ? change : multiply(state.modes.matrix, change);
  state.modes.has_matrix = state.modes.matrix != kIdentity;
  const std::uint64_t used = rules.axis_addresses | bit_of(Address::frame_angle);
  if ((block.unknown & used) != 0) state.unknown |= kAllAxes;
}

void shift_locally(const PlainBlock& block, const BlockRules& rules, bool whole, bool add, ModalState& state) {
  if (!add && (whole || (block.present & rules.axis_addresses) == 0)) {
    state.modes.shift = {};
    state.modes.matrix = kIdentity;
    state.modes.has_matrix = false;
  }
  if (add && state.modes.has_matrix) return shift_in_frame(block, rules, state);
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
