// By the program of the text, the fault and its arguments.
#include "dialects/sinumerik/reader/one_per_name.h"

#include <algorithm>
#include <set>
#include <string>
#include <tuple>

namespace dripfeed::sinumerik {

std::size_t section_of(const ir::Program& program, std::uint32_t begin) {
  const auto starts_before = [&](const ir::Section& section) {
    return section.first < program.statements.size() && program.statements[section.first].span.begin <= begin;
  };
  const auto sections = std::ranges::count_if(program.sections, starts_before);
  return sections == 0 ? 0 : static_cast<std::size_t>(sections) - 1;
}

void keep_one_per_name(const ir::Program& program, std::vector<text::Diagnostic>& diagnostics) {
  std::ranges::stable_sort(diagnostics, {}, [](const text::Diagnostic& d) { return d.span.begin; });
  std::set<std::tuple<std::size_t, text::DiagnosticId, std::vector<std::string>>> reported;
  std::erase_if(diagnostics, [&](const text::Diagnostic& d) {
    return d.is_open && !reported.emplace(section_of(program, d.span.begin), d.id, d.arguments).second;
  });
}

}  // namespace dripfeed::sinumerik
