// A timing report for people.
#pragma once

#include <string>

#include "checks/timing/timing.h"

namespace dripfeed::cli {

std::string timing_text(const timing::Report& report);

}  // namespace dripfeed::cli
