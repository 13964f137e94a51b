// The characters of a text that the machine's line could not carry, or its control would not take: a job would be
// refused for them. Without a machine there are none.
#pragma once

#include <vector>

#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"
#include "server/app/checks/examine.h"

namespace dripfeed::app {

// Adds to `diagnostics`, in which what the reader said of a character stands already and is not said again. In comments
// it is a warning: newer controls keep there what older ones do not show.
void check_characters(const Examination& e, const ir::Program& program, std::vector<text::Diagnostic>& diagnostics);

}  // namespace dripfeed::app
