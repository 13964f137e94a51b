// One finding for each name that something next to the program has to decide, and not one for each place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::sinumerik {

// Which of the programs of the text the place lies in, counted from 0.
std::size_t section_of(const ir::Program& program, std::uint32_t begin);

// Leaves of the open faults of one name the first in each program of the text.
void keep_one_per_name(const ir::Program& program, std::vector<text::Diagnostic>& diagnostics);

}  // namespace dripfeed::sinumerik
