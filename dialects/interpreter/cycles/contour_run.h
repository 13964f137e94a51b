// While a contour's blocks are run for a cycle that cuts along it: who called it, what was before, what they did.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "dialects/interpreter/cycles/contour_cut.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/ir/mill_cycle.h"

namespace dripfeed::interpreter {

struct Instruction;

struct ContourRun {
  bool active = false;
  bool in_program = false;  // the contour is a program of its own; otherwise blocks between two labels
  std::size_t depth = 0;    // of calls, where it was called
  const Instruction* call = nullptr;
  ContourCycle cycle;
  std::optional<ir::MillCycle> path;  // that is milled along it, in the place of `cycle`
  ModalState before;
  ir::Place place;
  std::vector<ir::Motion> motions;
};

}  // namespace dripfeed::interpreter
