// Axes as values: the number of an axis that the trace has, and further numbers for names that only a machine knows.
#pragma once

#include <string>
#include <string_view>

#include "dialects/interpreter/state/shared_data.h"

namespace dripfeed::interpreter {

// X is 0 … W is 8 (ir::Axis); any other name, whatever its case, has a number of its own above them.
double axis_number(SharedData& shared, std::string_view name);
// The name of a number that axis_number gave; the mark of unknown.h for one that is not known.
std::string axis_name(const SharedData& shared, double number);

}  // namespace dripfeed::interpreter
