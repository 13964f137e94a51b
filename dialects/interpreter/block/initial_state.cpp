// Power-on settings first, then the modes that a caller is known to have set.
#include "dialects/interpreter/block/initial_state.h"

#include <vector>

#include "dialects/interpreter/block/code_effects.h"
#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/plain_block.h"

namespace dripfeed::interpreter {

namespace {

void take_caller_modes(const ir::Control& control, ModalState& state) {
  std::vector<PlainCode> codes;
  for (const ir::CodeRow& row : control.caller_modes) codes.push_back({row.function, row.argument, row.group});
  PlainBlock block;
  block.codes = codes;
  Effects effects;
  apply_codes(block, BlockRules(control), state, effects);
}

}  // namespace

ModalState initial_state(const ir::Control& control) {
  const ir::Semantics& s = control.semantics;
  ModalState state;
  state.modes.motion = s.power_on_motion;
  state.modes.motion_given = s.power_on_known;
  state.modes.plane = s.power_on_plane == ir::Function::plane_zx   ? ir::Plane::zx
                      : s.power_on_plane == ir::Function::plane_yz ? ir::Plane::yz
                                                                   : ir::Plane::xy;
  state.modes.inch = state.modes.inch_feed = s.power_on_unit == ir::Function::unit_inch;
  state.modes.absolute = s.power_on_distance != ir::Function::incremental;
  state.modes.feed_mode = s.power_on_feed == ir::Function::feed_per_rev        ? ir::FeedMode::per_rev
                          : s.power_on_feed == ir::Function::feed_inverse_time ? ir::FeedMode::inverse_time
                                                                               : ir::FeedMode::per_min;
  state.modes.diameter = s.power_on_diameter;
  state.repetitive.depth_mm = s.cycle_depth_mm;
  state.repetitive.retract_mm = state.repetitive.peck_retract_mm = s.cycle_retract_mm;
  state.repetitive.passes = s.cycle_passes;
  state.repetitive.first_cut_mm = s.thread_first_cut_mm;
  state.repetitive.least_cut_mm = s.thread_least_cut_mm;
  if (!control.caller_modes.empty()) take_caller_modes(control, state);
  return state;
}

}  // namespace dripfeed::interpreter
