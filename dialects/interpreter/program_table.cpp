// Compiling on the first call.
#include "dialects/interpreter/program_table.h"

#include "dialects/interpreter/compile.h"

namespace dripfeed::interpreter {

CompiledProgram& ProgramTable::add(const ir::Program& program, std::string_view name) {
  std::unique_ptr<CompiledProgram>& entry = programs_[&program];
  if (entry == nullptr) {
    const auto index = static_cast<std::uint32_t>(context_.names.programs.size());
    context_.names.programs.emplace_back(name);
    entry = compile(program, index, context_);
  }
  return *entry;
}

CompiledProgram* ProgramTable::find(std::string_view name) {
  const ir::Program* program = finder_.find(name);
  return program == nullptr ? nullptr : &add(*program, name);
}

}  // namespace dripfeed::interpreter
