// Read is what the edges of the flow graph lead to from the first block of each program, and from every label that
// other blocks name.
#include "dialects/macro_b/validator/unread.h"

#include <algorithm>
#include <cstdint>

#include "dialects/facts/flow_graph.h"
#include "dialects/facts/unread.h"
#include "dialects/macro_b/validator/findings.h"

namespace dripfeed::macro_b {

namespace {

std::vector<bool> read_statements(const ir::Program& program) {
  const std::size_t count = program.statements.size();
  std::vector<bool> read(count + 1, false);
  facts::FlowGraph graph(program);
  std::vector<std::uint32_t> work = graph.entries();
  for (const Section& section : sections_of(program)) {
    const Entries entries(program, section);
    work.push_back(section.first);
    for (std::uint32_t i = section.first; i < section.last; ++i)
      if (entries.at(i)) work.push_back(i);
  }
  while (!work.empty()) {
    const std::uint32_t i = work.back();
    work.pop_back();
    if (i > count || read[i]) continue;
    read[i] = true;
    if (i == count) continue;
    for (const std::uint32_t next : graph.after(i)) work.push_back(next);
  }
  return read;
}

}  // namespace

void soften_unread(const ir::Program& program, std::vector<text::Diagnostic>& diagnostics) {
  if (program.statements.empty() ||
      std::ranges::none_of(diagnostics, [](const auto& d) { return d.severity == text::Severity::error; }))
    return;
  facts::soften_unread(program, read_statements(program), diagnostics);
}

}  // namespace dripfeed::macro_b
