// The timing of a program as figures: speed and buffer over the time. The report must have its curve (see
// TimingWishes).
#pragma once

#include <string>

#include "checks/plot/plot.h"
#include "checks/timing/timing.h"

namespace dripfeed::app {

plot::Plot feed_plot(const timing::Report& report, const std::string& title);
// Bytes where the program is fed, otherwise blocks.
plot::Plot buffer_plot(const timing::Report& report, const std::string& title);

}  // namespace dripfeed::app
