// The system variables of the SINUMERIK 840D sl that programs use, one row each. Those that a run can answer have a
// kind; the others are known by name, and reading one makes the verdict unknown.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "dialects/ir/control.h"

namespace dripfeed::sinumerik {

// The first row stands for every name that has no row of its own.
std::span<const ir::SystemVariableRow> system_variables();
// Row of "$P_EP"; that of the name without dollar for functions that give a value (INDEX); 0 for an unknown one.
std::uint32_t find_system_variable(std::string_view name);
// Whether writing it neither moves nor changes what is modelled: outputs, timers, counters, markers.
bool is_harmless_to_write(std::string_view name);

}  // namespace dripfeed::sinumerik
