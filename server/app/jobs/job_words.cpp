// The interval is always named: no sentence says that something was executed.
#include "server/app/jobs/job_words.h"

#include <array>

#include <fmt/format.h>

namespace dripfeed::app {

namespace {

// The protocol's own word for the end; where it has none, as at a person's cancel of a block transfer, how it ended.
std::string_view cause_of(const LineReport& report) {
  static constexpr std::array<std::string_view, 5> kEnds = {"", "done", "failed", "cancelled", "disarmed"};
  return report.cause.empty() ? kEnds[static_cast<std::size_t>(report.end)] : report.cause;
}

}  // namespace

std::string reason_of(const LineReport& report) {
  if (report.end == JobEnd::none || report.end == JobEnd::done) return std::string(report.stall);
  if (report.end == JobEnd::disarmed) return fmt::format("disarmed, nothing was sent: {}", cause_of(report));
  std::string reason = report.handed == 0
                           ? fmt::format("{}: nothing was sent", cause_of(report))
                           : fmt::format("{}: between wire byte {} and {} of {} may have reached the control",
                                         cause_of(report), report.known.from, report.known.to, report.total);
  if (report.handed > 0 && report.known.from_line > 0)
    reason += fmt::format(" (line {} to {})", report.known.from_line, report.known.to_line);
  if (report.machine && report.machine->alarm > 0) reason += "; " + alarm_text(*report.machine);
  if (report.state == LineState::torn) reason += "; a block is torn: reset the control and confirm it";
  if (!report.link_error.empty()) reason += fmt::format("; {}", report.link_error);
  return reason;
}

std::string reason_id_of(const LineReport& report) {
  const bool over = report.end != JobEnd::none && report.end != JobEnd::done;
  return std::string(over ? cause_of(report) : report.stall);
}

std::string new_alarm(const LineReport& report, const LineReport& last) {
  if (!report.machine || report.machine->alarm == 0) return {};
  if (last.machine && last.machine->alarm == report.machine->alarm) return {};
  return alarm_text(*report.machine);
}

}  // namespace dripfeed::app
