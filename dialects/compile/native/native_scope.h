// Who can see a variable, and the part of a text where a name or a number means the same one.
#pragma once

#include <cstdint>
#include <vector>

#include "dialects/compile/native/native_variable.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

enum class SeenBy : std::uint8_t { own_program, called_with_m98, all };
SeenBy seen_by(const ir::Program& program, const ir::Control& control, const NativeVariable& variable);

// By statement: whether it is the same variable there. `settings` are those of the whole text, at least one; of several
// programs with a variable of the name that the main program has not, all count.
std::vector<bool> scope_of(const ir::Program& program, const ir::Control& control, const NativeVariable& variable,
                           const std::vector<NativeVariable::Setting>& settings);

}  // namespace dripfeed::compile
