// Motions of a face or cylinder brought to the axes of the machine, curve by curve.
#pragma once

#include <optional>

#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/motion_buffer.h"
#include "dialects/ir/motion.h"

namespace dripfeed::interpreter {

struct TransformedPlane {
  Transformation made;
  std::size_t slot = 1;  // the coordinate across stands in that axis's place
  bool x_is_diameter = false;
  AxisValues real{};  // where the machine's axes stood before
  std::uint16_t unknown = 0;
};

class TransformedPieces {
 public:
  TransformedPieces(const TransformedPlane& plane, ModalState& state, MotionBuffer& out)
      : plane_(plane), t_(plane_.made), state_(state), out_(out), real_(plane.real) {}

  // The state's axes stand at its end then. False where it starts at a position that is not known: the axes then go
  // there in one.
  bool bring(const ir::Motion& motion);

 private:
  // As a motion's places, with the coordinate across in the slot.
  [[nodiscard]] AxisValues axes_at(const AxisValues& plane) const;
  [[nodiscard]] double error_of(const AxisValues& a, const AxisValues& b, double share, const AxisValues& wanted) const;
  [[nodiscard]] double length_of(const AxisValues& a, const AxisValues& b) const;
  template <class Path>
  void pieces(const ir::Motion& motion, const Path& path, double t0, double t1, int depth);
  void straight(const ir::Motion& motion);
  void turn_at_center(const ir::Motion& motion, const AxisValues& center, double dx, double dy);
  void arc(const ir::Motion& motion);
  void put(const ir::Motion& motion, const AxisValues& plane_end, double length_mm);
  [[nodiscard]] double radius_value(std::size_t axis, double kept) const {
    return axis == 0 && plane_.x_is_diameter ? kept / 2.0 : kept;
  }
  [[nodiscard]] double kept_value(std::size_t axis, double radius) const {
    return axis == 0 && plane_.x_is_diameter ? radius * 2.0 : radius;
  }

  const TransformedPlane plane_;
  const Transformation& t_;
  ModalState& state_;
  MotionBuffer& out_;
  AxisValues real_;
  std::optional<double> at_center_deg_;  // where the rotary axis is to stand there; otherwise it stays
};

}  // namespace dripfeed::interpreter
