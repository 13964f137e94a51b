// A count that is lower than it was has begun again, at nothing.
#include "server/app/lines/line_totals.h"

namespace dripfeed::app {

namespace {

template <class Number>
Number grown(Number now, Number before) {
  return now >= before ? now - before : now;
}

// A position stands in the line whose character is the next to be handed; those before it are whole.
std::uint64_t blocks_of(const LineReport& report) { return report.known.to_line > 0 ? report.known.to_line - 1 : 0; }

// Counts of a job: they are another one's with another arming.
void add_job(const LineReport& now, const LineReport& last, LineSums& sums) {
  static const LineReport kNone{};
  const LineReport& before = now.job == last.job && now.session == last.session ? last : kNone;
  sums.sent_bytes += grown(now.handed, before.handed);
  sums.confirmed_bytes += grown(now.confirmed, before.confirmed);
  sums.sent_blocks += grown(blocks_of(now), blocks_of(before));
  sums.holds += grown(now.holds, before.holds);
  sums.hold_s += grown(now.hold_s, before.hold_s);
}

// Counts of the line since it was made, or since its link is up.
void add_line(const LineReport& now, const LineReport& last, LineSums& sums) {
  sums.unarmed_starts += grown(now.unarmed_starts, last.unarmed_starts);
  sums.receptions += grown(now.received, last.received);
  sums.receptions_lost += grown(now.receptions_lost, last.receptions_lost);
  sums.errors.parity += grown(now.line_errors.parity, last.line_errors.parity);
  sums.errors.framing += grown(now.line_errors.framing, last.line_errors.framing);
  sums.errors.overrun += grown(now.line_errors.overrun, last.line_errors.overrun);
  sums.errors.breaks += grown(now.line_errors.breaks, last.line_errors.breaks);
}

}  // namespace

void LineTotals::look(const std::string& machine, const LineReport& report, std::int64_t wall_ms) {
  const std::lock_guard lock(mutex_);
  auto& [last, sums] = seen_[machine];
  const std::uint64_t sent_before = sums.sent_bytes;
  add_job(report, last, sums);
  add_line(report, last, sums);
  if (sums.sent_bytes != sent_before) sums.last_sent_ms = wall_ms;
  if (!report.stall.empty() && report.stall != last.stall) ++sums.stalls[report.stall];
  last = report;
}

std::map<std::string, LineSums> LineTotals::all() const {
  const std::lock_guard lock(mutex_);
  std::map<std::string, LineSums> all;
  for (const auto& [machine, seen] : seen_) all.emplace(machine, seen.sums);
  return all;
}

}  // namespace dripfeed::app
