// CYCLE97 with numbers as its moves: the control's own cycle, run by itself.
#pragma once

#include <expected>
#include <string>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/motion.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

bool is_thread_call(const ir::Call& call);

// Moves and events, X as a diameter; `inch`: what the call's lengths are in. The error names what of the call cannot be
// said.
std::expected<std::vector<ir::Motion>, std::string> moves_of_thread(const ir::Program& program, const ir::Call& call,
                                                                    const ir::Control& control, bool inch);

}  // namespace dripfeed::compile
