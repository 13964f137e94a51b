// The toolpath of a text, as the page draws it, and what it amounts to.
#pragma once

#include <string>

#include "server/app/checks/path_picture.h"
#include "server/app/checks/statistics.h"
#include "server/app/checks/stock.h"
#include "server/app/checks/tool_path.h"

namespace dripfeed::json {

std::string tool_path(const app::ToolPath& path);
std::string path_picture(const app::PathPicture& picture);
std::string statistics(const app::Statistics& statistics);

// The stock of a program along its cuts as bytes, for a page that draws it:
//
//   "DFS1", the length of the head as 32-bit integer, the head as JSON with blanks at its end, then the columns that
//   the head names under "arrays", each [name, "f32" or "u32", count], one after the other. All little-endian, each
//   column at a multiple of four.
std::string stock_bytes(const app::StockRun& stock);

}  // namespace dripfeed::json
