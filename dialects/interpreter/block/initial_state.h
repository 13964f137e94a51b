// What holds before the first block of a program.
#pragma once

#include "dialects/interpreter/state/modal_state.h"
#include "dialects/ir/control.h"

namespace dripfeed::interpreter {

// The state at power-on, as far as the control says.
ModalState initial_state(const ir::Control& control);

}  // namespace dripfeed::interpreter
