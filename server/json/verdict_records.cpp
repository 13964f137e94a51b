// The report of a verdict is a document of its own: its members stand next to those of the row, which count.
#include "server/json/verdict_records.h"

#include "server/json/parse.h"

namespace dripfeed::json {

namespace {

Document verdict_document(const store::Verdict& verdict) {
  return {{"id", verdict.id},
          {"program", verdict.of.program},
          {"revision", verdict.of.revision},
          {"sha256", verdict.text_sha256},
          {"machine", verdict.of.machine},
          {"machine_revision", verdict.of.machine_revision},
          {"delivery", store::name_of(verdict.of.delivery)},
          {"verdict", store::name_of(verdict.of.outcome)},
          {"rules", text_or_null(verdict.rules)},
          {"stale", verdict.stale},
          {"created_by", verdict.created_by},
          {"created_at_ms", verdict.created_at_ms}};
}

Document waivers_document(const store::Verdict& verdict) {
  Document waivers = Document::array();
  for (const store::Waiver& waiver : verdict.waivers)
    waivers.push_back({{"name", waiver.name},
                       {"reason", waiver.reason},
                       {"at_ms", waiver.at_ms},
                       {"point", text_or_null(waiver.point)},
                       {"expires_at_ms", time_or_null(waiver.expires_at_ms)}});
  return waivers;
}

Document calls_document(const store::Verdict& verdict) {
  Document list = Document::array();
  for (const store::VerdictCall& call : verdict.of.calls)
    list.push_back({{"name", call.name}, {"program", call.program}, {"revision", call.revision}});
  return list;
}

}  // namespace

std::string verdict_summary(const store::Verdict& verdict) {
  Document document = verdict_document(verdict);
  document["calls"] = calls_document(verdict);
  document["points"] = verdict.of.points;
  document["waivers"] = waivers_document(verdict);
  return dump(document);
}

namespace {

void add_report(Document& document, std::string_view text) {
  const Document report = embedded(text);
  if (!report.is_object()) return;
  for (const auto& [name, value] : report.items())
    if (!document.contains(name)) document[name] = value;
}

}  // namespace

std::string preview_verdict(const app::CheckDone& done) {
  Document document = {{"verdict", store::name_of(done.outcome)}, {"points", done.points}};
  add_report(document, done.report);
  return dump(document);
}

std::string verdict(const store::Verdict& verdict) {
  Document document = verdict_document(verdict);
  add_report(document, verdict.of.report);
  document["calls"] = calls_document(verdict);
  document["points"] = verdict.of.points;
  document["waivers"] = waivers_document(verdict);
  return dump(document);
}

namespace {

// The part of a report that has the times of a whole program. A report of an earlier version has none.
std::optional<Document> whole_timing(std::string_view text) {
  const Document report = embedded(text);
  const auto timing = report.is_object() ? report.find("timing") : report.end();
  if (timing == report.end() || !timing->is_object() || !timing->value("whole", false)) return std::nullopt;
  return *timing;
}

}  // namespace

std::optional<double> cycle_s_of(std::string_view report) {
  const auto timing = whole_timing(report);
  const Document cycle = timing ? timing->value("cycle_s", Document(nullptr)) : Document(nullptr);
  return cycle.is_number() ? std::optional(cycle.get<double>()) : std::nullopt;
}

std::string job_forecast(const store::Job& job, const std::optional<store::Verdict>& verdict,
                         const checks::BufferSize& buffer) {
  const auto known = [](std::uint32_t value) { return value == 0 ? Document(nullptr) : Document(value); };
  Document document = {{"job", job.id},
                       {"verdict", nullptr},
                       {"stale", false},
                       {"cycle_s", nullptr},
                       {"course", Document::array()},
                       {"buffer_bytes", known(buffer.bytes)},
                       {"buffer_blocks", known(buffer.blocks)}};
  if (!verdict) return dump(document);
  document["verdict"] = verdict->id;
  document["stale"] = verdict->stale;
  const auto timing = whole_timing(verdict->of.report);
  if (!timing) return dump(document);
  document["cycle_s"] = timing->value("cycle_s", Document(nullptr));
  document["course"] = timing->value("course", Document::array());
  return dump(document);
}

}  // namespace dripfeed::json
