// A text of several programs has a name for each of them.
#include "dialects/compile/dialect/run_texts.h"

#include "dialects/compile/dialect/source_lines.h"

namespace dripfeed::compile {

RunTexts::RunTexts(const ir::Program& main, const ProgramLibrary& library) : main_(main.source) {
  add(main, nullptr);
  for (const auto& loaded : library.loaded()) {
    const auto source = std::make_shared<const text::Source>(loaded->read.program.source);
    texts_.try_emplace(loaded->name, source);
    add(loaded->read.program, source);
  }
}

std::shared_ptr<const text::Source> RunTexts::find(const std::string& name) const {
  const auto found = texts_.find(name);
  return found == texts_.end() ? nullptr : found->second;
}

text::Diagnostic RunTexts::placed(const interpreter::RunDiagnostic& fault, const interpreter::RunResult& run) const {
  text::Diagnostic diagnostic = fault.diagnostic;
  if (fault.program != 0) diagnostic.elsewhere = find(run.programs[fault.program]);
  return diagnostic;
}

void RunTexts::place(text::Diagnostic& fault, const interpreter::RunResult& run, std::uint32_t program,
                     std::uint32_t line) const {
  if (program != 0) fault.elsewhere = find(run.programs[program]);
  fault.span = span_of_line(fault.elsewhere == nullptr ? main_ : *fault.elsewhere, line);
}

void RunTexts::add(const ir::Program& program, const std::shared_ptr<const text::Source>& source) {
  for (const ir::Section& section : program.sections)
    texts_.try_emplace(std::string(program.strings.at(section.name)), source);
}

}  // namespace dripfeed::compile
