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
  Announced& announced = state.announced;
  if (announced.work_offset != state.modes.work_offset) {
    announced.work_offset = state.modes.work_offset;
    emit_event(MotionKind::offset, state, out).number = announced.work_offset;
  }
  if (announced.tool != state.tool) {
    announced.tool = state.tool;
    ir::Motion& motion = emit_event(MotionKind::tool, state, out);
    motion.number = announced.tool.number;
    motion.tool_offset = announced.tool.offset;
    motion.text = announced.tool.name;
  }
  if (const Spindle spindle = spindle_of(state); announced.spindle != spindle) {
    announced.spindle = spindle;
    emit_event(MotionKind::spindle, state, out);
  }
  if (announced.coolant != state.coolant) {
    announced.coolant = state.coolant;
    emit_event(MotionKind::coolant, state, out);
  }
  if (announced.comp != state.modes.comp) {
    announced.comp = state.modes.comp;
    emit_event(MotionKind::comp, state, out);
  }
}

}  // namespace dripfeed::interpreter
