// Motions as the checks get them, written down in one line each. Lengths in mm.
#pragma once

#include <cstdint>

#include "checks/gouge/sweep.h"
#include "dialects/ir/motion.h"

namespace dripfeed::checks {

inline ir::Motion takes_tool(std::int32_t number) {
  ir::Motion motion;
  motion.kind = ir::MotionKind::tool;
  motion.number = number;
  return motion;
}

// All of X, Y and Z are named in the block of line 3.
inline ir::Motion move(ir::MotionKind kind, gouge::Point3 from, gouge::Point3 to) {
  ir::Motion motion;
  motion.kind = kind;
  motion.place = {0, 3, 3};
  motion.start = {from.x, from.y, from.z};
  motion.end = {to.x, to.y, to.z};
  motion.axes_commanded = 7;
  return motion;
}
inline ir::Motion rapid(gouge::Point3 from, gouge::Point3 to) { return move(ir::MotionKind::rapid, from, to); }
inline ir::Motion cut(gouge::Point3 from, gouge::Point3 to) { return move(ir::MotionKind::linear, from, to); }

}  // namespace dripfeed::checks
