// Values of variables before a run, from a text file: `#500=12.5`, `R10 = -3`, `COUNTER=1`, a line each; `;` begins a
// comment.
#pragma once

#include <string>
#include <vector>

#include "dialects/compile/dialect/execute.h"
#include "server/app/base/error.h"

namespace dripfeed::cli {

// An empty path gives no values. Errors: invalid with the line, unavailable.
app::Result<std::vector<interpreter::InitialValue>> read_state(const std::string& path);

}  // namespace dripfeed::cli
