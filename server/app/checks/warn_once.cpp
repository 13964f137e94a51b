// The ids of which one warning says it.
#include "server/app/checks/warn_once.h"

#include <algorithm>
#include <set>
#include <utility>

namespace dripfeed::app {

namespace {

constexpr text::DiagnosticId kOnce[] = {text::DiagnosticId::missing_tape_mark, text::DiagnosticId::unknown_name,
                                        text::DiagnosticId::missing_decimal_point,
                                        text::DiagnosticId::variable_out_of_range, text::DiagnosticId::not_interpreted};

// Next to the note that states what decides it stands another: a likely slip.
bool is_slip(const text::Diagnostic& one) { return one.id == text::DiagnosticId::unknown_name && one.notes.size() > 1; }

}  // namespace

void warn_once(std::vector<text::Diagnostic>& diagnostics) {
  std::set<std::pair<text::DiagnosticId, const text::Source*>> seen;
  for (text::Diagnostic& one : diagnostics) {
    if (one.severity != text::Severity::warning || is_slip(one)) continue;
    if (std::ranges::find(kOnce, one.id) == std::end(kOnce)) continue;
    if (seen.emplace(one.id, one.elsewhere.get()).second) continue;
    one.severity = text::Severity::note;
    one.notes.clear();  // the first states what decides it
  }
}

}  // namespace dripfeed::app
