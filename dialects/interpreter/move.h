// Moves of a block: where its axis words lead under the modal state, and straight moves, arcs and threads to there.
// Codes have taken effect before; nothing here changes a mode.
#pragma once

#include "dialects/interpreter/apply.h"

namespace dripfeed::interpreter {

struct MoveOptions {
  bool machine_coordinates = false;  // G53
  bool exact_stop = false;           // G09
};

// Where the axis words of a block lead: as Motion::end, bits per axis.
struct Target {
  AxisValues end{};
  std::uint16_t commanded = 0;
  std::uint16_t incremental = 0;  // … by an increment
};

// The plane's axes as indices, right-handed: p, q and the one that stands on it.
struct PlaneAxes {
  std::size_t p = 0;
  std::size_t q = 1;
  std::size_t normal = 2;
};
constexpr PlaneAxes axes_of(ir::Plane plane) {
  if (plane == ir::Plane::zx) return {2, 0, 1};
  return plane == ir::Plane::yz ? PlaneAxes{1, 2, 0} : PlaneAxes{0, 1, 2};
}

Target find_target(const PlainBlock& block, const BlockRules& rules, const ModalState& state, bool machine);
// A straight move to the target; the state is there afterwards.
void move_straight(ir::MotionKind kind, const Target& target, double feed, const MoveOptions& options,
                   ModalState& state, MotionBuffer& out, BlockResult& result);

// Carries out the block's axis words (and I J K of an arc) by the active motion code.
void move(const PlainBlock& block, const BlockRules& rules, const MoveOptions& options, ModalState& state,
          MotionBuffer& out, BlockResult& result);
// G31: a straight move that ends where the probe is known to touch.
void move_until_touch(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out,
                      BlockResult& result);
// G28: a rapid to the intermediate point that the words name; the reference point itself is not known.
void return_to_reference(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out,
                         BlockResult& result);
// G52, TRANS. `whole`: axes that are not named lose their shift. `add`: ATRANS.
void shift_locally(const PlainBlock& block, const BlockRules& rules, bool whole, bool add, ModalState& state);
// G92: the current position gets the named values.
void set_coordinates(const PlainBlock& block, const BlockRules& rules, ModalState& state);

// The axes that the block names may be anywhere after it.
void forget_positions(const PlainBlock& block, const BlockRules& rules, ModalState& state);

// What every motion says of the state: plane, feed mode, spindle, compensation, coolant, position.
void fill_common(ir::Motion& motion, const ModalState& state);

}  // namespace dripfeed::interpreter
