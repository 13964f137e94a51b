// Printing again: a program that a dialect's writer prints from what its reader understood must do the same.
#pragma once

#include <optional>
#include <string>

#include "dialects/compile/dialect/dialect.h"

namespace dripfeed::corpus {

// Nothing when the printed program makes the same motions and ends alike (line numbers aside), or when a writer
// says that it cannot print it; otherwise the first difference. Called programs are not found in either run.
std::optional<std::string> reprint_fault(const text::Source& source, const ir::Program& program,
                                         const compile::Dialect& dialect, const ir::Control& control);

}  // namespace dripfeed::corpus
