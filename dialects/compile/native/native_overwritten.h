// Whether a value that a program sets is still there when it reads it: what else may have set it in between.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/compile/native/native_scope.h"
#include "dialects/compile/native/native_variable.h"
#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

struct Overwritten {
  bool is_fault = false;                  // otherwise it is possible and no one here can see it
  std::string why;                        // "" where nothing sets it
  std::vector<std::uint32_t> statements;  // that show it
};

// A variable that `setting` alone sets by its name; `target` in upper case, `scope` of scope_of().
Overwritten overwritten(const ir::Program& program, const ir::Control& control, const NativeVariable& variable,
                        std::string_view target, std::uint32_t setting, const std::vector<bool>& scope);

// A parameter of a program of the text, whose head `procedure` is: by that program before it reads the value.
Overwritten overwritten_parameter(const ir::Program& program, const ir::Structure& procedure, ir::SymbolId symbol);

// "line 3 of the native program", "lines 3 and 8 of the native program"
std::string lines_of(const ir::Program& program, const std::vector<std::uint32_t>& statements);
// "3", "3 and 8", "3, 8 and 12"
std::string in_words(const std::vector<std::uint32_t>& lines);

}  // namespace dripfeed::compile
