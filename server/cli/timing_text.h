// A timing report for people: as text, and as plots over the time.
#pragma once

#include <string>

#include "checks/timing/timing.h"

namespace dripfeed::cli {

std::string timing_text(const timing::Report& report);
// SVG; of the report's curve, with what limited each stretch behind it.
std::string feed_plot(const timing::Report& report, const std::string& title);
std::string buffer_plot(const timing::Report& report, const std::string& title);

}  // namespace dripfeed::cli
