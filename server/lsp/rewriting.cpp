// Formatting is renumbering, and code actions are the edits that diagnostics propose: both come as edits of the text
// that the client has, and the client carries them out.
#include "server/app/library/rewriting.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "dialects/compile/dialect/program_digest.h"
#include "server/app/library/fix_text.h"
#include "server/lsp/features.h"

namespace dripfeed::lsp {

namespace {

// Renumbering changes no line's place: lines that are not the same are replaced.
std::vector<TextEdit> changed_lines(const Subject& of, std::string_view made) {
  std::vector<TextEdit> edits;
  const Lines& before = of.text.lines();
  const Lines after(made);
  for (std::uint32_t line = 0; line < before.count(); ++line) {
    const text::Span old = before.span_of(line);
    const std::string_view now = after.span_of(line).in(made);
    if (old.in(of.text.source().text()) != now) edits.push_back({of.range_of(old), std::string(now)});
  }
  return edits;
}

TextEdit edit_of(const Subject& of, const text::Edit& edit) {
  return {of.range_of(edit.replaced), compile::as_utf8(edit.text)};
}

compile::Numbering numbering_of(std::string_view name) {
  const auto found = std::ranges::find(compile::kNumberingNames, name);
  return static_cast<compile::Numbering>(found - std::begin(compile::kNumberingNames));
}

}  // namespace

app::Result<std::vector<TextEdit>> renumbered(const Subject& of, const Settings& settings) {
  if (of.reading.is_family) return app::fail(app::ErrorCode::refused, "a family has no block numbers");
  const app::Rewritten made = app::renumber_text({.source = of.text.source(),
                                                  .control = of.reading.language.control,
                                                  .numbering = numbering_of(settings.numbering),
                                                  .first = settings.first_number,
                                                  .step = settings.number_step});
  if (made.refused.empty()) return changed_lines(of, made.text);
  const compile::RenumberRefusal& why = made.refused.front();
  return app::fail(app::ErrorCode::refused, why.line == 0
                                                ? fmt::format("not renumbered: {}", why.text)
                                                : fmt::format("not renumbered: line {}: {}", why.line, why.text));
}

std::vector<Action> actions_in(const Subject& of, const Range& range) {
  std::vector<Action> actions;
  const auto& all = of.reading.report.checks.diagnostics;
  const std::vector<Fault> faults = faults_of(of, of.reading.report);
  for (const text::Diagnostic& one : all) {
    if (!one.fix || one.elsewhere != nullptr || !touches(of.range_of(one.span), range)) continue;
    const Range at = of.range_of(one.span);
    const auto fault = std::ranges::find_if(faults, [&](const Fault& f) {
      return f.name == text::row_of(one.id).name && f.range.start.line == at.start.line &&
             f.range.start.character == at.start.character;
    });
    if (fault == faults.end()) continue;  // folded away: the client does not know it
    actions.push_back({.title = compile::as_utf8(app::describe_edit(*one.fix, of.text.source())),
                       .edits = {edit_of(of, *one.fix)},
                       .mends = *fault});
  }
  Action whole{.title = "Make all proposed edits", .edits = {}, .mends = {}};
  for (const text::Diagnostic* one : app::fix_text(of.text.source(), all).carried_out)
    whole.edits.push_back(edit_of(of, *one->fix));
  if (!whole.edits.empty()) actions.push_back(std::move(whole));
  return actions;
}

}  // namespace dripfeed::lsp
