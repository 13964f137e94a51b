// The page's outline as a tree: what comes after a program's head belongs to that program.
#include "server/lsp/features.h"

namespace dripfeed::lsp {

std::vector<Symbol> symbols_of(const Subject& of) {
  std::vector<Symbol> symbols;
  if (of.reading.is_family) return symbols;
  const text::Span end{static_cast<std::uint32_t>(of.text.source().text().size()),
                       static_cast<std::uint32_t>(of.text.source().text().size())};
  for (const compile::OutlineRow& row : compile::outline_of(of.reading.read).rows) {
    const Range line = of.range_of(of.span_of_line(row.line));
    Symbol symbol{.sort = row.sort, .name = row.text, .line = line, .whole = line, .children = {}};
    const bool begins = row.sort == compile::OutlineSort::program;
    const bool is_inside = !symbols.empty() && symbols.back().sort == compile::OutlineSort::program;
    if (begins && is_inside) symbols.back().whole.end = line.start;
    if (begins) symbol.whole.end = of.range_of(end).end;
    (begins || !is_inside ? symbols : symbols.back().children).push_back(std::move(symbol));
  }
  return symbols;
}

}  // namespace dripfeed::lsp
