// What stands between a report and a pass, point by point, so that a person can answer for each by itself.
#pragma once

#include <string>
#include <vector>

#include "server/app/base/report.h"

namespace dripfeed::app {

// More are none: then a verdict is waived as a whole.
inline constexpr std::size_t kMostPoints = 100;

// All causes of a warning or an unknown verdict, each once; none of a pass or a failure.
std::vector<std::string> points_of(const CheckReport& report);

}  // namespace dripfeed::app
