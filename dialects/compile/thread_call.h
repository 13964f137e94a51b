// CYCLE97 with numbers as its moves: the control's own cycle, run by itself.
#pragma once

#include <expected>
#include <string>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/motion.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

bool is_thread_call(const ir::Program& program, const ir::Call& call);

// Moves and events in units of the program, X as a diameter. The error names what of the call cannot be said.
std::expected<std::vector<ir::Motion>, std::string> moves_of_thread(const ir::Program& program, const ir::Call& call,
                                                                    const ir::Control& control);

}  // namespace dripfeed::compile
