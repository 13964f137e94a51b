// What uses a variable otherwise than by its name: numbers that are computed (#[#1]), texts that are executed,
// synchronized actions, and programs that the text does not hold.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "dialects/compile/native/native_scope.h"
#include "dialects/compile/native/native_variable.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

// Statements, in the order of the text.
struct OtherUses {
  std::vector<std::uint32_t> reads;    // may read it
  std::vector<std::uint32_t> writes;   // may set it where they stand
  std::vector<std::uint32_t> actions;  // set it at any time
  std::vector<std::uint32_t> returns;  // may give back another value in it, as in an argument
  std::vector<std::uint32_t> calls;    // of programs that are not here and may do both
};

// Of the statements in `scope`, which has one bit a statement. `target` is the name of `variable` in upper case.
OtherUses other_uses(const ir::Program& program, const NativeVariable& variable, std::string_view target,
                     SeenBy seen_by, const std::vector<bool>& scope);

}  // namespace dripfeed::compile
