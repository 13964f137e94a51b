// Figures are doubles as the shortest decimal that reads back the same.
#include "server/json/reports.h"

#include <chrono>
#include <cmath>

#include "server/json/control_document.h"
#include "server/json/diagnostics.h"
#include "server/json/link_test.h"
#include "server/json/object_reader.h"
#include "server/json/sweep_report.h"
#include "server/json/wire.h"

namespace dripfeed::json {

namespace {

Document findings_document(const checks::FindingList& findings) {
  Document list = Document::array();
  for (const checks::Finding& one : findings.kept()) {
    list.push_back({{"id", text::row_of(one.id).name},
                    {"severity", text::name_of(one.severity)},
                    {"line", one.place.line},
                    {"program", one.place.program},  // an index into the report's programs; 0: the main one
                    {"value", one.value},
                    {"limit", one.limit},
                    {"text", one.text},
                    {"alarm", one.alarm.empty() ? Document(nullptr) : Document(one.alarm)}});
  }
  Document counts = Document::object();
  for (const checks::FindingList::Kind& kind : findings.kinds())
    counts[std::string(text::row_of(kind.id).name)] = kind.count;
  return {{"findings", std::move(list)}, {"counts", std::move(counts)}};
}

Document number_or_null(double value) { return std::isfinite(value) ? Document(value) : Document(nullptr); }

Document not_checked_document(const std::vector<checks::NotChecked>& list) { return not_checked_sentences(list); }

Document envelope_document(const envelope::Report& report) {
  Document document = findings_document(report.findings);
  document["moves"] = report.moves;
  Document travel = Document::object();
  for (std::size_t i = 0; i < ir::kAxisCount; ++i) {
    if (report.machine[i].empty()) continue;
    travel[std::string(kAxisWords[i])] = {number_or_null(report.machine[i].low),
                                          number_or_null(report.machine[i].high)};
  }
  document["machine_travel"] = std::move(travel);
  document["feed_max_mm_min"] = report.feed_max_mm_min;
  document["spindle_max_rpm"] = report.spindle_max_rpm;
  return document;
}

Document gouge_document(const gouge::Report& report) {
  Document document = findings_document(report.findings);
  document["rapids"] = report.rapids;
  document["cuts"] = report.cuts;
  document["deepest_rapid_mm"] = report.deepest_rapid_mm;
  document["deepest_cut_mm"] = report.deepest_cut_mm;
  return document;
}

Document figures_document(const accuracy::Figures& figures) {
  return {{"points", figures.points},        {"max_mm", figures.max_signed_mm},
          {"max_at_line", figures.max_line}, {"max_at", {figures.max_at.z, figures.max_at.x}},
          {"mean_mm", figures.mean_mm},      {"rmse_mm", figures.rmse_mm}};
}

Document accuracy_document(const accuracy::Report& report) {
  const accuracy::Figures& figures = report.figures();
  Document document = {{"blocks", report.blocks},
                       {"points", figures.points},
                       {"max_mm", figures.max_mm},
                       {"max_at_line", figures.max_line},
                       {"mean_mm", figures.mean_mm},
                       {"rmse_mm", figures.rmse_mm},
                       {"chord_bound_mm", report.chord_bound_mm ? Document(*report.chord_bound_mm) : Document(nullptr)},
                       {"measured", report.surface ? "surface" : "path"},
                       {"path", figures_document(report.path)},
                       {"surface", report.surface ? figures_document(*report.surface) : Document(nullptr)},
                       {"overrun_mm", report.overrun_mm},
                       {"covered", report.covered}};
  document.update(findings_document(report.findings));
  return document;
}

Document optional_document(const std::optional<double>& value) {
  return value ? number_or_null(*value) : Document(nullptr);
}

Document stretches_document(const timing::Report& report) {
  Document list = Document::array();
  for (const timing::Stretch& one : report.stretches) {
    list.push_back({{"limited_by", timing::name_of(one.limiter)},
                    {"first_line", one.first_line},
                    {"last_line", one.last_line},
                    {"start_s", one.start_s},
                    {"duration_s", one.duration_s}});
  }
  return list;
}

Document course_document(const timing::Report& report) {
  Document list = Document::array();
  for (const timing::CoursePoint& one : report.course) list.push_back({one.line, one.start_s});
  return list;
}

Document cmm_figures(const accuracy::CmmFigures& figures) {
  return {{"points", figures.points},   {"min_mm", figures.min_mm},   {"max_mm", figures.max_mm},
          {"mean_mm", figures.mean_mm}, {"rmse_mm", figures.rmse_mm}, {"max_at_row", figures.max_row}};
}

Document cmm_document(const accuracy::CmmReport& report) {
  Document document = cmm_figures(report.measured);
  if (!report.fitted) return document;
  document["best_fit"] = cmm_figures(*report.fitted);
  document["best_fit"]["shift_mm"] = {report.fit.shift.z, report.fit.shift.x};
  document["best_fit"]["turn_deg"] = report.fit.angle_deg;
  return document;
}

Document timing_document(const timing::Report& report) {
  Document limited = Document::object();
  for (std::size_t i = 0; i < timing::kLimiters; ++i)
    limited[std::string(timing::name_of(static_cast<timing::Limiter>(i)))] = report.limited_s[i];
  Document document = {
      {"blocks", report.blocks},
      {"cycle_s", report.cycle_s},
      {"motion_s", report.motion_s},
      {"compute_s", report.compute_s},
      {"line_s", report.line_s},
      {"stalls", report.stalls},
      {"stall_s", report.stall_s},
      {"first_stall_line", report.first_stall_line},
      {"compute_low_s", report.compute_s / report.cost_spread},
      {"compute_high_s", report.compute_s * report.cost_spread},
      {"compute_source", ir::name_of(report.cost_source)},
      {"compute_origin", report.cost_origin},
      {"standstill_s", report.standstill_s},
      {"first_stall_at_s", report.first_stall_at_s},
      {"longest_standstill_s", report.longest_stall_s},
      {"longest_standstill_line", report.longest_stall_line},
      {"first_move_s", report.first_move_s},
      {"rapid_s", report.rapid_s},
      {"path_mm", report.path_mm},
      {"blocks_per_s", report.cycle_s > 0.0 ? static_cast<double>(report.blocks) / report.cycle_s : 0.0},
      {"limited_s", std::move(limited)},
      {"whole", report.is_whole},
      {"course", course_document(report)},
      {"stretches", stretches_document(report)},
      {"stretch_count", report.stretch_count}};
  document["lowest_buffer_bytes"] = report.is_fed ? Document(report.lowest_buffer_bytes) : Document(nullptr);
  document["lowest_buffer_blocks"] = report.is_fed ? Document(report.lowest_buffer_blocks) : Document(nullptr);
  document["without_stall"] = {{"feed_share", optional_document(report.advice.feed_share)},
                               {"feed_mm_min", optional_document(report.advice.feed_mm_min)},
                               {"baud", optional_document(report.advice.baud)},
                               {"standard_baud", optional_document(report.advice.standard_baud)}};
  return document;
}

Document report_document(const app::CheckReport& report) {
  const checks::CheckReport& checks = report.checks;
  Document document = {{"dialect", report.dialect},
                       {"control", control_document(report)},
                       {"verdict", checks::name_of(report.verdict)},
                       {"diagnostics", Document::parse(diagnostics(checks.diagnostics, report.source))},
                       {"folded", Document::parse(folded_diagnostics(checks.diagnostics))},
                       {"blocks", report.blocks},
                       {"ran", report.ran},
                       {"timing", checks.timing ? timing_document(*checks.timing) : Document(nullptr)},
                       {"accuracy", checks.accuracy ? accuracy_document(*checks.accuracy) : Document(nullptr)},
                       {"envelope", checks.envelope ? envelope_document(*checks.envelope) : Document(nullptr)},
                       {"gouge", checks.gouge ? gouge_document(*checks.gouge) : Document(nullptr)}};
  document["not_checked"] = not_checked_document(checks::not_checked_of(checks));
  document["programs"] = report.programs;
  return document;
}

Document lines_document(const std::vector<app::NumberedLine>& lines) {
  Document list = Document::array();
  for (const app::NumberedLine& one : lines) list.push_back({{"line", one.number}, {"text", one.text}});
  return list;
}

Document answer_document(const app::LinesAnswer& answer) {
  Document changes = Document::array();
  for (const app::ChangedLines& one : answer.changes)
    changes.push_back({{"first", lines_document(one.first)}, {"second", lines_document(one.second)}});
  return {{"answer", app::name_of(answer.likeness)},
          {"why", text_or_null(answer.why)},
          {"changes", std::move(changes)},
          {"change_count", answer.change_count}};
}

Document line_or_null(std::uint32_t line) { return line == 0 ? Document(nullptr) : Document(line); }
Document or_null(std::optional<double> value) { return value ? Document(*value) : Document(nullptr); }

Document moves_document(const compile::MovesAnswer& moves) {
  return {{"answer", app::name_of(app::likeness_of(moves))},
          {"why", text_or_null(moves.why)},
          {"moves", moves.moves},
          {"first_line", line_or_null(moves.first_line)},
          {"second_line", line_or_null(moves.second_line)},
          {"first", text_or_null(moves.first)},
          {"second", text_or_null(moves.second)},
          {"deviation_mm", or_null(moves.deviation_mm)},
          {"deviation_deg", or_null(moves.deviation_deg)}};
}

Document side_document(const ComparedSide& side) {
  return {{"program", side.program}, {"name", side.name}, {"revision", id_or_null(side.revision)}};
}

// A side without a bound is null: the parameter's range ends there.
Document trial_document(const sweep::Trial& trial) {
  return {{"passes", trial.passes}, {"check", trial.check}, {"text", trial.text}};
}

Document side_document(const sweep::Side& side) {
  if (!side.is_bounded) return nullptr;
  return {{"fails_at", side.fails_at}, {"check", side.check}, {"text", side.text}};
}

Document share_document(const sweep::Share& share) { return {{"tried", share.tried}, {"passed", share.passed}}; }

Document example_document(const sweep::Report& report) {
  if (!report.smallest_failure) return nullptr;
  const sweep::Example& example = *report.smallest_failure;
  Document document = trial_document(example.trial);
  document["values"] = Document::object();
  document["changed"] = Document::array();
  for (std::size_t i = 0; i < report.parameters.size(); ++i)
    document["values"][report.parameters[i].name] = example.values[i];
  for (const std::size_t i : example.changed) document["changed"].push_back(report.parameters[i].name);
  return document;
}

Document link_test_document(const app::LinkTestResult& r, const machine::LineSettings& line) {
  const auto ms = [](feed::Time time) { return static_cast<double>(time.count()) / 1e6; };
  return {
      {"char_ms", ms(r.char_time)},
      {"latency_ms", {{"median", ms(r.latencies[r.latencies.size() / 2])}, {"worst", ms(r.latencies.back())}}},
      {"latency_chars", r.latency_chars},
      {"after_dc3",
       {{"holds", r.after_dc3.size()}, {"median", r.after_dc3[r.after_dc3.size() / 2]}, {"worst", r.after_dc3.back()}}},
      {"characters", r.characters},
      {"wrong", r.wrong},
      {"uart",
       {{"parity", r.errors.parity},
        {"framing", r.errors.framing},
        {"overrun", r.errors.overrun},
        {"breaks", r.errors.breaks}}},
      {"budget", {{"overrun", line.overrun_budget}, {"unsent", line.unsent}, {"latency_chars", line.latency_chars}}},
      {"kept", app::keeps_budget(r, line)}};
}

}  // namespace

std::vector<std::string> not_checked_sentences(const std::vector<checks::NotChecked>& list) {
  std::vector<std::string> sentences;
  for (const checks::NotChecked& one : list)
    sentences.push_back(one.line == 0 ? one.text : one.text + " (line " + std::to_string(one.line) + ")");
  return sentences;
}

std::string check_report(const app::CheckReport& report) { return dump(report_document(report)); }

std::string check_files(std::span<const app::CheckReport> reports) {
  Document files = Document::array();
  for (const app::CheckReport& report : reports) {
    Document file = {{"file", report.source.name()}};
    file.update(report_document(report));
    files.push_back(std::move(file));
  }
  return dump({{"files", std::move(files)}}) + "\n";
}

std::string time_figures(const timing::Report& report, bool validated) {
  Document document = timing_document(report);
  document["validated"] = validated;
  return dump(document) + "\n";
}
std::string accuracy_figures(const accuracy::Report& report, const std::optional<accuracy::CmmReport>& cmm,
                             bool validated) {
  Document document = accuracy_document(report);
  document["validated"] = validated;
  if (cmm) document["cmm"] = cmm_document(*cmm);
  document["not_checked"] = not_checked_document(report.not_checked.list());
  return dump(document) + "\n";
}

std::string gouge_figures(const gouge::Report& report, bool validated) {
  Document document = gouge_document(report);
  document["validated"] = validated;
  document["not_checked"] = not_checked_document(report.not_checked.list());
  return dump(document) + "\n";
}

std::string comparison(const app::Comparison& comparison) {
  return dump({{"text", answer_document(comparison.text)},
               {"meaning", answer_document(comparison.meaning)},
               {"motions", moves_document(comparison.moves)}});
}

std::string comparison(const std::string& compared, const ComparedSide& first, const ComparedSide& second) {
  const auto document = parse(compared);
  Document out = {{"first", side_document(first)}, {"second", side_document(second)}};
  if (document) out.update(*document);
  return dump(out);
}

std::string sweep_report(const sweep::Report& report) {
  Document parameters = Document::array();
  for (std::size_t i = 0; i < report.parameters.size(); ++i) {
    const sweep::Parameter& one = report.parameters[i];
    Document row = {
        {"name", one.name}, {"unit", one.unit}, {"low", one.low}, {"high", one.high}, {"standard", one.standard}};
    if (i < report.ranges.size()) {
      row["passes"] = {report.ranges[i].low.reach, report.ranges[i].high.reach};
      row["low_bound"] = side_document(report.ranges[i].low);
      row["high_bound"] = side_document(report.ranges[i].high);
    }
    parameters.push_back(std::move(row));
  }
  return dump({{"parameters", std::move(parameters)},
               {"standard", trial_document(report.standard)},
               {"corners", share_document(report.corners)},
               {"samples", share_document(report.samples)},
               {"smallest_failure", example_document(report)},
               {"trials", report.trials}}) +
         "\n";
}

std::string link_test(const app::LinkTestResult& result, const machine::LineSettings& line) {
  return dump(link_test_document(result, line));
}

std::string line_test(const std::expected<app::LinkTestResult, app::LinkTestFault>& done,
                      const machine::LineSettings& line) {
  if (!done) return dump({{"fault", done.error().text}, {"fault_id", done.error().id}, {"result", nullptr}});
  return dump({{"fault", nullptr}, {"fault_id", nullptr}, {"result", link_test_document(*done, line)}});
}

std::string wire(const app::WireTap::Batch& batch, const tape_code::DecodeTable& code, const app::Clock& clock) {
  const feed::Time now = clock.now();
  const std::int64_t wall_ms = clock.wall_ms();
  const auto ms = [&](feed::Time at) {
    return wall_ms - std::chrono::duration_cast<std::chrono::milliseconds>(now - at).count();
  };
  Document runs = Document::array();
  for (const WireRun& run : wire_runs(batch, code)) {
    runs.push_back({{"kind", app::name_of(run.kind)},
                    {"at_ms", ms(run.from)},
                    {"to_ms", ms(run.to)},
                    {"text", run.text},
                    {"hex", run.hex},
                    {"wrong", run.wrong}});
  }
  return dump({{"from", batch.from}, {"lost", batch.lost}, {"runs", std::move(runs)}});
}

}  // namespace dripfeed::json
