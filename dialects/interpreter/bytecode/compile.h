// One program to bytecode. Statements become instructions, structures become branches; what cannot be compiled becomes
// an instruction that raises the alarm when it is reached, so a fault in a branch that is not taken does no harm.
#pragma once

#include <memory>

#include "dialects/interpreter/bytecode/code_builder.h"

namespace dripfeed::interpreter {

// `section`: which of the text's programs, 0 when it has one; `index`: its number in RunNames::programs; `last`: the
// statement after which it returns, none: it goes to its end.
std::unique_ptr<CompiledProgram> compile(const ir::Program& program, std::uint32_t section, std::uint32_t index,
                                         const CompileContext& context, std::uint32_t last = ir::kNoIndex);
// The statements of `foreign` whose blocks lie in `part`: of a program in the control's other language that runs in the
// place of that part of `host`, and returns to it after them. `context` is of that language.
std::unique_ptr<CompiledProgram> compile_foreign(const ir::Program& foreign, text::Span part,
                                                 const CompiledProgram& host, const CompileContext& context);
// A text that runs inside of `host`: names that the host has declared are the host's own. The program's symbols of such
// names become those of the host.
std::unique_ptr<CompiledProgram> compile_text(ir::Program& program, const CompiledProgram& host,
                                              const CompileContext& context);

}  // namespace dripfeed::interpreter
