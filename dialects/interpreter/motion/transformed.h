// Polar interpolation (G12.1, TRANSMIT) and cylindrical interpolation (G07.1, TRACYL). A block is carried out in the
// plane that it is written for; what comes out is brought to the axes of the machine:
//
//   face:      along = X as a radius, across stands on it; X = 2 hypot, C = zero + atan2(across, along)
//   cylinder:  across is a length on the circumference; C = across / radius
//
// Curves there become straight pieces of these axes, none farther than kTransformedChord_mm from its curve.
#pragma once

#include <optional>
#include <vector>

#include "dialects/interpreter/motion/corner.h"
#include "dialects/interpreter/state/block_result.h"
#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/motion_buffer.h"
#include "dialects/interpreter/state/plain_block.h"

namespace dripfeed::interpreter {

class TransformedPieces;

inline constexpr double kTransformedChord_mm = 0.001;

// G12.1, G07.1, TRANSMIT, TRACYL: `argument` as ir/transformation_use.h; the block's words belong to the code.
void begin_transformation(const PlainBlock& block, const BlockRules& rules, std::int16_t argument, ModalState& state);

// The corner that waits for the next move will not come: its move is there as it is.
void drop_plane_corner(ModalState& state, MotionBuffer& out, BlockResult& result);

// One block of such a mode: while it exists the state stands in the plane and motions are kept back; finish() puts both
// right.
class TransformedBlock {
 public:
  TransformedBlock(const PlainBlock& block, const BlockRules& rules, ModalState& state, MotionBuffer& out,
                   BlockResult& result);
  [[nodiscard]] const PlainBlock& block() const { return block_; }
  [[nodiscard]] const BlockRules& rules() const { return rules_; }
  void finish();

 private:
  void choose_slot();
  void take_rotary_words();
  void enter_plane();
  void leave_plane(bool any_move);
  void close_corner();
  [[nodiscard]] bool opens_corner(const ir::Motion& motion) const;
  void bring_kept();
  void bring_trimmed(TransformedPieces& pieces, const std::vector<ir::Motion>& taken);

  BlockRules rules_;
  PlainBlock block_;
  ModalState& state_;
  MotionBuffer& out_;
  BlockResult& result_;
  std::vector<ir::Motion>* outer_;
  std::vector<ir::Motion> kept_;
  std::optional<ir::Motion> trimmed_;  // the move before a corner, without what the corner takes off
  bool slot_fits_plane_ = true;
  CornerKind wanted_ = CornerKind::none;
  double wanted_mm_ = 0.0;
  double modal_rounding_mm_ = 0.0;
  // What enter_plane() changed in the state.
  struct Before {
    AxisValues position{};
    std::uint16_t unknown = 0;
    ir::Plane plane = ir::Plane::xy;
    ir::DiameterMode diameter = ir::DiameterMode::radius;
    double shift = 0.0;
    double coordinate_shift = 0.0;
  } before_;
  std::size_t slot_ = 1;  // the axis whose place the coordinate across takes
};

}  // namespace dripfeed::interpreter
