// Who is called is asked in the order in which the control looks: this text, then the other files.
#include "dialects/compile/parameter_calls.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/sinumerik/declared_programs.h"

namespace dripfeed::compile {

namespace {

using ir::StatementKind;

bool has_parameters(const ir::Program& text, std::uint32_t first, std::uint32_t last) {
  for (std::uint32_t i = first; i < last; ++i) {
    const ir::Statement& s = text.statements[i];
    if (s.kind != StatementKind::procedure || s.payload == ir::kNoIndex) continue;
    const ir::Structure& head = text.structures[s.payload];
    const auto symbols = std::span(text.symbols).subspan(head.first_symbol, head.symbol_count);
    return std::ranges::any_of(symbols, &ir::Symbol::is_parameter);
  }
  return false;
}

// The program of that name in the text; of a file of another name it is the first, as a call finds it.
bool has_parameters(const ir::Program& text, std::string_view name, bool or_first) {
  for (const ir::Section& section : text.sections)
    if (text.strings.at(section.name) == name) return has_parameters(text, section.first, section.last);
  if (!or_first && text.name != name) return false;
  const auto count = static_cast<std::uint32_t>(text.statements.size());
  return has_parameters(text, 0, text.sections.empty() ? count : text.sections.front().last);
}

bool is_in(const ir::Program& text, std::string_view name) {
  return text.name == name || std::ranges::any_of(text.sections, [&](const ir::Section& section) {
           return text.strings.at(section.name) == name;
         });
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
    const bool here = is_in(text, name);
    const ir::Program* other = here || library == nullptr ? nullptr : library->find(name);
    const bool takes = (here && has_parameters(text, name, false)) ||
                       (other != nullptr && has_parameters(*other, name, true)) ||
                       std::ranges::find(declared, name) != declared.end();
    if (takes) call.kind = ir::CallKind::macro;
  }
}

}  // namespace dripfeed::compile
