// What the codes of a block do: modes at once, the rest as a list of what the block then carries out in its order.
#pragma once

#include <cstdint>

#include "dialects/interpreter/state/block_result.h"
#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/motion_buffer.h"
#include "dialects/interpreter/state/plain_block.h"
#include "dialects/ir/function.h"

namespace dripfeed::interpreter {

// What the codes of this block ask for beyond the modes.
struct Effects {
  ir::Function one_shot = ir::Function::none;  // takes the block's axis words: dwell, local_shift(_add),
                                               // set_coordinates, reference_return, not_modelled
  std::int16_t argument = 0;                   // of the one shot
  bool machine_coordinates = false;
  bool exact_stop = false;
  bool tool_change = false;
  bool coolant_off = false;
  bool spindle_stop = false;
  bool surface_code = false;                    // this block switches the surface speed
  bool announces = false;                       // something that events report may have changed
  std::uint16_t orders = 0;                     // ir::kOrders…
  std::int16_t stop = -1;                       // 0 program, 1 optional
  ir::Function move_once = ir::Function::none;  // instead of the modal motion
  Flow flow = Flow::next;
};

void apply_codes(const PlainBlock& block, const BlockRules& rules, ModalState& state, Effects& effects);

}  // namespace dripfeed::interpreter
