// A fault belongs to the last statement that begins at it or before it.
#include "dialects/facts/unread.h"

#include <algorithm>
#include <iterator>

namespace dripfeed::facts {

void soften_unread(const ir::Program& program, const std::vector<bool>& read,
                   std::vector<text::Diagnostic>& diagnostics) {
  const std::vector<ir::Statement>& statements = program.statements;
  for (text::Diagnostic& d : diagnostics) {
    if (d.severity != text::Severity::error) continue;
    const auto after =
        std::ranges::upper_bound(statements, d.span.begin, {}, [](const ir::Statement& s) { return s.span.begin; });
    if (after == statements.begin()) continue;
    const auto i = static_cast<std::size_t>(std::distance(statements.begin(), after)) - 1;
    if (read[i] || ir::is_structure(statements[i].kind)) continue;
    d.severity = text::Severity::warning;
    d.notes.push_back({d.span, "no run reaches this block: the control does not read it"});
  }
}

}  // namespace dripfeed::facts
