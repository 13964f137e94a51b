// Days begin at midnight of the server's own clock, and may have 23 or 25 hours.
#include "server/app/jobs/utilisation.h"

#include <algorithm>
#include <ranges>
#include <utility>

#include "server/app/jobs/shifts.h"

namespace dripfeed::app {

namespace {

// When the line was free of it, as far as is known.
std::int64_t end_of(const store::JobUse& use, std::int64_t now_ms) {
  if (use.job.ended_at_ms == 0) return now_ms;
  if (use.job.state != store::JobState::interrupted) return use.job.ended_at_ms;
  return std::max(use.ledger_at_ms, use.job.started_at_ms);
}

void add_time(const store::JobUse& use, std::int64_t now_ms, DayOfUse& day) {
  if (use.job.started_at_ms == 0) return;
  const std::int64_t end_ms = end_of(use, now_ms);
  const std::int64_t in_ms = std::max(use.job.started_at_ms, day.from_ms);
  const std::int64_t out_ms = std::min(end_ms, day.to_ms);
  if (out_ms <= in_ms) return;
  day.feeding_s += static_cast<double>(out_ms - in_ms) / 1e3;
  const bool whole = use.job.started_at_ms >= day.from_ms && end_ms <= day.to_ms;
  const bool known = use.job.held_ms && (whole || *use.job.held_ms == 0);
  if (!known) day.held_s.reset();
  if (known && day.held_s) *day.held_s += static_cast<double>(*use.job.held_ms) / 1e3;
}

void add_end(const store::JobUse& use, std::int64_t now_ms, DayOfUse& day) {
  const bool is_on = use.job.ended_at_ms == 0;
  const std::int64_t at_ms = is_on ? now_ms : use.job.ended_at_ms;
  if (at_ms < day.from_ms || at_ms >= day.to_ms) return;
  day.bytes += use.clocked;
  if (use.job.state == store::JobState::done) ++day.jobs_done;
  if (use.job.state == store::JobState::cancelled) ++day.jobs_cancelled;
  if (use.job.state == store::JobState::failed || use.job.state == store::JobState::interrupted) ++day.jobs_failed;
}

}  // namespace

Result<std::vector<DayOfUse>> utilisation(store::Store& store, const std::string& machine, std::uint32_t days,
                                          std::int64_t now_ms) {
  if (const auto known = lift(store.machines().get(machine)); !known) return std::unexpected(known.error());
  std::vector<DayOfUse> all(days);
  // Backwards: the moment before a day is in the one before it.
  std::int64_t in_ms = now_ms;
  for (DayOfUse& day : all | std::views::reverse) {
    LocalTime time = day_of(in_ms);
    day.day = std::move(time.name);
    day.from_ms = time.from_ms;
    day.to_ms = time.to_ms;
    in_ms = time.from_ms - 1;
  }
  const auto used = lift(store.jobs().used(machine, all.front().from_ms, all.back().to_ms));
  if (!used) return std::unexpected(used.error());
  for (DayOfUse& day : all) {
    for (const store::JobUse& use : *used) {
      add_time(use, now_ms, day);
      add_end(use, now_ms, day);
    }
  }
  return all;
}

}  // namespace dripfeed::app
