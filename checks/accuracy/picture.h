// The deviation along the profile as a figure.
#pragma once

#include "checks/accuracy/figures.h"
#include "checks/plot/plot.h"

namespace dripfeed::accuracy {

plot::Plot deviation_plot(const Report& report);

}  // namespace dripfeed::accuracy
