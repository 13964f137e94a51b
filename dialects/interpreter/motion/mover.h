// The moves that one block makes: straight ones, arcs, threads, and the corners between them. Its words name the path,
// the state the start and the modes.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "dialects/interpreter/motion/arc.h"
#include "dialects/interpreter/motion/corner.h"
#include "dialects/interpreter/motion/move.h"
#include "dialects/interpreter/motion/space_arc.h"
#include "dialects/interpreter/state/frame.h"

namespace dripfeed::interpreter {

class Mover {
 public:
  Mover(const PlainBlock& block, const BlockRules& rules, const MoveOptions& options, ModalState& state,
        MotionBuffer& out, BlockResult& result)
      : block_(block), rules_(rules), options_(options), state_(state), out_(out), result_(result) {}

  void straight(ir::MotionKind kind, const Target& target);
  // G34, G35: a thread whose lead grows or shrinks. Fault thread_invalid: it falls to nothing on the path.
  void changing_thread(const Target& target);
  // CIP: through the point that I1 J1 K1 name.
  void arc_via(const Target& target);
  // CT: leaves the move before it without a corner.
  void arc_tangent(const Target& target);
  void arc(ir::MotionKind kind, Target target);
  // What follows is a curve: neither the corner before it nor one at its end is made.
  void leave_corners();

  // What the block, or RNDM, asks for at the end of its move.
  [[nodiscard]] std::pair<CornerKind, double> wanted_corner() const;
  // Whether both moves lie in the plane alone, from and to known places.
  [[nodiscard]] bool are_flat(const ir::Motion& before, const ir::Motion& after) const;
  // Shortens both and makes the move between them; false where the corner does not fit.
  bool cut_corner(ir::Motion& before, ir::Motion& between, ir::Motion& after, CornerKind kind, double size_mm) const;

 private:
  // mover.cpp
  [[nodiscard]] bool starts_unknown(PlaneAxes axes) const;
  // No arc can be written, but where it ends may be known.
  void lose(const Target& target, std::uint64_t note = kNoteArcNotComputed);
  [[nodiscard]] PlanePoint point_of(const AxisValues& at, PlaneAxes axes) const;
  // End minus start in the plane, radius values.
  [[nodiscard]] PlanePoint chord(PlaneAxes axes, const Target& target) const;
  [[nodiscard]] double radius_of(std::size_t axis, double value) const {
    return axis == 0 && rules_.x_is_diameter ? value / 2.0 : value;
  }
  [[nodiscard]] double kept_of(std::size_t axis, double value) const {
    return axis == 0 && rules_.x_is_diameter ? value * 2.0 : value;
  }
  // Of a thread: K, I or J where one is given, otherwise F.
  [[nodiscard]] double lead() const;
  // mm in each turn; 0 and a note where the block does not say it for certain.
  [[nodiscard]] double lead_change(ir::Address address) const;
  // The move belongs to no contour that a corner or a tangent could go on from.
  void end_contour();
  ir::Motion& emit(ir::MotionKind kind, const Target& target, double feed);
  void fail(text::DiagnosticId id, double first, double second);
  std::optional<PlanePoint> fail_center(text::DiagnosticId id, double first, double second);

  // arcs: mover_arc.cpp
  // Whether a word that the arc is made of has a value that is not known.
  [[nodiscard]] bool has_unknown_parts(const Target& target) const;
  [[nodiscard]] bool has_center() const;
  // How far the radius at the start and at the end may be apart.
  [[nodiscard]] double tolerance_of(double radius) const {
    return std::max(rules_.semantics.arc_tolerance_mm, rules_.semantics.arc_tolerance_factor * radius);
  }
  // By radius, by opening angle, or by I J K; sets the fault and gives nothing when there is none.
  std::optional<PlanePoint> find_center(PlaneAxes axes, Turn turn, Target& target);
  // Centre minus start in the active work offset.
  [[nodiscard]] PlanePoint center_of_words(PlaneAxes axes) const;
  // I, J or K as centre minus start; a position (I=AC) is a coordinate of its axis, so a diameter on such an axis.
  [[nodiscard]] double center_word(std::size_t axis) const;
  void end_by_angle(PlaneAxes axes, PlanePoint center, Turn turn, Target& target);
  // TURN=n: n full circles before the arc; every axis outside the plane advances in proportion to the angle.
  void emit_turns(ir::MotionKind kind, PlaneAxes axes, PlanePoint center, double opening_deg, const Target& target);
  void emit_arc(ir::MotionKind kind, PlaneAxes axes, PlanePoint center, const Target& target);

  // arcs that lie in no plane of the control's own: mover_space.cpp
  // From where the block starts, radius values.
  [[nodiscard]] Vector vector_to_via() const;
  [[nodiscard]] Vector vector_to(const Target& target) const;
  void arc_in_space(const SpaceArc& arc, const Target& target);
  // By arc_cw, arc_ccw or arc_tangent in the plane as it is programmed, which the frame turns out of itself.
  void arc_in_tilted_plane(ir::Function function, const Target& target);
  void bring_out_of_tilted_plane(const ir::Motion& motion, const Target& target);

  // chamfers and roundings: mover_corner.cpp
  [[nodiscard]] PathPiece piece_of(const ir::Motion& motion, PlaneAxes axes) const;
  void put_point(AxisValues& at, PlaneAxes axes, PlanePoint point) const;
  // Moves that lie in the plane alone and whose positions are known.
  [[nodiscard]] static bool is_flat(const ir::Motion& motion, PlaneAxes axes);
  void drop_corner();
  // The last motion of the buffer is the move after the corner that waits, and may have a corner at its own end.
  void finish_corner();
  [[nodiscard]] bool has_corner_word() const;
  void insert_corner();

  const PlainBlock& block_;
  const BlockRules& rules_;
  const MoveOptions& options_;
  ModalState& state_;
  MotionBuffer& out_;
  BlockResult& result_;
  PlaneImage image_;  // of the arc's plane under the frame
};

}  // namespace dripfeed::interpreter
