// The tool in the spindle where the line begins, its offset or edge, and the one that was prepared for the next change.
#pragma once

#include "dialects/compile/restart/restart_preamble.h"

namespace dripfeed::compile {

std::optional<RestartRefusal> write_tool(RestartDraft& draft);

// The one that a change in the rest takes, where it was named before the line.
std::optional<RestartRefusal> write_prepared_tool(RestartDraft& draft);

}  // namespace dripfeed::compile
