// The variables of a run, as people and state files name them.
#pragma once

#include <vector>

#include "dialects/interpreter/interpreter.h"
#include "dialects/interpreter/machine/storage.h"

namespace dripfeed::interpreter {

// Those of the main program that it names or that have a value: numbered ones by bank and number, then declared names.
std::vector<VariableValue> list_variables(const VariableMap& variables, const CompiledProgram& main, Storage& storage,
                                          SharedData& shared);

}  // namespace dripfeed::interpreter
