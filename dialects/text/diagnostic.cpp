// Sentences and printed lines of diagnostics. The rows are in diagnostic_table.cpp.
#include "dialects/text/diagnostic.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "dialects/text/excerpt.h"
#include "dialects/text/fold.h"

namespace dripfeed::text {

namespace {

// An excerpt of the line, and below it blanks up to the column: one for each character, tabs kept.
void append_caret(std::string& out, std::string_view line, std::uint32_t column) {
  const Excerpt shown = excerpt_of(line, column - 1);
  out.append(shown.text).push_back('\n');
  for (const char c : std::string_view(shown.text).substr(0, shown.place)) {
    if ((static_cast<unsigned char>(c) & 0xC0U) == 0x80U) continue;  // a continuation byte of UTF-8 takes no room
    out.push_back(c == '\t' ? '\t' : ' ');
  }
  out.append("^\n");
}

void append_head(std::string& out, std::string_view name, Position position) {
  fmt::format_to(std::back_inserter(out), "{}:{}:{}: ", name, position.line, position.column);
}

}  // namespace

std::string_view name_of(Severity severity) {
  switch (severity) {
    case Severity::note: return "note";
    case Severity::warning: return "warning";
    case Severity::error: return "error";
  }
  return {};
}

Diagnostic make_diagnostic(DiagnosticId id, Span span, std::vector<std::string> arguments) {
  return {id, row_of(id).severity, span, std::move(arguments)};
}

std::string message_of(const Diagnostic& diagnostic) {
  std::string out;
  std::string_view rest = row_of(diagnostic.id).text;
  auto argument = diagnostic.arguments.begin();
  for (std::size_t hole; (hole = rest.find("{}")) != std::string_view::npos; rest.remove_prefix(hole + 2)) {
    out.append(rest.substr(0, hole));
    if (argument != diagnostic.arguments.end()) out.append(shortened(*argument++));
  }
  return out.append(rest);
}

std::string format_diagnostic_at(const Diagnostic& diagnostic, std::string_view name, Position position,
                                 std::string_view line, std::string_view control) {
  std::string out;
  append_head(out, name, position);
  fmt::format_to(std::back_inserter(out), "{}[{}]: {}", name_of(diagnostic.severity), row_of(diagnostic.id).name,
                 message_of(diagnostic));
  if (!diagnostic.alarm.empty()) {
    fmt::format_to(std::back_inserter(out), " ({}{}{})", control, control.empty() ? "" : " ", diagnostic.alarm);
  }
  out.push_back('\n');
  append_caret(out, line, position.column);
  return out;
}

std::string format_diagnostic(const Diagnostic& diagnostic, const Source& checked, std::string_view control) {
  const Source& source = diagnostic.elsewhere == nullptr ? checked : *diagnostic.elsewhere;
  const Position position = source.position(diagnostic.span.begin);
  std::string out = format_diagnostic_at(diagnostic, source.name(), position, source.line(position.line), control);
  constexpr std::size_t kNotesShown = 20;
  for (const DiagnosticNote& note : std::span(diagnostic.notes).first(std::min(kNotesShown, diagnostic.notes.size()))) {
    const Position at = source.position(note.span.begin);
    append_head(out, source.name(), at);
    out.append("note: ").append(shortened(note.text)).push_back('\n');
    append_caret(out, source.line(at.line), at.column);
  }
  return out;
}

std::string format_folded(const DiagnosticFold::Row& row, std::string_view name) {
  return fmt::format("{}: {}[{}]: {} more, not shown\n", name, name_of(row.severity), row_of(row.id).name, row.more);
}

bool has_error(const std::vector<Diagnostic>& diagnostics) {
  return std::ranges::any_of(diagnostics, [](const Diagnostic& d) { return d.severity == Severity::error; });
}

}  // namespace dripfeed::text
