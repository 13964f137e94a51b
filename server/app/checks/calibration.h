// Measuring what a control takes to compute: the program that measures it at the control, in its own language, and the
// cost model from what that left in the control's variables. Fitting itself is the timing's.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "checks/timing/cost_fit.h"
#include "dialects/compile/dialect/dialect.h"
#include "server/app/base/error.h"
#include "server/machine/profile.h"

namespace dripfeed::app {

// As the program calls itself in its first lines.
inline constexpr std::string_view kTimingProgramName = "DRIPFEED TIMING";

struct CalibrationOptions {
  bool prints = false;  // it sends the times by DPRNT, too, as "V500 412.000"
  bool calls = false;   // a second program stands after it in the same text, and calls of it are measured, too
};
// Runs some hundred statements of each kind, rounds of loops and a piece of a program, each between two readings of the
// control's timer (#3001 in ms, $AC_TIMER in s), and leaves the times in #500 … or R20 …. Moves nothing. Errors: the
// control has no such variables, or no DPRNT.
Result<std::string> calibration_program(const ir::Control& control, const CalibrationOptions& options = {});

struct CalibrationRow {
  std::string what;
  std::string variable;  // as the control writes it
  timing::CostRow row;
};
// What the control was asked to do in each part of its program, by running that here, and how long it took; with calls
// where there is a value for them. Errors: a value is missing or not above zero. `values`: as read_variables gives
// them.
Result<std::vector<CalibrationRow>> calibration_rows(const compile::Dialect& dialect, const ir::Control& control,
                                                     const std::map<std::uint32_t, double>& values);

}  // namespace dripfeed::app
