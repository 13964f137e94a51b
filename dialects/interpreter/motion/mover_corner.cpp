// Chamfers and roundings: a move that ends in one waits until the next is known.
#include <cmath>

#include "dialects/interpreter/motion/mover.h"

namespace dripfeed::interpreter {

using ir::Address;
using ir::MotionKind;

PathPiece Mover::piece_of(const ir::Motion& motion, PlaneAxes axes) const {
  PathPiece piece{.start = point_of(motion.start, axes), .end = point_of(motion.end, axes), .center = {}};
  piece.is_arc = motion.kind == MotionKind::arc_cw || motion.kind == MotionKind::arc_ccw;
  piece.turn = motion.kind == MotionKind::arc_ccw ? Turn::counterclockwise : Turn::clockwise;
  piece.center = {piece.start.p + motion.center[axes.p], piece.start.q + motion.center[axes.q]};
  return piece;
}

void Mover::put_point(AxisValues& at, PlaneAxes axes, PlanePoint point) const {
  at[axes.p] = kept_of(axes.p, point.p);
  at[axes.q] = kept_of(axes.q, point.q);
}

// Moves that lie in the plane alone and whose positions are known.
bool Mover::is_flat(const ir::Motion& motion, PlaneAxes axes) {
  if (((motion.axes_unknown >> axes.p | motion.axes_unknown >> axes.q) & 1U) != 0) return false;
  for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis)
    if (axis != axes.p && axis != axes.q && motion.start[axis] != motion.end[axis]) return false;
  return !motion.machine_coordinates;
}

void Mover::drop_corner() {
  if (state_.corner.kind != 0) result_.notes |= kNoteCornerNotComputed;
  state_.corner = {};
  out_.hold(false);
}

// The last motion of the buffer is the move after the corner that waits, and may have a corner at its own end.
void Mover::finish_corner() {
  if (state_.corner.kind != 0) insert_corner();
  const auto [kind, size] = wanted_corner();
  state_.corner = {};
  if (kind != CornerKind::none) state_.corner = {static_cast<std::uint8_t>(kind), size, out_.used() - 1};
  out_.hold(kind != CornerKind::none);
}

bool Mover::has_corner_word() const {
  return (block_.present & (bit_of(Address::chamfer) | bit_of(Address::chamfer_length) | bit_of(Address::rounding))) !=
         0;
}

std::pair<CornerKind, double> Mover::wanted_corner() const {
  struct Row {
    Address address;
    CornerKind kind;
  };
  constexpr Row kRows[] = {{Address::chamfer, CornerKind::chamfer_leg},
                           {Address::chamfer_length, CornerKind::chamfer_edge},
                           {Address::rounding, CornerKind::rounding}};
  // Z-20. R5. and Z-20. I2.: the same without the comma, with a sign that the next block's direction has as well.
  // (0i-F B-64604EN-1, "Chamfer and corner R".)
  constexpr Row kLetters[] = {
      {Address::r, CornerKind::rounding}, {Address::i, CornerKind::chamfer_leg}, {Address::k, CornerKind::chamfer_leg}};
  // I and K of G40 are the direction in which the compensation ends. (0i-F, "Tool nose radius compensation cancel".)
  const bool is_direction = has_code(block_, ir::Function::comp_off);
  if (rules_.corner_letters && state_.modes.motion == ir::Function::linear)
    for (const Row& row : kLetters)
      if (block_.has(row.address) && (row.address == Address::r || !is_direction))
        return {row.kind, std::abs(rules_.length_mm(block_, row.address, state_.modes.inch))};
  for (const Row& row : kRows)
    if (block_.has(row.address)) return {row.kind, rules_.length_mm(block_, row.address, state_.modes.inch)};
  if (state_.modal_rounding_mm > 0.0) return {CornerKind::rounding, state_.modal_rounding_mm};
  return {CornerKind::none, 0.0};
}

bool Mover::are_flat(const ir::Motion& before, const ir::Motion& after) const {
  const PlaneAxes axes = axes_of(state_.modes.plane);
  return before.plane == after.plane && is_flat(before, axes) && is_flat(after, axes);
}

bool Mover::cut_corner(ir::Motion& before, ir::Motion& between, ir::Motion& after, CornerKind kind,
                       double size_mm) const {
  const PlaneAxes axes = axes_of(state_.modes.plane);
  if (!are_flat(before, after)) return false;
  const auto corner = corner_between(piece_of(before, axes), piece_of(after, axes), kind, size_mm);
  if (!corner.has_value()) return false;
  put_point(before.end, axes, corner->from);
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
  // The pieces turn aside from the letters of the two blocks: each names what it moves.
  for (ir::Motion* piece : {&before, &between, &after})
    for (const std::size_t axis : {axes.p, axes.q})
      if (piece->start[axis] != piece->end[axis]) piece->axes_commanded |= static_cast<std::uint16_t>(1U << axis);
  return true;
}

void Mover::insert_corner() {
  const PlaneAxes axes = axes_of(state_.modes.plane);
  const ir::Motion before = out_.at(state_.corner.motion);
  ir::Motion after = out_.at(out_.used() - 1);
  const auto kind = static_cast<CornerKind>(state_.corner.kind);
  if (cut_corner(out_.at(state_.corner.motion), out_.at(out_.used() - 1), after, kind, state_.corner.size_mm)) {
    out_.add(after.kind) = after;
    return;
  }
  if (rules_.corner_alarm && are_flat(before, after)) {
    const TooShort piece = too_short_for(piece_of(before, axes), piece_of(after, axes), kind, state_.corner.size_mm);
    if (piece != TooShort::none) {
      result_.fault = text::DiagnosticId::corner_too_large;
      result_.detail = piece == TooShort::first ? ir::AlarmDetail::none : ir::AlarmDetail::next_move;
      result_.reason = piece == TooShort::first ? "before" : "after";
      return;
    }
  }
  // A modal rounding has nothing to do where the path goes on without a corner.
  if (state_.modal_rounding_mm == 0.0) result_.notes |= kNoteCornerNotComputed;
}

}  // namespace dripfeed::interpreter
