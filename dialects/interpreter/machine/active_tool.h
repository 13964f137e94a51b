// Radius and length of the tool in the spindle and its cutting edge: what the program wrote outranks the machine's
// profile.
#pragma once

#include <optional>

#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/shared_data.h"
#include "dialects/ir/control.h"

namespace dripfeed::interpreter {

// In mm; 0 where its offsets are off (D0), nothing where it is not known.
std::optional<double> active_radius(const ir::Control& control, SharedData& shared, const ModalState& state);
// … of a mill along the spindle.
std::optional<double> active_length(const ir::Control& control, SharedData& shared, const ModalState& state);

}  // namespace dripfeed::interpreter
