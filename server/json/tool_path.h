// The path of a text's tool, as the page draws it.
#pragma once

#include <string>

#include "server/app/tool_path.h"

namespace dripfeed::json {

std::string tool_path(const app::ToolPath& path);

}  // namespace dripfeed::json
