// Member order is the order of reading; times are milliseconds since 1970, 0 is shown as null.
#include "server/json/records.h"

#include "server/app/base/wall_time.h"
#include "server/json/diagnostics.h"
#include "server/json/history.h"
#include "server/json/object_reader.h"
#include "server/json/sentences.h"

namespace dripfeed::json {

namespace {

Document machine_document(const std::optional<app::MachineReport>& machine) {
  if (!machine) return nullptr;
  return {{"state", machine->state}, {"program", machine->program}, {"line", machine->line}, {"alarm", machine->alarm}};
}

// The system's own words have none of their own.
std::string_view link_error_id(std::string_view error) {
  if (error.empty()) return {};
  const auto found = sentence_of(error);
  return found ? found->id : "system";
}

Document status_document(const app::MachineStatus& status) {
  const app::LineReport& r = status.report;
  // The kinds of the alarms that say the same.
  const app::AlarmKind note = r.link_note == app::kFloodNote ? app::AlarmKind::line_flooded : app::AlarmKind::link_note;
  const std::string_view note_id = r.link_note.empty() ? std::string_view() : app::row_of(note).name;
  Document waits = nullptr;
  if (status.needs_confirmation)
    waits = {{"job", id_or_null(status.needs_confirmation->job)},
             {"text", status.needs_confirmation->text},
             {"said", sentence_or_null(status.needs_confirmation->text)},
             {"reason_id", text_or_null(status.needs_confirmation->reason_id)}};
  return {{"line", app::name_of(r.state)},
          {"stall", text_or_null(r.stall)},
          {"stop_wanted", r.stop_wanted},
          {"link_error", text_or_null(r.link_error)},
          {"link_error_id", text_or_null(link_error_id(r.link_error))},
          {"link_error_said", sentence_or_null(r.link_error)},
          {"link_note", text_or_null(r.link_note)},
          {"link_note_id", text_or_null(note_id)},
          {"line_errors",
           {{"parity", r.line_errors.parity},
            {"framing", r.line_errors.framing},
            {"overrun", r.line_errors.overrun},
            {"breaks", r.line_errors.breaks}}},
          {"asks_since_ms", time_or_null(status.asks.since_ms)},
          {"asks", status.asks.count},
          {"job", r.job == 0 ? Document(nullptr) : Document(r.job)},
          {"handed", r.handed},
          {"clocked", r.clocked},
          {"confirmed", r.confirmed},
          {"confirms", r.confirms},
          {"estimated", r.estimated},
          {"total", r.total},
          {"block_from", r.known.from_line},
          {"block", r.known.to_line},
          {"holds", r.holds},
          {"hold_s", r.hold_s},
          {"line_use", r.line_use},
          {"plc", machine_document(r.machine)},
          {"program", status.program},
          {"block_text", status.block_text},
          {"needs_confirmation", waits}};
}

// A member of a kept document; "" where it is not what it should be.
std::string text_at(const Document& document, const char* name) {
  if (!document.is_object()) return {};
  const auto found = document.find(name);
  return found != document.end() && found->is_string() ? found->get<std::string>() : std::string();
}

// One of kReadBackStates.
std::string_view read_back_state(std::string_view read_back) {
  return read_back.substr(0, read_back.find_first_of(" :"));
}

Document restart_document(const store::RestartOf& restart) {
  if (!restart.is_one()) return nullptr;
  return {{"release", restart.release}, {"line", restart.line}};
}

Document seconds_or_null(std::optional<std::int64_t> ms) {
  return ms ? Document(static_cast<double>(*ms) / 1e3) : Document(nullptr);
}

Document hold_document(const store::Job& job) {
  if (job.hold_by.empty()) return nullptr;
  return {{"by", job.hold_by}, {"reason", job.hold_reason}};
}

Document job_document(const store::Job& job) {
  return {{"id", job.id},
          {"state", store::name_of(job.state)},
          {"machine", job.machine},
          {"release", job.release},
          {"order", job.order == 0 ? Document(nullptr) : Document(job.order)},
          {"restart", restart_document(job.restart)},
          {"program", job.program},
          {"revision", job.revision},
          {"sha256", job.text_sha256},
          {"delivery", store::name_of(job.delivery)},
          {"link", job.link},
          {"bytes", job.bytes_total},
          {"reason", job.reason},
          {"reason_id", text_or_null(job.reason_id)},
          {"reason_said", sentence_or_null(job.reason)},
          {"rank", job.rank},
          {"created_by", job.created_by},
          {"created_at_ms", job.created_at_ms},
          {"armed_by", text_or_null(job.armed_by)},
          {"armed_at_ms", time_or_null(job.armed_at_ms)},
          {"expires_at_ms", time_or_null(job.expires_at_ms)},
          {"started_at_ms", time_or_null(job.started_at_ms)},
          {"ended_at_ms", time_or_null(job.ended_at_ms)},
          {"torn", job.torn},
          {"needs_confirmation", job.needs_confirmation()},
          {"confirmed_by", text_or_null(job.confirmed_by)},
          {"confirm_reason", text_or_null(job.confirm_reason)},
          {"read_back", text_or_null(job.read_back)},
          {"read_back_state", text_or_null(read_back_state(job.read_back))},
          {"held_s", seconds_or_null(job.held_ms)},
          {"holds", job.holds ? Document(*job.holds) : Document(nullptr)},
          {"line_s", seconds_or_null(job.line_ms)},
          {"forecast_s", seconds_or_null(job.forecast_ms)},
          {"not_before_ms", time_or_null(job.not_before_ms)},
          {"on_hold", hold_document(job)},
          {"retry_of", id_or_null(job.retry_of)},
          {"choice", id_or_null(job.choice)},
          {"end_check", text_or_null(job.end_check)},
          {"needs_end_confirmation", job.needs_end_confirmation()},
          {"end_confirmed_by", text_or_null(job.end_confirmed_by)},
          {"end_confirmed_at_ms", time_or_null(job.end_confirmed_at_ms)},
          {"end_note", text_or_null(job.end_note)}};
}

Document likeness_document(const std::optional<app::StoredLikeness>& likeness) {
  if (!likeness) return nullptr;
  return {{"program", likeness->program},
          {"revision", likeness->revision},
          {"same", likeness->same},
          {"difference", text_or_null(likeness->difference)}};
}

}  // namespace

std::string list(std::span<const std::string> items, std::string_view next) {
  std::string out = "{\"items\":[";
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) out += ',';
    out += items[i];
  }
  return out + "],\"next\":" + dump(text_or_null(next)) + "}";
}

