// Positions are looked up here: a diagnostic knows only bytes.
#include "server/json/diagnostics.h"

#include <algorithm>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "dialects/compile/dialect/language.h"
#include "dialects/compile/dialect/program_digest.h"
#include "dialects/text/fold.h"
#include "server/json/control_document.h"
#include "server/json/reports.h"

namespace dripfeed::json {

namespace {

Document range_document(text::Span span, const text::Source& source) {
  const text::Position from = source.position(span.begin);
  const text::Position to = source.position(span.end);
  return {{"line", from.line},
          {"column_chars", from.column_chars},
          {"end_line", to.line},
          {"end_column_chars", to.column_chars}};
}

Document fix_document(const text::Diagnostic& one, const text::Source& source) {
  if (!one.fix) return nullptr;
  Document fix = range_document(one.fix->replaced, source);
  fix["text"] = compile::as_utf8(one.fix->text);
  return fix;
}

Document fault_document(const text::Diagnostic& one, const text::Source& source) {
  const text::DiagnosticRow& row = text::row_of(one.id);
  Document fault = {{"id", row.name}, {"severity", text::name_of(one.severity)}};
  fault.update(range_document(one.span, source));
  fault["text"] = text::message_of(one);
  fault["help"] = row.help;
  fault["alarm"] = text_or_null(one.alarm);
  Document notes = Document::array();
  for (const text::DiagnosticNote& note : one.notes)
    notes.push_back({{"line", source.position(note.span.begin).line}, {"text", note.text}});
  fault["notes"] = std::move(notes);
  fault["fix"] = fix_document(one, source);
  return fault;
}

// The first one where none is given.
std::optional<std::size_t> index_of(std::span<const std::string_view> words, std::string_view word) {
  if (word.empty()) return 0;
  const auto found = std::ranges::find(words, word);
  if (found == words.end()) return std::nullopt;
  return static_cast<std::size_t>(found - words.begin());
}

}  // namespace

std::string diagnostics(const std::vector<text::Diagnostic>& all, const text::Source& source) {
  Document list = Document::array();
  text::DiagnosticFold fold;
  for (const text::Diagnostic& one : all) {
    if (!fold.shows(one)) continue;
    const text::Source& in = one.elsewhere == nullptr ? source : *one.elsewhere;
    const text::Position at = in.position(one.span.begin);
    list.push_back({{"id", text::row_of(one.id).name},
                    {"severity", text::name_of(one.severity)},
                    {"file", one.elsewhere == nullptr ? Document(nullptr) : Document(in.name())},
                    {"line", at.line},
                    {"column", at.column},
                    {"column_chars", at.column_chars},
                    {"text", text::message_of(one)},
                    {"alarm", one.alarm.empty() ? Document(nullptr) : Document(one.alarm)}});
  }
  return dump(list);
}

std::string folded_diagnostics(const std::vector<text::Diagnostic>& all) {
  text::DiagnosticFold fold;
  for (const text::Diagnostic& one : all) (void)fold.shows(one);
  Document list = Document::array();
  for (const text::DiagnosticFold::Row& row : fold.folded())
    list.push_back({{"id", text::row_of(row.id).name}, {"severity", text::name_of(row.severity)}, {"more", row.more}});
  return dump(list);
}

std::string diagnosed(const app::Diagnosed& diagnosed) {
  const app::CheckReport& report = diagnosed.report;
  Document faults = Document::array();
  text::DiagnosticFold fold;
  for (const text::Diagnostic& one : report.checks.diagnostics)
    if (one.elsewhere == nullptr && fold.shows(one)) faults.push_back(fault_document(one, report.source));
  Document rows = Document::array();
  for (const compile::OutlineRow& row : diagnosed.outline.rows)
    rows.push_back({{"sort", compile::name_of(row.sort)}, {"line", row.line}, {"text", row.text}});
  return dump({{"dialect", report.dialect},
               {"control", control_document(report)},
               {"faults", std::move(faults)},
               {"folded", embedded(folded_diagnostics(report.checks.diagnostics))},
               {"outline", std::move(rows)},
               {"outline_is_cut", diagnosed.outline.is_cut}});
}

std::string split_text(const std::vector<app::SplitProgram>& programs) {
  Document list = Document::array();
  for (const app::SplitProgram& one : programs)
    list.push_back({{"name", text_or_null(one.name)}, {"comment", text_or_null(one.comment)}, {"text", one.text}});
  return dump({{"programs", std::move(list)}});
}

std::string restart_preview(const app::RestartMade& made) {
  const compile::Restart& restart = made.restart;
  const auto line_or_null = [](std::uint32_t line) { return line == 0 ? Document(nullptr) : Document(line); };
  Document findings = Document::array();
  for (const app::ApproachFinding& one : made.findings)
    findings.push_back({{"severity", text::name_of(one.severity)}, {"line", one.line}, {"text", one.text}});
  const bool has_text = !restart.text.empty();
  return dump({{"possible", made.is_possible()},
               {"text", has_text ? Document(compile::as_utf8(restart.text)) : Document(nullptr)},
               {"sha256", has_text ? Document(made.sha256) : Document(nullptr)},
               {"preamble_line", line_or_null(restart.preamble_line)},
               {"rest_line", line_or_null(restart.rest_line)},
               {"assumptions", restart.assumptions},
               {"compared_moves", restart.compared_moves},
               {"findings", std::move(findings)},
               {"not_held", has_text ? text_or_null(made.not_held) : Document(nullptr)},
               {"safe_before", line_or_null(restart.safe_before)},
               {"safe_after", line_or_null(restart.safe_after)},
               {"diagnostics", embedded(diagnostics(restart.diagnostics, made.source))}});
}

app::Result<std::string> dialect_words(std::string_view name, std::string_view kind_word,
                                       std::string_view system_word) {
  const compile::Dialect* dialect = compile::find_dialect(name);
  if (dialect == nullptr) return app::fail(app::ErrorCode::not_found, fmt::format("no dialect \"{}\" is known", name));
  const auto kind = index_of(ir::kMachineKindNames, kind_word);
  if (!kind) return app::fail(app::ErrorCode::invalid, "kind must be mill, lathe or mill-turn");
  const auto system = index_of(kGSystemWords, system_word);
  if (!system) return app::fail(app::ErrorCode::invalid, "g_system must be A, B or C");
  const ir::Control control = dialect->control(static_cast<ir::MachineKind>(*kind), static_cast<ir::GSystem>(*system));
  Document rows = Document::array();
  for (const compile::DialectWord& word : compile::language_of(*dialect, control))
    rows.push_back({{"word", word.spelling},
                    {"sort", ir::name_of(word.sort)},
                    {"about", word.about},
                    {"reference", text_or_null(word.reference)},
                    {"last", word.last == 0 ? Document(nullptr) : Document(word.last)}});
  const bool in_brackets = dialect->comments == compile::CommentStyle::brackets;
  return dump(
      {{"dialect", dialect->name},
       {"title", control.title},
       {"comment", {{"open", in_brackets ? "(" : ";"}, {"close", in_brackets ? Document(")") : Document(nullptr)}}},
       {"touching", in_brackets},
       {"words", std::move(rows)}});
}

}  // namespace dripfeed::json
