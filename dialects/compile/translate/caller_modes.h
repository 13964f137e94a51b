// Modes that a subprogram's caller has set, named by a person for a subprogram that is taken by itself.
#pragma once

#include <expected>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/compile/dialect/dialect.h"

namespace dripfeed::compile {

// "G97 G18 G95": codes of the control, in its own spelling, as Control::caller_modes takes them. Error: a sentence that
// names the first thing that is no such code.
std::expected<std::vector<ir::CodeRow>, std::string> read_caller_modes(const Dialect& dialect,
                                                                       const ir::Control& control,
                                                                       std::string_view text);

}  // namespace dripfeed::compile
