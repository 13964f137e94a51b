// Reached is what the edges of the flow graph lead to; a computed jump leads to every label.
#include "dialects/sinumerik/validator/unreached.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "dialects/facts/unread.h"
#include "dialects/sinumerik/sinumerik.h"
#include "dialects/sinumerik/tables/name_index.h"

namespace dripfeed::sinumerik {

namespace {

std::set<ir::StringId> labels_in_texts(const ir::Program& program) {
  std::set<ir::StringId> labels;
  for (const ir::Token& token : program.tokens) {
    if (token.kind != ir::TokenKind::string) continue;
    std::string_view text = token.span.in(program.source.text());
    while (!text.empty()) {
      const std::size_t begin = text.find_first_not_of("\": ");
      if (begin == std::string_view::npos) break;
      text.remove_prefix(begin);
      const std::string_view name = text.substr(0, text.find_first_of("\": "));
      labels.insert(program.strings.find(UpperName(name).view()));
      text.remove_prefix(name.size());
    }
  }
  return labels;
}

bool is_error(const text::Diagnostic& d) { return d.severity == text::Severity::error; }

}  // namespace

void flood(const ir::Program& program, facts::FlowGraph& graph, std::vector<std::uint32_t> work, std::uint32_t last,
           std::vector<bool>& reached, Contours contours) {
  const std::vector<ir::Statement>& statements = program.statements;
  while (!work.empty()) {
    const std::uint32_t i = work.back();
    work.pop_back();
    if (reached[i]) continue;
    reached[i] = true;
    if (i == last) continue;
    const bool skips_contour =
        contours == Contours::left_out && i < statements.size() && statements[i].kind == ir::StatementKind::call;
    for (const std::uint32_t next : graph.after(i))
      if (!skips_contour || next == i + 1) work.push_back(next);
  }
}

std::vector<bool> contours_of_cycles(const ir::Program& program, const std::vector<bool>& reached) {
  const std::size_t count = program.statements.size();
  std::vector<bool> of_cycle(count, false);
  const std::set<ir::StringId> named = labels_in_texts(program);
  for (const ir::Label& label : program.labels)
    if (label.name != ir::StringId::none && named.contains(label.name))
      for (std::uint32_t i = label.statement; i < count && !reached[i]; ++i) of_cycle[i] = true;
  return of_cycle;
}

void soften_unreached(const ir::Program& program, std::vector<text::Diagnostic>& diagnostics) {
  if (std::ranges::none_of(diagnostics, is_error)) return;
  const std::vector<ir::Statement>& statements = program.statements;
  std::vector<bool> reached(statements.size() + 1, false);
  facts::FlowGraph graph(program);
  flood(program, graph, graph.entries(), ir::kNoIndex, reached);
  const std::vector<bool> of_cycle = contours_of_cycles(program, reached);
  for (std::size_t i = 0; i < statements.size(); ++i)
    if (of_cycle[i]) reached[i] = true;
  facts::soften_unread(program, reached, diagnostics);
}

}  // namespace dripfeed::sinumerik
