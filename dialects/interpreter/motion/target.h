// Where the axis words of a block lead under the modal state: through shifts, and through a frame that turns.
#pragma once

#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"

namespace dripfeed::interpreter {

// Where the axis words of a block lead: as Motion::end, bits per axis.
struct Target {
  AxisValues end{};
  std::uint16_t commanded = 0;
  std::uint16_t incremental = 0;  // … by an increment
  std::uint16_t unknown = 0;      // named with a value that is not known
  std::uint16_t stated = 0;       // … by a coordinate of a frame that turns
  std::uint16_t shifted = 0;      // … by an increment after a change of the frame, see ModalState
};

// `machine`: the words name machine coordinates.
Target find_target(const PlainBlock& block, const BlockRules& rules, const ModalState& state, bool machine);
// Under a frame that turns, scales or mirrors.
Target find_target_in_frame(const PlainBlock& block, const BlockRules& rules, const ModalState& state);
// The one or the other, as the state has it.
Target find_any_target(const PlainBlock& block, const BlockRules& rules, const ModalState& state, bool machine);

}  // namespace dripfeed::interpreter
