// The tool of a milling cycle, moved in the coordinates of one of its places: x along the length of what is milled, y
// across it, from its centre; z is the programmed coordinate along the tool. Each move is made as a block of the
// program would make it, so that frames, planes and units are the interpreter's.
#pragma once

#include "dialects/interpreter/motion/arc.h"
#include "dialects/interpreter/state/block_result.h"
#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/frame.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/motion_buffer.h"
#include "dialects/interpreter/state/plain_block.h"
#include "dialects/ir/mill_cycle.h"

namespace dripfeed::interpreter {

class MillTool {
 public:
  // What the cycle changes of the state is brought back by `finish`.
  MillTool(const BlockRules& rules, ModalState& state, MotionBuffer& out, BlockResult& result);
  void go_to_place(const ir::MillPlace& place);

  void rapid(PlanePoint to);
  void rapid_level(double z);
  void cut(PlanePoint to, double feed);
  void cut_level(double z, double feed);
  void cut(PlanePoint to, double z, double feed);
  // Around the centre to that point, and to that level where one is given.
  void arc(PlanePoint to, PlanePoint center, Turn turn, double feed);
  void helix(PlanePoint to, PlanePoint center, double z, Turn turn, double feed);

  [[nodiscard]] PlanePoint at() const { return at_; }
  // Where the program's last point lies in the place's coordinates; false where it is not known.
  [[nodiscard]] bool is_known() const;
  [[nodiscard]] PlanePoint from_program() const;
  void finish(bool place_is_known);

 private:
  void move(ir::Function motion, double feed);
  void put(PlanePoint to);
  void put_level(double z);
  void put_arc(PlanePoint center);
  [[nodiscard]] PlanePoint in_program(PlanePoint local) const;

  const BlockRules& rules_;
  ModalState& state_;
  MotionBuffer& out_;
  BlockResult& result_;
  PlaneAxes axes_;
  Modes modes_;  // before
  double feed_;
  double rounding_mm_;
  ir::MillPlace place_;
  double cosine_ = 1.0;
  double sine_ = 0.0;
  PlanePoint at_;
  PlainBlock made_;
};

}  // namespace dripfeed::interpreter