std::string machine_status(const app::MachineStatus& status) { return dump(status_document(status)); }

std::string machine(const store::Machine& machine, const app::MachineStatus& status) {
  return dump({{"name", machine.name},
               {"revision", machine.revision},
               {"profile", embedded(machine.profile)},
               {"status", status_document(status)}});
}

ProfileHead profile_head(std::string_view text) {
  const Document profile = embedded(text);
  const bool has_link = profile.is_object() && profile.contains("link");
  return {.title = text_at(profile, "title"),
          .dialect = text_at(profile, "dialect"),
          .kind = text_at(profile, "kind"),
          .link = has_link ? text_at(profile["link"], "url") : ""};
}

std::string machine_summary(const store::Machine& machine, const ProfileHead& head, const app::MachineStatus& status) {
  return dump({{"name", machine.name},
               {"revision", machine.revision},
               {"title", head.title},
               {"dialect", head.dialect},
               {"kind", head.kind},
               {"link", head.link},
               {"status", status_document(status)}});
}

std::string work(const app::Work& work) {
  const bool runs = work.running_since_ms != 0;
  return dump({{"id", work.id},
               {"kind", work.name.kind},
               {"subject", work.name.subject},
               {"machine", work.name.machine},
               {"actor", work.name.actor},
               {"state", app::kWorkStates[runs ? 1 : 0]},
               {"place", runs ? Document(nullptr) : Document(work.place)},
               {"waiting_since_ms", work.waiting_since_ms},
               {"running_since_ms", runs ? Document(work.running_since_ms) : Document(nullptr)},
               {"budget_s", work.budget_s == 0 ? Document(nullptr) : Document(work.budget_s)}});
}

std::string log_line(std::int64_t at_ms, std::string_view level, std::string_view text) {
  return dump({{"time", app::rfc3339(at_ms)}, {"level", level}, {"text", text}});
}

std::string node(const store::Node& node, std::span<const store::Lease> leases, bool is_this) {
  Document machines = Document::array();
  for (const store::Lease& lease : leases) {
    machines.push_back({{"name", lease.machine},
                        {"lease", lease.number},
                        {"since_ms", lease.since_ms},
                        {"given_by", lease.given_by},
                        {"reason", text_or_null(lease.reason)}});
  }
  return dump({{"name", node.name},
               {"this", is_this},
               {"url", text_or_null(node.url)},
               {"version", text_or_null(node.version)},
               {"answers", node.is_heard},
               {"started_at_ms", node.started_at_ms},
               {"seen_at_ms", node.seen_at_ms},
               {"machines", std::move(machines)}});
}

