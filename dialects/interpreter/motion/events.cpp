// Each event carries the state that holds where it stands.
#include "dialects/interpreter/motion/events.h"

#include "dialects/interpreter/motion/move.h"

namespace dripfeed::interpreter {

using ir::MotionKind;

namespace {

Spindle spindle_of(const ModalState& state) {
  if (state.spindle == ir::SpindleState::stopped) return {};
  if (!state.modes.surface_speed) return {.state = state.spindle, .rpm = state.rpm};
  return {
      .state = state.spindle, .surface_speed_m_min = state.surface_speed_m_min, .limit_rpm = state.spindle_limit_rpm};
}

}  // namespace

ir::Motion& emit_event(MotionKind kind, const ModalState& state, MotionBuffer& out) {
  ir::Motion& motion = out.add(kind);
  fill_common(motion, state);
  motion.axes_unknown = state.unknown;
  return motion;
}

void announce(ModalState& state, MotionBuffer& out) {
  Announced& told = state.announced;
  if (told.work_offset != state.modes.work_offset) {
    told.work_offset = state.modes.work_offset;
    emit_event(MotionKind::offset, state, out).number = told.work_offset;
  }
  if (told.tool != state.tool) {
    told.tool = state.tool;
    ir::Motion& motion = emit_event(MotionKind::tool, state, out);
    motion.number = told.tool.number;
    motion.tool_offset = told.tool.offset;
    motion.text = told.tool.name;
  }
  if (const Spindle spindle = spindle_of(state); told.spindle != spindle) {
    told.spindle = spindle;
    emit_event(MotionKind::spindle, state, out);
  }
  if (told.coolant != state.coolant) {
    told.coolant = state.coolant;
    emit_event(MotionKind::coolant, state, out);
  }
  if (told.comp != state.modes.comp) {
    told.comp = state.modes.comp;
    emit_event(MotionKind::comp, state, out);
  }
}

}  // namespace dripfeed::interpreter
