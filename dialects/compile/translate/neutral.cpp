// The control that families are written for: it has what the family language needs and assumes nothing.
#include "dialects/compile/dialect/dialect.h"

namespace dripfeed::compile {

namespace {

std::string_view axes_of(ir::MachineKind kind) {
  switch (kind) {
    case ir::MachineKind::lathe: return "XZC";
    case ir::MachineKind::mill: return "XYZABC";
    case ir::MachineKind::mill_turn: return "XYZABC";
  }
  return {};
}

}  // namespace

ir::Control neutral_control(ir::MachineKind kind, bool x_is_diameter) {
  ir::Control out;
  out.dialect = "family";
  out.title = "family";
  out.kind = kind;
  out.axes = axes_of(kind);
  out.limits = {.block_length_bytes = 0,
                .digits = 0,
                .expression_nesting = 0,
                .loop_nesting = 0,
                .call_nesting = 0,
                .macro_nesting = 0,
                .name_length = 0,
                .linear_decimals = 0};
  ir::Semantics& s = out.semantics;
  s.has_vacant = false;
  s.decimal_mode_confirmed = true;
  s.arc_radius_is_r = false;
  s.dwell_p_is_ms = false;
  s.d_selects_edge = true;
  s.taps_are_rigid = true;
  s.atan_full_circle = false;
  s.asin_from_90_to_270 = false;
  s.power_on_known = true;
  s.power_on_plane = kind == ir::MachineKind::mill ? ir::Function::plane_xy : ir::Function::plane_zx;
  s.power_on_diameter = x_is_diameter ? ir::DiameterMode::diameter : ir::DiameterMode::radius;
  return out;
}

}  // namespace dripfeed::compile
