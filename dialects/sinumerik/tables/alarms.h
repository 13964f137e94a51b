// Which alarm the SINUMERIK 840D sl gives for which fault.
#pragma once

#include <span>

#include "dialects/ir/control.h"

namespace dripfeed::sinumerik {

std::span<const ir::AlarmRow> alarms();

}  // namespace dripfeed::sinumerik
