// The variables that the rest reads, with the values that they have where the line begins; and what the blocks before
// it have done that no text can do again.
#pragma once

#include "dialects/compile/restart/restart_preamble.h"

namespace dripfeed::compile {

std::optional<RestartRefusal> write_variables(RestartDraft& draft);

// What was met before the line and not understood, or done and not repeated: M functions, codes without effect here.
std::optional<RestartRefusal> look_at_what_is_left_out(RestartDraft& draft);

}  // namespace dripfeed::compile
