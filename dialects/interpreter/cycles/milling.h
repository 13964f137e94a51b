// Milling cycles as motions: pockets and slots, spigots, long holes, faces.
#pragma once

#include <cstdint>
#include <string_view>

#include "dialects/interpreter/state/block_result.h"
#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/motion_buffer.h"
#include "dialects/ir/mill_cycle.h"

namespace dripfeed::interpreter {

// What came of it: an alarm of the cycle by number, or what of it is not interpreted; then nothing was milled.
struct MillOutcome {
  std::uint32_t alarm = 0;
  std::string_view not_interpreted = {};  // "with …", of the call
};

// By a tool of that radius, above 0. The region that is milled, its depths and allowances are those of the cycle; in
// which order the tool sweeps it, and where it waits in between, is ours. Modes and feed are as before afterwards. The
// tool stands at the return level: over the centre of a pocket, and over a place that is not known otherwise.
MillOutcome mill(const ir::MillCycle& cycle, double radius_mm, const BlockRules& rules, ModalState& state,
                 MotionBuffer& out, BlockResult& result);

}  // namespace dripfeed::interpreter
