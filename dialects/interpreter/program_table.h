// The programs of a run: each is compiled when it is first called.
#pragma once

#include <compare>
#include <map>
#include <memory>
#include <string_view>

#include "dialects/interpreter/code_builder.h"

namespace dripfeed::interpreter {

class ProgramTable {
 public:
  ProgramTable(const CompileContext& context, ProgramFinder& finder) : context_(context), finder_(finder) {}

  // The program's section of that name, its first one without such.
  CompiledProgram& add(const ir::Program& program, std::string_view name);
  // Looked for in the text of the caller, in the main program's text, and then by the finder; nullptr when nobody has
  // it.
  CompiledProgram* find(std::string_view name, const CompiledProgram& caller);
  // The same program, returning behind that statement.
  CompiledProgram& part_of(const CompiledProgram& whole, std::uint32_t last);

 private:
  const CompileContext& context_;
  ProgramFinder& finder_;
  CompiledProgram& add_section(const ir::Program& program, std::uint32_t section, std::string_view name);

  struct Key {
    const ir::Program* program;
    std::uint32_t section;
    std::uint32_t last = ir::kNoIndex;
    auto operator<=>(const Key&) const = default;
  };
  std::map<Key, std::unique_ptr<CompiledProgram>> programs_;
  const ir::Program* main_ = nullptr;
};

}  // namespace dripfeed::interpreter
