// The programs of a run: each is compiled when it is first called.
#pragma once

#include <compare>
#include <map>
#include <memory>
#include <string_view>
#include <utility>

#include "dialects/interpreter/bytecode/code_builder.h"

namespace dripfeed::interpreter {

class ProgramTable {
 public:
  ProgramTable(const CompileContext& context, ProgramFinder& finder) : context_(context), finder_(finder) {}

  // The program's section of that name, its first one without such.
  CompiledProgram& add(const ir::Program& program, std::string_view name);
  // Looked for in the text of the caller, in the main program's text, and then by the finder; nullptr when there is
  // none, it. `in_other_language`: a program that begins in the control's other language: by the finder, or a file of
  // the main program's text that says itself in which language it is.
  CompiledProgram* find(std::string_view name, const CompiledProgram& caller, bool in_other_language = false);
  // A part of the program in that language; nullptr when no reader can read it.
  CompiledProgram* foreign_part(const CompiledProgram& host, std::uint32_t part);
  // The same program, returning after that statement.
  CompiledProgram& part_of(const CompiledProgram& whole, std::uint32_t last);

 private:
  const CompileContext& context_;
  ProgramFinder& finder_;
  CompiledProgram& add_section(const ir::Program& program, std::uint32_t section, std::string_view name);

  // What is compiled differently in the other language.
  struct Language {
    BlockRules rules;
    CompileContext context;
    Language(const ir::Control& control, const CompileContext& own)
        : rules(control), context{control,   rules,      own.arithmetic, own.variables,    own.limits,
                                  own.names, own.shared, own.reported,   own.skip_switches} {
      rules.other_language = true;
    }
  };

  struct Key {
    const ir::Program* program;
    std::uint32_t section;
    std::uint32_t last = ir::kNoIndex;
    auto operator<=>(const Key&) const = default;
  };
  std::map<Key, std::unique_ptr<CompiledProgram>> programs_;
  std::map<std::pair<const CompiledProgram*, std::uint32_t>, std::unique_ptr<CompiledProgram>> foreign_parts_;
  std::unique_ptr<Language> other_language_;
  const ir::Program* main_ = nullptr;
};

}  // namespace dripfeed::interpreter
