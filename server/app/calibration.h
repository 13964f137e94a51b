// Measuring what a control takes to compute: the program that measures it at the control, in its own language, and the
// cost model from what that left in the control's variables. Fitting itself is the timing's.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "checks/timing/cost_fit.h"
#include "dialects/compile/dialect.h"
#include "server/app/error.h"
#include "server/machine/profile.h"

namespace dripfeed::app {

// Runs some hundred statements of each kind between two readings of the control's timer (#3001 in ms, $AC_TIMER in s)
// and leaves the times in #500 … or R20 …; with `prints` it sends them by DPRNT, too, as "V500 412.000". Moves nothing.
// Errors: the control has no such variables, or no DPRNT.
Result<std::string> calibration_program(const ir::Control& control, bool prints = false);

struct CalibrationRow {
  std::string what;
  std::string variable;  // as the control writes it
  timing::CostRow row;
};
// What the control was asked to do in each part of its program, by running that here, and how long it took. Errors: a
// value is missing or not above zero. `values`: as read_variables gives them.
Result<std::vector<CalibrationRow>> calibration_rows(const compile::Dialect& dialect, const ir::Control& control,
                                                     const std::map<std::uint32_t, double>& values);

}  // namespace dripfeed::app
