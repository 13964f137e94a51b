// In the same text or in a folder: the control runs what it finds there before its own.
#include "dialects/compile/translate/own_cycles.h"

#include <algorithm>
#include <set>
#include <string>

#include "dialects/facts/calls.h"
#include "dialects/passes/refusal.h"

namespace dripfeed::compile {

std::vector<text::Diagnostic> own_cycles(const ir::Program& program, const ir::Control& to, ProgramLibrary* library) {
  std::vector<text::Diagnostic> out;
  std::set<std::string, std::less<>> reported;
  for (const ir::Statement& s : program.statements) {
    if (!facts::is_call(s.kind) || !facts::is_standard_cycle(program, s)) continue;
    const std::string name(program.strings.at(program.calls[s.payload].name));
    const bool in_text = std::ranges::any_of(
        program.sections, [&](const ir::Section& section) { return program.strings.at(section.name) == name; });
    const ir::Program* found = in_text || library == nullptr ? nullptr : library->find(name);
    const bool is_own = in_text || (found != nullptr && !found->is_standard);
    if (!is_own || !reported.insert(name).second) continue;
    out.push_back(passes::diagnose(passes::of_call("the shop's own program with the name " + name), s.span, to.title));
  }
  return out;
}

}  // namespace dripfeed::compile
