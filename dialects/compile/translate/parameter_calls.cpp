// Who is called is asked in the order in which the control looks: this text, then the other files.
#include "dialects/compile/translate/parameter_calls.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/ir/sections.h"
#include "dialects/sinumerik/reader/declared_programs.h"

namespace dripfeed::compile {

namespace {

using ir::StatementKind;

bool has_parameters(const ir::Program& text, const ir::Section& program) {
  for (std::uint32_t i = program.first; i < program.last; ++i) {
    const ir::Statement& s = text.statements[i];
    if (s.kind != StatementKind::procedure || s.payload == ir::kNoIndex) continue;
    const ir::Structure& head = text.structures[s.payload];
    const auto symbols = std::span(text.symbols).subspan(head.first_symbol, head.symbol_count);
    return std::ranges::any_of(symbols, &ir::Symbol::is_parameter);
  }
  return false;
}

// The text that a call of `name` finds; nullptr where there is none.
const ir::Program* text_with(const ir::Program& text, std::string_view name, ProgramLibrary* library) {
  if (text.name == name || ir::section_named(text, name)) return &text;
  return library == nullptr ? nullptr : library->find(name);
}

std::vector<std::string> declared_with_parameters(const ir::Program& text) {
  std::vector<std::string> names;
  for (const ir::Statement& s : text.statements) {
    if (s.kind != StatementKind::declaration) continue;
    const auto declared = sinumerik::declared_program(text, s);
    if (declared && !declared->parameters.empty()) names.push_back(declared->name);
  }
  return names;
}

}  // namespace

void call_parameters_as_macros(ir::Program& text, ProgramLibrary* library) {
  const std::vector<std::string> declared = declared_with_parameters(text);
  for (ir::Call& call : text.calls) {
    if (call.kind != ir::CallKind::subprogram || call.name == ir::StringId::none || call.in_other_language) continue;
    const std::string name(text.strings.at(call.name));
    const ir::Program* found = text_with(text, name, library);
    const bool takes = (found != nullptr &&
                        has_parameters(*found, ir::section_at(*found, ir::section_named(*found, name).value_or(0)))) ||
                       std::ranges::find(declared, name) != declared.end();
    if (takes) call.kind = ir::CallKind::macro;
  }
}

}  // namespace dripfeed::compile
