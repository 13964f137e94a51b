// What a report states, as places in one open text. What is wrong in a called program is placed where that is called.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "dialects/compile/dialect/program_digest.h"
#include "dialects/text/fold.h"
#include "server/lsp/features.h"
#include "server/lsp/file_uri.h"

namespace dripfeed::lsp {

namespace {

std::string sentence(std::string_view text, std::string_view control, std::string_view alarm) {
  if (alarm.empty()) return std::string(text);
  return fmt::format("{} ({}{}{})", text, control, control.empty() ? "" : " ", alarm);
}

// Of a text that is not open: its lines alone, because its encoding is not the client's.
Location line_of(const text::Source& source, std::uint32_t offset) {
  const std::uint32_t line = source.position(offset).line - 1;
  return {file_uri(source.name()), {{line, 0}, {line, 0}}};
}

class Faults {
 public:
  Faults(const Subject& of, const app::CheckReport& report) : of_(of), report_(report) {}

  std::vector<Fault> list() {
    text::DiagnosticFold fold;
    for (const text::Diagnostic& one : report_.checks.diagnostics)
      if (fold.shows(one)) add(one);
    for (const text::DiagnosticFold::Row& row : fold.folded()) add(row);
    checks::for_each_check(report_.checks, [this](const auto& one) { add(one.findings); });
    return std::move(out_);
  }

 private:
  void add(const text::Diagnostic& one) {
    const bool is_here = one.elsewhere == nullptr;
    const text::Source& source = is_here ? of_.text.source() : *one.elsewhere;
    Fault fault{.range = of_.range_of(is_here ? one.span : call_of(source.name())),
                .severity = one.severity,
                .name = std::string(text::row_of(one.id).name),
                .text = sentence(text::message_of(one), report_.control_title, one.alarm),
                .related = {}};
    if (!is_here) {
      const std::uint32_t line = source.position(one.span.begin).line;
      fault.related.push_back({line_of(source, one.span.begin), fault.text});
      fault.text = fmt::format("in {}, line {}: {}", source.name(), line, fault.text);
    }
    for (const text::DiagnosticNote& note : one.notes) {
      const Location at =
          is_here ? Location{of_.text.uri(), of_.range_of(note.span)} : line_of(source, note.span.begin);
      fault.related.push_back({at, note.text});
    }
    out_.push_back(std::move(fault));
  }

  // The others of a kind of which there are many.
  void add(const text::DiagnosticFold::Row& row) {
    out_.push_back({.range = of_.range_of(of_.span_of_line(1)),
                    .severity = row.severity,
                    .name = std::string(text::row_of(row.id).name),
                    .text = fmt::format("{} more of these are not shown", row.more),
                    .related = {}});
  }

  void add(const checks::FindingList& findings) {
    for (const checks::Finding& one : findings.kept()) {
      const bool is_called = one.place.program != 0 && one.place.program < report_.programs.size();
      const std::string& program = is_called ? report_.programs[one.place.program] : of_.text.source().name();
      const text::Span span = is_called ? call_of(program) : of_.span_of_line(one.place.line);
      const std::string text = sentence(one.text, "alarm", one.alarm);
      out_.push_back({.range = of_.range_of(span),
                      .severity = one.severity,
                      .name = std::string(text::row_of(one.id).name),
                      .text = is_called ? fmt::format("in {}, line {}: {}", program, one.place.line, text) : text,
                      .related = {}});
    }
  }

  // The block that calls that program first; the first line where that is not known.
  [[nodiscard]] text::Span call_of(const std::string& program) const {
    const std::string key = compile::call_key(program);
    const compile::ProgramDigest digest = compile::digest_of(of_.reading.read);
    const auto call = std::ranges::find(digest.calls, key, &compile::DigestCall::name);
    return of_.span_of_line(call == digest.calls.end() ? 1 : call->line);
  }

  const Subject& of_;
  const app::CheckReport& report_;
  std::vector<Fault> out_;
};

}  // namespace

text::Span Subject::span_of_line(std::uint32_t line) const {
  const std::string_view found = text.source().line(line);
  if (found.empty()) return {0, 0};
  const auto begin = static_cast<std::uint32_t>(found.data() - text.source().text().data());
  return {begin, begin + static_cast<std::uint32_t>(found.size())};
}

std::vector<Fault> faults_of(const Subject& of, const app::CheckReport& report) { return Faults(of, report).list(); }

}  // namespace dripfeed::lsp
