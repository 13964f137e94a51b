// G70 leaves the program's modes as they were but for the position.
#include "dialects/interpreter/cycles/shape_run.h"

#include "dialects/interpreter/motion/move.h"

namespace dripfeed::interpreter {

void ShapeRun::begin(std::uint32_t cycle, std::uint32_t last, std::uint32_t resume, const ModalState& state,
                     ir::Place place) {
  active_ = true;
  reached_ = false;
  runs_last_ = true;
  cycle_ = cycle;
  last_ = last;
  resume_ = resume;
  before_ = state;
  place_ = place;
  motions_.clear();
}

void ShapeRun::finish(ModalState& state, MotionBuffer& out) const {
  Target target{.end = before_.position};
  for (std::size_t axis = 0; axis < ir::kAxisCount; ++axis)
    if (target.end[axis] != state.position[axis]) target.commanded |= static_cast<std::uint16_t>(1U << axis);
  const ir::Place place = out.place;
  out.place.line = place_.line;
  BlockResult result;
  if (target.commanded != 0) emit_move(ir::MotionKind::rapid, target, 0.0, {}, state, out, result);
  out.place = place;
  state.feed = before_.feed;
  state.modes.motion = before_.modes.motion;
}

}  // namespace dripfeed::interpreter
