// The figures of a text that a person writes: how far and how long its tools move, and in what room. Figures for
// people: whether it may go to a machine, and what the line adds to the time, is a check's to say.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "server/app/base/check_budget.h"
#include "server/app/checks/diagnose.h"
#include "server/app/checks/tool_path.h"

namespace dripfeed::app {

struct Statistics {
  ToolPath path;  // without its points
  std::uint64_t lines = 0;
  std::uint64_t bytes = 0;
  // Moves, dwells and tool changes, without any waiting for control or line; nothing: `why_no_time`.
  std::optional<double> time_s;
  std::vector<double> tool_times_s;  // by tool of the path; empty without a time
  std::string why_no_time;
};

// Errors: as diagnose_text.
Result<Statistics> statistics_of(const DiagnoseOrder& order, const Documents& documents, const CheckBudget& budget);

}  // namespace dripfeed::app
