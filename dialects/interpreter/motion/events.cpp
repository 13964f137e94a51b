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

void announce_spindle(ModalState& state, MotionBuffer& out, std::uint16_t orders) {
  Announced& announced = state.announced;
  constexpr std::uint16_t kTurning = ir::kOrdersSpindle | ir::kOrdersOrientation;
  if ((orders & ir::kOrdersLimit) != 0) {
    ir::Motion& limit = emit_event(MotionKind::spindle, state, out);
    limit.axes_commanded = ir::kOrdersLimit;
    limit.spindle_rpm = state.spindle_limit_rpm;
  }
  const Spindle spindle = spindle_of(state);
  if (announced.spindle != spindle || (orders & (kTurning | ir::kOrdersSpeed)) != 0) {
    announced.spindle = spindle;
    emit_event(MotionKind::spindle, state, out).axes_commanded = orders & (kTurning | ir::kOrdersSpeed);
  }
}

// Of M7 and M8 in one block each is an order.
void announce_coolant(ModalState& state, MotionBuffer& out, std::uint16_t orders) {
  Announced& announced = state.announced;
  constexpr std::uint16_t kBoth = ir::kOrdersMist | ir::kOrdersFlood;
  if ((orders & kBoth) == kBoth) {
    const ir::CoolantState last = state.coolant;
    state.coolant = last == ir::CoolantState::mist ? ir::CoolantState::flood : ir::CoolantState::mist;
    emit_event(MotionKind::coolant, state, out);
    state.coolant = last;
  }
  if (announced.coolant != state.coolant || (orders & kBoth) != 0) {
    announced.coolant = state.coolant;
    emit_event(MotionKind::coolant, state, out);
  }
}

}  // namespace

ir::Motion& emit_event(MotionKind kind, const ModalState& state, MotionBuffer& out) {
  ir::Motion& motion = out.add(kind);
  fill_common(motion, state);
  motion.axes_unknown = state.unknown;
  return motion;
}

void announce(ModalState& state, MotionBuffer& out, std::uint16_t orders) {
  Announced& announced = state.announced;
  if (!announced.every_order) orders = 0;
  if (announced.work_offset != state.modes.work_offset) {
    announced.work_offset = state.modes.work_offset;
    emit_event(MotionKind::offset, state, out).number = announced.work_offset;
  }
  const std::uint16_t tool_orders = orders & (ir::kOrdersTool | ir::kOrdersChange | ir::kOrdersEdge);
  if (tool_orders != 0 || announced.tool != state.tool) {
    announced.tool = state.tool;
    ir::Motion& motion = emit_event(MotionKind::tool, state, out);
    motion.axes_commanded = tool_orders;
    motion.number = announced.tool.number;
    motion.tool_offset = announced.tool.offset;
    motion.text = announced.tool.name;
  }
  announce_spindle(state, out, orders);
  announce_coolant(state, out, orders);
  if (announced.comp != state.modes.comp) {
    announced.comp = state.modes.comp;
    emit_event(MotionKind::comp, state, out);
  }
}

}  // namespace dripfeed::interpreter
