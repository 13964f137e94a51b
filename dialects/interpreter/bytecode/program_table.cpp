// Compiling on the first call.
#include "dialects/interpreter/bytecode/program_table.h"

#include "dialects/interpreter/bytecode/compile.h"
#include "dialects/ir/sections.h"

namespace dripfeed::interpreter {

using ir::section_named;

namespace {

bool begins_with_procedure(const ir::Program& program, std::uint32_t section) {
  const ir::Section& range = program.sections[section];
  for (std::uint32_t i = range.first; i < range.last; ++i)
    if (program.statements[i].kind != ir::StatementKind::empty)
      return program.statements[i].kind == ir::StatementKind::procedure;
  return false;
}

}  // namespace

CompiledProgram& ProgramTable::add(const ir::Program& program, std::string_view name) {
  if (main_ == nullptr) main_ = &program;
  return add_section(program, section_named(program, name).value_or(0), name);
}

CompiledProgram& ProgramTable::add_section(const ir::Program& program, std::uint32_t section, std::string_view name) {
  std::unique_ptr<CompiledProgram>& entry = programs_[{.program = &program, .section = section}];
  if (entry == nullptr) {
    const auto index = static_cast<std::uint32_t>(context_.names.programs.size());
    context_.names.programs.emplace_back(name);
    entry = compile(program, section, index, context_);
  }
  return *entry;
}

CompiledProgram& ProgramTable::part_of(const CompiledProgram& whole, std::uint32_t last) {
  std::unique_ptr<CompiledProgram>& entry = programs_[{whole.source, whole.section, last}];
  if (entry == nullptr) entry = compile(*whole.source, whole.section, whole.index, context_, last);
  return *entry;
}

CompiledProgram* ProgramTable::find(std::string_view name, const CompiledProgram& caller, bool in_other_language) {
  if (in_other_language) {
    // A file of the same stream was read in the control's own language, which is right where it says so itself.
    if (const auto section = section_named(*main_, name))
      return begins_with_procedure(*main_, *section) ? &add_section(*main_, *section, name) : nullptr;
    const ir::Program* program = finder_.find_foreign(name);
    return program == nullptr ? nullptr : &add(*program, name);
  }
  for (const ir::Program* text : {caller.source, main_})
    if (const auto section = section_named(*text, name)) return &add_section(*text, *section, name);
  const ir::Program* program = finder_.find(name);
  return program == nullptr ? nullptr : &add(*program, name);
}

CompiledProgram* ProgramTable::foreign_part(const CompiledProgram& host, std::uint32_t part) {
  const auto [entry, is_new] = foreign_parts_.try_emplace({&host, part});
  if (!is_new) return entry->second.get();
  const ProgramFinder::ForeignText text = finder_.foreign_text(*host.source);
  if (text.program == nullptr) return nullptr;
  if (other_language_ == nullptr) other_language_ = std::make_unique<Language>(*text.control, context_);
  entry->second = compile_foreign(*text.program, host.source->foreign_parts[part].text, host, other_language_->context);
  return entry->second.get();
}

}  // namespace dripfeed::interpreter
