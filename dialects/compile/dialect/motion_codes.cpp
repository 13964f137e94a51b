// Tables of the few names that writers of blocks share.
#include "dialects/compile/dialect/motion_codes.h"

#include <algorithm>

namespace dripfeed::compile {

using ir::Function;
using ir::MotionKind;

std::optional<Function> plain_function_of(MotionKind kind) {
  switch (kind) {
    case MotionKind::rapid: return Function::rapid;
    case MotionKind::linear:
    case MotionKind::spline: return Function::linear;
    case MotionKind::arc_cw: return Function::arc_cw;
    case MotionKind::arc_ccw: return Function::arc_ccw;
    case MotionKind::thread:
    case MotionKind::dwell:
    case MotionKind::offset:
    case MotionKind::tool:
    case MotionKind::comp:
    case MotionKind::spindle:
    case MotionKind::coolant:
    case MotionKind::message:
    case MotionKind::stop:
    case MotionKind::end: break;
  }
  return std::nullopt;
}

Function function_of(ir::CompSide side) {
  switch (side) {
    case ir::CompSide::off: return Function::comp_off;
    case ir::CompSide::left: return Function::comp_left;
    case ir::CompSide::right: return Function::comp_right;
  }
  return Function::none;
}

Function function_of(ir::Plane plane) {
  switch (plane) {
    case ir::Plane::xy: return Function::plane_xy;
    case ir::Plane::zx: return Function::plane_zx;
    case ir::Plane::yz: return Function::plane_yz;
  }
  return Function::none;
}

ir::Code code_of(Function function, ir::ModalGroup group) {
  ir::Code made;
  made.function = function;
  made.group = group;
  return made;
}

bool has_row(const ir::Control& control, Function function, std::int16_t argument) {
  return std::ranges::any_of(
      control.g_codes, [&](const ir::CodeRow& row) { return row.function == function && row.argument == argument; });
}

bool is_arc(MotionKind kind) { return kind == MotionKind::arc_cw || kind == MotionKind::arc_ccw; }

bool leads_somewhere(const ir::Motion& m) {
  if (m.kind == ir::MotionKind::dwell) return m.feed > 0.0;
  return ir::is_move(m.kind) && (m.start != m.end || is_arc(m.kind) || (m.axes_unknown & m.axes_commanded) != 0);
}

std::uint16_t axes_to_name(const ir::Motion& motion) {
  std::uint16_t named = motion.axes_commanded;
  if (motion.machine_coordinates) return named;
  for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis)
    if (motion.start[axis] != motion.end[axis]) named |= static_cast<std::uint16_t>(1U << axis);
  return named;
}

bool is_in_plane(ir::Plane plane, std::size_t axis) {
  const std::size_t normal = plane == ir::Plane::xy ? 2 : plane == ir::Plane::zx ? 1 : 0;
  return axis < kCenterAddresses.size() && axis != normal;
}

}  // namespace dripfeed::compile
