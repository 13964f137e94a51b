// A program read without its stretches of plain moves against the program read whole.
#pragma once

#include <optional>
#include <string>

#include "dialects/compile/dialect/dialect.h"

namespace dripfeed::corpus {

// Nothing when both have the same diagnostics and make the same motions in the same lines, or when no line can be left
// out; otherwise the first difference. `cut_lines` gets the number of lines that were left out.
std::optional<std::string> thin_fault(const text::Source& source, const compile::Dialect& dialect,
                                      const ir::Control& control, std::size_t& cut_lines);

}  // namespace dripfeed::corpus
