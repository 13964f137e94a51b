// The toolpath of a text, as the page draws it, and what it amounts to.
#pragma once

#include <string>

#include "server/app/checks/statistics.h"
#include "server/app/checks/tool_path.h"

namespace dripfeed::json {

std::string tool_path(const app::ToolPath& path);
std::string statistics(const app::Statistics& statistics);

}  // namespace dripfeed::json
