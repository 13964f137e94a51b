// Stock removal to a contour (CYCLE95) as motions. The machine runs the contour's blocks first and hands their motions
// over. (PGZ, "Stock removal cycle CYCLE95".)
#pragma once

#include <string>
#include <vector>

#include "dialects/interpreter/state/block_result.h"
#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/motion_buffer.h"
#include "dialects/interpreter/state/plain_block.h"

namespace dripfeed::interpreter {

// Arguments of the cycle; lengths in mm, X as radius. `kind` is VARI: longitudinal when odd, outside 1 2 5 6 9 10,
// inside the others; 1 to 4 rough, 5 to 8 finish, 9 to 12 both.
struct ContourCycle {
  double depth_mm = 0.0;        // MID: the deepest pass
  double allowance_z_mm = 0.0;  // FALZ
  double allowance_x_mm = 0.0;  // FALX
  double allowance_mm = 0.0;    // FAL: along the contour
  double rough_feed = 0.0;      // FF1
  double relief_feed = 0.0;     // FF2: down into a relief cut
  double finish_feed = 0.0;     // FF3
  int kind = 0;
  double dwell_s = 0.0;            // DT, each
  double dwell_distance_mm = 0.0;  // DAM of a pass
  double lift_mm = 1.0;            // _VRT
};

// What came of it: an alarm of the cycle by number, or what of it is not interpreted here; then nothing was cut.
struct ContourOutcome {
  std::uint32_t alarm = 0;
  std::string not_interpreted;  // "along a contour that …", of the cycle
};

// `contour` is what its blocks do from any place on: the first move leads to its first point. The state is where the
// cycle was called before, and where it ends afterwards.
ContourOutcome cut_contour(const std::vector<ir::Motion>& contour, const ContourCycle& cycle, const BlockRules& rules,
                           ModalState& state, MotionBuffer& out, BlockResult& result);

}  // namespace dripfeed::interpreter
