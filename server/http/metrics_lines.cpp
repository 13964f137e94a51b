// Lines and alarms. A counter begins at 0 with the server; a gauge of the job is there while there is a job.
#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <spdlog/spdlog.h>

#include "server/http/metrics.h"
#include "server/json/enumerators.h"

namespace dripfeed::http {

namespace {

using app::LineReport;
using app::LineState;
using app::LineSums;

struct Seen {
  const std::string& machine;
  const LineReport& report;
  const LineSums& sums;
};

bool has_job(const LineReport& report) {
  return report.job != 0 && report.end == app::JobEnd::none && report.state != LineState::idle &&
         report.state != LineState::disconnected;
}

std::optional<double> of(std::uint64_t count) { return static_cast<double>(count); }

// One value a machine, or none.
struct Row {
  std::string_view name;
  MetricType type;
  std::string_view help;
  std::optional<double> (*value)(const Seen&);
};

constexpr MetricType kCounter = MetricType::counter;
constexpr MetricType kGauge = MetricType::gauge;

constexpr std::array kRows = {
    Row{"dripfeed_line_link_up", kGauge, "1 while the link to the machine is up.",
        [](const Seen& seen) -> std::optional<double> {
          return seen.report.state != LineState::disconnected && seen.report.link_error.empty() ? 1.0 : 0.0;
        }},
    Row{"dripfeed_line_sent_bytes_total", kCounter,
        "Characters of jobs handed to the link since the server's start. It does not state what the control executed.",
        [](const Seen& seen) { return of(seen.sums.sent_bytes); }},
    Row{"dripfeed_line_confirmed_bytes_total", kCounter,
        "Characters of jobs that the line's protocol acknowledged; only of lines whose protocol does.",
        [](const Seen& seen) -> std::optional<double> {
          return seen.report.confirms ? of(seen.sums.confirmed_bytes) : std::nullopt;
        }},
    Row{"dripfeed_line_sent_blocks_total", kCounter,
        "Blocks (lines of the text) that were handed to the link with their ends; only where the link counts lines.",
        [](const Seen& seen) -> std::optional<double> {
          return seen.sums.sent_blocks > 0 || seen.report.char_s > 0.0 ? of(seen.sums.sent_blocks) : std::nullopt;
        }},
    Row{"dripfeed_line_holds_total", kCounter, "How often a control held its feed (DC3, or its handshake).",
        [](const Seen& seen) { return of(seen.sums.holds); }},
    Row{"dripfeed_line_hold_seconds_total", kCounter, "How long controls held their feeds.",
        [](const Seen& seen) -> std::optional<double> { return seen.sums.hold_s; }},
    Row{"dripfeed_line_unarmed_starts_total", kCounter,
        "How often a control asked for a program (DC1) while nothing was armed.",
        [](const Seen& seen) { return of(seen.sums.unarmed_starts); }},
    Row{"dripfeed_line_receptions_total", kCounter, "Programs that the control punched to us.",
        [](const Seen& seen) { return of(seen.sums.receptions); }},
    Row{"dripfeed_line_receptions_lost_total", kCounter, "Receptions that were not taken in time.",
        [](const Seen& seen) { return of(seen.sums.receptions_lost); }},
    Row{"dripfeed_line_last_sent_timestamp_seconds", kGauge,
        "When a character of a job was seen to leave last (Unix time); not there before the first one.",
        [](const Seen& seen) -> std::optional<double> {
          if (seen.sums.last_sent_ms == 0) return std::nullopt;
          return static_cast<double>(seen.sums.last_sent_ms) / 1e3;
        }},
    Row{"dripfeed_line_use_ratio", kGauge,
        "Share of the line's time that the job in progress used while it was not held, 0 to 1.",
        [](const Seen& seen) -> std::optional<double> {
          return has_job(seen.report) ? std::optional(seen.report.line_use) : std::nullopt;
        }},
    Row{"dripfeed_line_job_size_bytes", kGauge, "Characters of the job in progress.",
        [](const Seen& seen) { return has_job(seen.report) ? of(seen.report.total) : std::nullopt; }},
    Row{"dripfeed_line_job_sent_bytes", kGauge, "Characters of the job in progress that were handed to the link.",
        [](const Seen& seen) { return has_job(seen.report) ? of(seen.report.handed) : std::nullopt; }},
    Row{"dripfeed_line_job_block", kGauge,
        "Line of the text, from 1, to which the next character of the job in progress belongs.",
        [](const Seen& seen) {
          return has_job(seen.report) && seen.report.known.to_line > 0 ? of(seen.report.known.to_line) : std::nullopt;
        }},
};

void write_states(Exposition& out, std::span<const Seen> all) {
  out.family("dripfeed_line_state", kGauge, "1 for the state in which the machine's line is, 0 for the others.");
  for (const Seen& seen : all) {
    for (std::size_t i = 0; i < json::enumerators<LineState>(); ++i) {
      const auto state = static_cast<LineState>(i);
      out.sample({{"machine", seen.machine}, {"state", app::name_of(state)}},
                 std::uint64_t{seen.report.state == state ? 1U : 0U});
    }
  }
  out.family("dripfeed_line_stall", kGauge,
             "1, with the name of what the line waits for; not there while it waits for nothing.");
  for (const Seen& seen : all) {
    if (!seen.report.stall.empty())
      out.sample({{"machine", seen.machine}, {"stall", seen.report.stall}}, std::uint64_t{1});
  }
}

void write_jobs(Exposition& out, std::span<const Seen> all) {
  out.family("dripfeed_line_job_info", kGauge,
             "1, with the number of the job in progress; not there while there is none.");
  for (const Seen& seen : all) {
    if (has_job(seen.report))
      out.sample({{"machine", seen.machine}, {"job", std::to_string(seen.report.job)}}, std::uint64_t{1});
  }
}

void write_stalls(Exposition& out, std::span<const Seen> all) {
  out.family("dripfeed_line_stalls_total", kCounter,
             "How often the line was seen to begin to wait, by what it waited for.");
  for (const Seen& seen : all) {
    for (const auto& [stall, count] : seen.sums.stalls)
      out.sample({{"machine", seen.machine}, {"stall", stall}}, count);
  }
}

void write_errors(Exposition& out, std::span<const Seen> all) {
  out.family("dripfeed_line_errors_total", kCounter,
             "Errors that the serial port counted: parity, framing, overrun, break.");
  for (const Seen& seen : all) {
    const app::LineErrors& errors = seen.sums.errors;
    out.sample({{"machine", seen.machine}, {"error", "parity"}}, errors.parity);
    out.sample({{"machine", seen.machine}, {"error", "framing"}}, errors.framing);
    out.sample({{"machine", seen.machine}, {"error", "overrun"}}, errors.overrun);
    out.sample({{"machine", seen.machine}, {"error", "break"}}, errors.breaks);
  }
}

}  // namespace

void write_line_metrics(Exposition& out, app::Application& application) {
  const auto progress = application.events().snapshot();
  const auto sums = application.line_totals().all();
  static const LineSums kNone{};
  std::vector<Seen> all;
  for (const app::Progress& one : progress) {
    const auto known = sums.find(one.machine);
    all.push_back({.machine = one.machine, .report = one.report, .sums = known == sums.end() ? kNone : known->second});
  }
  write_states(out, all);
  for (const Row& row : kRows) {
    out.family(row.name, row.type, row.help);
    for (const Seen& seen : all) {
      if (const auto value = row.value(seen)) out.sample({{"machine", seen.machine}}, *value);
    }
  }
  write_jobs(out, all);
  write_stalls(out, all);
  write_errors(out, all);
}

// Where the store cannot say it there is no family: 0 would be a claim.
void write_alarm_metrics(Exposition& out, app::Application& application) {
  const auto open = application.store().alarms().count_open();
  if (!open) return spdlog::warn("metrics: open alarms: {}", store::message_of(open.error()));
  constexpr std::size_t kSeverities = json::enumerators<app::Severity>();
  std::map<std::string, std::array<std::uint64_t, kSeverities>> counts;
  for (const app::Progress& one : application.events().snapshot()) counts[one.machine] = {};
  for (const store::OpenAlarms& one : *open)
    counts[one.machine][static_cast<std::size_t>(app::severity_of(one.kind))] += one.count;
  out.family("dripfeed_alarms_open", kGauge, "Alarms that are not over, or that no person acknowledged.");
  for (const auto& [machine, by_severity] : counts) {
    for (std::size_t i = 0; i < kSeverities; ++i) {
      out.sample({{"machine", machine}, {"severity", app::name_of(static_cast<app::Severity>(i))}}, by_severity[i]);
    }
  }
}

}  // namespace dripfeed::http
