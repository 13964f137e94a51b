// The toolpath of a text, as the page draws it (diagnostics.cpp).
#pragma once

#include <string>

#include "server/app/checks/tool_path.h"

namespace dripfeed::json {

std::string tool_path(const app::ToolPath& path);

}  // namespace dripfeed::json
