// Days begin at midnight of the server's own clock, and may have 23 or 25 hours.
#include "server/app/jobs/utilisation.h"

#include <algorithm>
#include <ctime>

#include <fmt/format.h>

namespace dripfeed::app {

namespace {

std::tm local_of(std::int64_t at_ms) {
  const std::time_t seconds = static_cast<std::time_t>(at_ms / 1000);
  std::tm local{};
  ::localtime_r(&seconds, &local);
  return local;
}

// Midnight at the begin of the day that is so many days after that of `at_ms`.
std::int64_t midnight(std::int64_t at_ms, int days_after) {
  std::tm day = local_of(at_ms);
  day.tm_sec = day.tm_min = day.tm_hour = 0;
  day.tm_mday += days_after;
  day.tm_isdst = -1;
  return static_cast<std::int64_t>(std::mktime(&day)) * 1000;
}

std::string name_of_day(std::int64_t from_ms) {
  const std::tm day = local_of(from_ms);
  return fmt::format("{:04}-{:02}-{:02}", day.tm_year + 1900, day.tm_mon + 1, day.tm_mday);
}

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
  for (std::uint32_t i = 0; i < days; ++i) {
    const int after = static_cast<int>(i) - static_cast<int>(days) + 1;
    all[i].from_ms = midnight(now_ms, after);
    all[i].to_ms = midnight(now_ms, after + 1);
    all[i].day = name_of_day(all[i].from_ms);
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