std::string release(const store::Release& release) {
  return dump({{"id", release.id},
               {"state", store::name_of(release.state)},
               {"program", release.of.program},
               {"revision", release.of.revision},
               {"machine", release.of.machine},
               {"delivery", store::name_of(release.of.delivery)},
               {"sha256", release.text_sha256},
               {"restart", restart_document(release.of.restart)},
               {"transfers_allowed", release.transfers_allowed},
               {"transfers_done", release.transfers_done},
               {"proved_by", text_or_null(release.proved_by)},
               {"proof", text_or_null(release.proof)},
               {"created_by", release.created_by},
               {"created_at_ms", release.created_at_ms},
               {"approved_by", text_or_null(release.approved_by)},
               {"sign_off", text_or_null(release.sign_off)},
               {"changed_at_ms", release.changed_at_ms}});
}

std::string job(const store::Job& job) { return dump(job_document(job)); }

std::string ledger(std::span<const store::LedgerRow> rows, std::string_view next, const store::LedgerInterval& interval,
                   bool confirms) {
  Document items = Document::array();
  for (const store::LedgerRow& row : rows) {
    items.push_back({{"seq", row.seq},
                     {"at_ms", row.at_ms},
                     {"handed", row.counts.handed},
                     {"clocked", row.counts.clocked},
                     {"confirmed", row.counts.confirmed},
                     {"reserve", row.counts.reserve},
                     {"note", row.note}});
  }
  return dump(
      {{"items", std::move(items)},
       {"next", text_or_null(next)},
       {"interval", {{"low", interval.low}, {"high", interval.high}, {"known", confirms ? "confirmed" : "clocked"}}}});
}

std::string receipt(const store::Receipt& receipt, const std::optional<app::StoredLikeness>& stored) {
  return dump({{"id", receipt.id},
               {"machine", receipt.of.machine},
               {"at_ms", receipt.at_ms},
               {"name", receipt.of.name},
               {"named_by", receipt.of.style},
               {"state", store::name_of(receipt.state)},
               {"reason", text_or_null(receipt.of.reason)},
               {"sha256", receipt.of.sha256},
               {"bytes", receipt.bytes},
               {"raw_bytes", receipt.of.raw_bytes},
               {"code", receipt.of.code},
               {"ended_by", receipt.of.ended_by},
               {"stored", likeness_document(stored)},
               {"program", receipt.program == 0 ? Document(nullptr) : Document(receipt.program)},
               {"revision", receipt.revision == 0 ? Document(nullptr) : Document(receipt.revision)},
               {"decided_by", text_or_null(receipt.decided_by)},
               {"decided_reason", text_or_null(receipt.decided_reason)},
               {"decided_at_ms", time_or_null(receipt.decided_at_ms)}});
}

std::string request(const store::Request& request) {
  return dump({{"id", request.id},
               {"machine", request.of.machine},
               {"at_ms", request.at_ms},
               {"verb", request.of.verb},
               {"argument", request.of.argument},
               {"text", request.of.text},
               {"outcome", request.of.outcome},
               {"detail", request.of.detail},
               {"job", request.of.job == 0 ? Document(nullptr) : Document(request.of.job)}});
}

std::string alarm(const store::Alarm& alarm) {
  return dump({{"id", id_or_null(alarm.id)},
               {"machine", alarm.machine},
               {"kind", alarm.kind},
               {"text", alarm.text},
               {"said", sentence_or_null(alarm.text)},
               {"count", alarm.count},
               {"severity", app::name_of(app::severity_of(alarm.kind))},
               {"raised_at_ms", alarm.raised_at_ms},
               {"last_at_ms", alarm.last_at_ms},
               {"cleared_at_ms", time_or_null(alarm.cleared_at_ms)},
               {"acknowledged_by", text_or_null(alarm.acknowledged_by)},
               {"acknowledged_at_ms", time_or_null(alarm.acknowledged_at_ms)},
               {"shelved_by", text_or_null(alarm.shelved_by)},
               {"shelved_until_ms", time_or_null(alarm.shelved_until_ms)},
               {"shelf_reason", text_or_null(alarm.shelf_reason)},
               {"job", id_or_null(alarm.job)}});
}

