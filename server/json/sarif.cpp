// Results are diagnostics and findings; rules are their rows in the table. Lines count as the controls count them, so
// the run names its end-of-block sequences.
#include "server/json/sarif.h"

#include <map>
#include <utility>

#include <fmt/format.h>

#include "checks/verdict.h"
#include "dialects/text/fold.h"
#include "server/json/object_reader.h"

namespace dripfeed::json {

namespace {

// A path as a relative or absolute URI reference: what RFC 3986 does not let stand is escaped.
std::string uri_of(std::string_view path) {
  constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
  std::string uri = path.starts_with('/') ? "file://" : "";
  for (const char c : path) {
    if (kPlain.contains(c)) {
      uri += c;
    } else {
      uri += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return uri;
}

Document artifact(std::string_view name) { return {{"uri", uri_of(name)}}; }

Document location(std::string_view name, Document region) {
  return {{"physicalLocation", {{"artifactLocation", artifact(name)}, {"region", std::move(region)}}}};
}

Document region_of(text::Span span, const text::Source& source) {
  const text::Position begin = source.position(span.begin);
  const text::Position end = source.position(span.end);
  return {{"startLine", begin.line},
          {"startColumn", begin.column_chars},
          {"endLine", end.line},
          {"endColumn", end.column_chars}};
}

class Log {
 public:
  void add(const app::CheckReport& report);
  [[nodiscard]] Document document(std::string_view version) const;

 private:
  std::size_t rule_of(text::DiagnosticId id);
  Document result_of(text::DiagnosticId id, text::Severity severity, const std::string& sentence,
                     const std::string& alarm, Document at);
  void add(const text::Diagnostic& one, const text::Source& checked);
  void add(const checks::FindingList& findings, const app::CheckReport& report);

  std::map<text::DiagnosticId, std::size_t> indices_;
  Document rules_ = Document::array();
  Document results_ = Document::array();
  Document notifications_ = Document::array();
};

std::size_t Log::rule_of(text::DiagnosticId id) {
  const auto [place, is_new] = indices_.try_emplace(id, rules_.size());
  if (is_new) {
    const text::DiagnosticRow& row = text::row_of(id);
    rules_.push_back({{"id", row.name},
                      {"help", {{"text", row.help}}},
                      {"defaultConfiguration", {{"level", text::name_of(row.severity)}}}});
  }
  return place->second;
}

Document Log::result_of(text::DiagnosticId id, text::Severity severity, const std::string& sentence,
                        const std::string& alarm, Document at) {
  Document result = {{"ruleId", text::row_of(id).name},
                     {"ruleIndex", rule_of(id)},
                     {"level", text::name_of(severity)},
                     {"message", {{"text", sentence}}},
                     {"locations", Document::array({std::move(at)})}};
  if (!alarm.empty()) result["properties"] = {{"alarm", alarm}};
  return result;
}

void Log::add(const text::Diagnostic& one, const text::Source& checked) {
  const text::Source& in = one.elsewhere == nullptr ? checked : *one.elsewhere;
  Document result =
      result_of(one.id, one.severity, message_of(one), one.alarm, location(in.name(), region_of(one.span, in)));
  for (const text::DiagnosticNote& note : one.notes) {
    Document related = location(in.name(), region_of(note.span, in));
    related["message"] = {{"text", note.text}};
    result["relatedLocations"].push_back(std::move(related));
  }
  if (one.fix) {
    const Document replacement = {{"deletedRegion", region_of(one.fix->replaced, in)},
                                  {"insertedContent", {{"text", one.fix->text}}}};
    const Document change = {{"artifactLocation", artifact(in.name())},
                             {"replacements", Document::array({replacement})}};
    result["fixes"].push_back({{"artifactChanges", Document::array({change})}});
  }
  results_.push_back(std::move(result));
}

void Log::add(const checks::FindingList& findings, const app::CheckReport& report) {
  for (const checks::Finding& one : findings.kept()) {
    const bool is_called = one.place.program != 0 && one.place.program < report.programs.size();
    const std::string& name = is_called ? report.programs[one.place.program] : report.source.name();
    Document at = one.place.line == 0 ? Document{{"physicalLocation", {{"artifactLocation", artifact(name)}}}}
                                      : location(name, {{"startLine", one.place.line}});
    results_.push_back(result_of(one.id, one.severity, one.text, one.alarm, std::move(at)));
  }
}

void Log::add(const app::CheckReport& report) {
  text::DiagnosticFold fold;
  for (const text::Diagnostic& one : report.checks.diagnostics)
    if (fold.shows(one)) add(one, report.source);
  const auto notify = [&](std::string_view level, std::string sentence) {
    const Document at = {{"physicalLocation", {{"artifactLocation", artifact(report.source.name())}}}};
    notifications_.push_back(
        {{"level", level}, {"message", {{"text", std::move(sentence)}}}, {"locations", Document::array({at})}});
  };
  for (const text::DiagnosticFold::Row& row : fold.folded())
    notify("note", fmt::format("{} more of {} are not listed", row.more, text::row_of(row.id).name));
  checks::for_each_check(report.checks, [&](const auto& one) { add(one.findings, report); });
  for (const checks::NotChecked& one : checks::not_checked_of(report.checks))
    notify("note", "not checked: " + one.text);
  const bool passed = report.verdict == checks::Verdict::pass;
  notify(passed ? "note" : "warning", fmt::format("verdict {}", checks::name_of(report.verdict)));
}

Document Log::document(std::string_view version) const {
  const Document driver = {{"name", "dripfeed"}, {"version", version}, {"rules", rules_}};
  const Document invocation = {{"executionSuccessful", true}, {"toolExecutionNotifications", notifications_}};
  const Document run = {{"tool", {{"driver", driver}}},
                        {"columnKind", "unicodeCodePoints"},
                        {"newlineSequences", {"\n\r\r", "\r\n", "\n", "\r"}},
                        {"invocations", Document::array({invocation})},
                        {"results", results_}};
  return {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
          {"version", "2.1.0"},
          {"runs", Document::array({run})}};
}

}  // namespace

std::string sarif(std::span<const app::CheckReport> reports, std::string_view version) {
  Log log;
  for (const app::CheckReport& report : reports) log.add(report);
  return dump(log.document(version)) + "\n";
}

}  // namespace dripfeed::json
