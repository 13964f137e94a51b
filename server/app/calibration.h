// Measuring what a control takes to compute: the program that measures it at the control, in its own language, and the
// cost model from what that left in the control's variables. Fitting itself is the timing's.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "checks/timing/cost_fit.h"
#include "dialects/compile/dialect.h"
#include "server/app/error.h"
#include "server/machine/profile.h"

namespace dripfeed::app {

// Runs some hundred statements of each kind between two readings of the control's timer (#3001 in ms, $AC_TIMER in s)
// and leaves the times in #500 … or R20 …. Moves nothing. Errors: the control has no such variables.
Result<std::string> calibration_program(const ir::Control& control);

// Values by variable number from a dump of them, or from what was written down: a line each, "#500=412.", "R20=0.412",
// "500 412". Lines without two numbers are left out. Errors: none found, one given twice.
Result<std::map<std::uint32_t, double>> read_variables(std::string_view text);

struct CalibrationRow {
  std::string what;
  std::string variable;  // as the control writes it
  timing::CostRow row;
};
// What the control was asked to do in each part of its program, by running that here, and how long it took. Errors: a
// value is missing or not above zero.
Result<std::vector<CalibrationRow>> calibration_rows(const compile::Dialect& dialect, const ir::Control& control,
                                                     const std::map<std::uint32_t, double>& values);

}  // namespace dripfeed::app
