// All that a statement says, as a text: two statements with the same text do the same wherever they stand. Places in
// the text, labels and the numbers of loops are no part of it.
#pragma once

#include <cstdint>
#include <string>

#include "dialects/ir/program.h"

namespace dripfeed::compile {

std::string described_statement(const ir::Program& program, std::uint32_t statement);

}  // namespace dripfeed::compile