namespace {

Document line_document(const app::ProgramLine& line) {
  Document document = {{"line", line.line},
                       {"text", line.text},
                       {"family_line", nullptr},
                       {"family_text", nullptr},
                       {"values", nullptr}};
  if (line.family_line) document["family_line"] = *line.family_line;
  if (line.family_text) document["family_text"] = *line.family_text;
  if (!line.values) return document;
  Document values = Document::object();
  for (const auto& [name, value] : *line.values) values[name] = value;
  document["values"] = std::move(values);
  return document;
}

}  // namespace

std::string program_lines(std::uint64_t from, const app::ProgramLines& found) {
  Document lines = Document::array();
  for (const app::ProgramLine& line : found.lines) lines.push_back(line_document(line));
  return dump({{"from", from}, {"count_all", found.count_all}, {"lines", std::move(lines)}});
}

std::string utilisation(std::span<const app::DayOfUse> days) {
  Document all = Document::array();
  for (const app::DayOfUse& day : days) {
    all.push_back({{"day", day.day},
                   {"from_ms", day.from_ms},
                   {"to_ms", day.to_ms},
                   {"feeding_s", day.feeding_s},
                   {"held_s", day.held_s ? Document(*day.held_s) : Document(nullptr)},
                   {"jobs_done", day.jobs_done},
                   {"jobs_failed", day.jobs_failed},
                   {"jobs_cancelled", day.jobs_cancelled},
                   {"bytes", day.bytes}});
  }
  return dump({{"days", std::move(all)}});
}

namespace {

Document sums_document(const app::Sums& sums) {
  Document document = Document::object();
  for (const SumCount& row : sum_counts()) document[std::string(row.name)] = sums.*row.member;
  for (const SumTime& row : sum_times()) document[std::string(row.name)] = static_cast<double>(sums.*row.member) / 1e3;
  const auto use = line_use_of(sums);
  document["line_use"] = use ? Document(*use) : Document(nullptr);
  return document;
}

}  // namespace

std::string history_sums(const app::HistorySums& sums, app::SumsBy by) {
  Document groups = Document::array();
  for (const app::SumGroup& group : sums.groups) {
    Document document = {
        {"name", group.name}, {"from_ms", time_or_null(group.from_ms)}, {"to_ms", time_or_null(group.to_ms)}};
    document.update(sums_document(group.sums));
    groups.push_back(std::move(document));
  }
  return dump({{"by", app::kSumsByNames[static_cast<std::size_t>(by)]},
               {"all", sums_document(sums.all)},
               {"groups", std::move(groups)}});
}

std::string_view event_name(app::EventKind kind) {
  static constexpr std::string_view kNames[] = {"job", "machine", "verdict", "alarm", "receipt"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string event_data(const app::Event& event) {
  if (event.kind == app::EventKind::job) return dump(job_document(event.job));
  if (event.kind == app::EventKind::verdict) {
    return dump({{"id", event.verdict},
                 {"verdict", store::name_of(event.outcome)},
                 {"machine", event.machine},
                 {"text", event.text}});
  }
  if (event.kind == app::EventKind::alarm) return alarm(event.alarm);
  if (event.kind == app::EventKind::receipt) return dump({{"machine", event.machine}, {"text", event.text}});
  Document machine = {{"name", event.machine}};
  if (!event.text.empty()) machine["stall"] = event.text;
  return dump(machine);
}

std::string progress(std::string_view machine, const app::MachineStatus& status) {
  Document document = {{"machine", machine}};
  document.update(status_document(status));
  document.erase("needs_confirmation");
  return dump(document);
}

std::string problem(const ProblemCode& code, const app::Error& error) {
  Document document = {{"type", "about:blank"}, {"title", code.title},  {"status", code.status},
                       {"code", code.code},     {"detail", error.text}, {"said", sentence_or_null(error.text)}};
  Document errors = Document::array();
  for (const app::ErrorPlace& place : error.places) {
    Document one = Document::object();
    if (!place.pointer.empty()) one["pointer"] = place.pointer;
    if (place.line > 0) one["line"] = place.line;
    if (place.line > 0) one["column"] = place.column;
    one["text"] = place.text;
    errors.push_back(std::move(one));
  }
  if (!errors.empty()) document["errors"] = std::move(errors);
  return dump(document);
}

}  // namespace dripfeed::json
