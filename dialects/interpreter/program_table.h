// The programs of a run: each is compiled when it is first called.
#pragma once

#include <memory>
#include <string_view>
#include <unordered_map>

#include "dialects/interpreter/code_builder.h"

namespace dripfeed::interpreter {

class ProgramTable {
 public:
  ProgramTable(const CompileContext& context, ProgramFinder& finder) : context_(context), finder_(finder) {}

  CompiledProgram& add(const ir::Program& program, std::string_view name);
  // nullptr when nobody has it.
  CompiledProgram* find(std::string_view name);

 private:
  const CompileContext& context_;
  ProgramFinder& finder_;
  std::unordered_map<const ir::Program*, std::unique_ptr<CompiledProgram>> programs_;
};

}  // namespace dripfeed::interpreter
