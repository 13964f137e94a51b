// A round: look at every line, commit what changed and what may follow, tell the lines, then move the jobs. The order
// matters: a feed is given only what is committed, and a job ends only after its last row is written.
#include "server/app/keeper.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <deque>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

namespace dripfeed::app {

namespace {

constexpr std::chrono::milliseconds kRound{100};
constexpr std::string_view kActor = "dripfeed";

// What the job's state should be for a line that runs, and for a job that ended.
std::optional<store::JobState> target_of(const LineReport& report) {
  struct EndRow {
    JobEnd end;
    store::JobState job;
  };
  static constexpr std::array kEnds = {
      EndRow{JobEnd::done, store::JobState::done}, EndRow{JobEnd::failed, store::JobState::failed},
      EndRow{JobEnd::cancelled, store::JobState::cancelled},
      EndRow{JobEnd::disarmed, store::JobState::queued},  // nothing of it was sent
  };
  for (const EndRow& row : kEnds) {
    if (row.end == report.end) return row.job;
  }
  struct LineRow {
    LineState line;
    store::JobState job;
  };
  static constexpr std::array kLines = {
      LineRow{LineState::armed, store::JobState::armed},
      LineRow{LineState::feeding, store::JobState::feeding},
      LineRow{LineState::held, store::JobState::held},
      LineRow{LineState::draining, store::JobState::draining},
  };
  for (const LineRow& row : kLines) {
    if (row.line == report.state) return row.job;
  }
  return std::nullopt;
}

// The shortest allowed way from one state to another: a line may have passed through several between two rounds.
std::vector<store::JobState> way(store::JobState from, store::JobState to) {
  std::array<std::optional<store::JobState>, store::kJobStates> before;
  std::deque<store::JobState> next = {from};
  while (!next.empty() && next.front() != to) {
    const store::JobState here = next.front();
    next.pop_front();
    for (const store::JobTransition& step : store::job_transitions()) {
      if (step.from != here || step.to == from || before[static_cast<std::size_t>(step.to)]) continue;
      before[static_cast<std::size_t>(step.to)] = here;
      next.push_back(step.to);
    }
  }
  std::vector<store::JobState> steps;
  for (store::JobState at = to; at != from && before[static_cast<std::size_t>(at)];
       at = *before[static_cast<std::size_t>(at)]) {
    steps.insert(steps.begin(), at);
  }
  return steps;
}

std::string reason_of(const LineReport& report) {
  if (report.end == JobEnd::none || report.end == JobEnd::done) return std::string(report.stall);
  std::string reason = fmt::format("{}: between wire byte {} and {} of {} may have reached the control", report.cause,
                                   report.known.from, report.known.to, report.total);
  if (report.known.from_line > 0)
    reason += fmt::format(" (line {} to {})", report.known.from_line, report.known.to_line);
  if (report.state == LineState::torn) reason += "; a block is torn: reset the control and confirm it";
  if (!report.link_error.empty()) reason += fmt::format("; {}", report.link_error);
  return reason;
}

bool same_counts(const store::LedgerCounts& a, const store::LedgerCounts& b) {
  return a.handed == b.handed && a.clocked == b.clocked && a.confirmed == b.confirmed && a.reserve == b.reserve;
}

}  // namespace

std::uint64_t reserve_window(const LineReport& report) {
  if (report.char_s <= 0.0) return kReserveOfBlocks;
  return std::max(kReserveAtLeast, static_cast<std::uint64_t>(kReserveAhead_s / report.char_s));
}

Keeper::Keeper(store::Store& store, Lines& lines, Events& events, const Clock& clock)
    : store_(store), lines_(lines), events_(events), clock_(clock), thread_([this](const std::stop_token& stop) {
        loop(stop);
      }) {}

Keeper::~Keeper() {
  thread_.request_stop();
  thread_.join();
  round();
}

void Keeper::wake() {
  const std::lock_guard lock(wake_mutex_);
  due_ = true;
  woken_.notify_one();
}

void Keeper::set_source(const std::string& machine, std::shared_ptr<ContentSource> source) {
  const std::lock_guard lock(sources_mutex_);
  sources_[machine] = std::move(source);
}

void Keeper::loop(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    {
      std::unique_lock lock(wake_mutex_);
      woken_.wait_for(lock, stop, kRound, [this] { return due_; });
      due_ = false;
    }
    round();
  }
}

void Keeper::round() {
  const std::lock_guard lock(round_mutex_);
  {
    const std::lock_guard sources_lock(sources_mutex_);
    for (const auto& [machine, source] : sources_) source->refill();
  }
  std::vector<Due> all;
  for (auto& [machine, line] : lines_.all()) all.push_back({machine, line, line->report()});
  for (const Due& due : all) begin(tracked_[due.machine], due);

  const std::vector<store::NewLedgerRow> rows = rows_of(all);
  if (!rows.empty()) {
    const auto refused = store_.ledger().append(rows, clock_.wall_ms());
    if (!refused) {
      // Nothing is reserved, so the feeds stop at what they have and say that they wait for the ledger.
      spdlog::error("ledger: {}", store::message_of(refused.error()));
      return;
    }
    for (const store::LedgerFault& fault : *refused) spdlog::error("ledger: job {}: {}", fault.job, fault.why);
    for (const Due& due : all) {
      Tracked& tracked = tracked_[due.machine];
      const auto row = std::ranges::find(rows, tracked.job.id, &store::NewLedgerRow::job);
      if (row == rows.end() || std::ranges::find(*refused, tracked.job.id, &store::LedgerFault::job) != refused->end())
        continue;
      tracked.committed = row->counts;
      due.line->extend_reserve(tracked.job.id, row->counts.reserve);
    }
  }
  for (const Due& due : all) follow(tracked_[due.machine], due);
}

// A job that the line has and the books do not know yet.
void Keeper::begin(Tracked& tracked, const Due& due) {
  // A disarmed job may come again.
  const bool again = tracked.over && due.report.end == JobEnd::none;
  if (due.report.job == 0 || (due.report.job == tracked.job.id && !again)) return;
  const auto job = store_.jobs().get(due.report.job);
  const auto interval = store_.ledger().interval(due.report.job);
  if (!job || !interval) {
    spdlog::error("{}: job {} is on the line and not in the store", due.machine, due.report.job);
    return;
  }
  tracked.job = *job;
  tracked.committed = interval->last;
  tracked.over = store::ended(job->state);
}

std::vector<store::NewLedgerRow> Keeper::rows_of(const std::vector<Due>& all) {
  std::vector<store::NewLedgerRow> rows;
  for (const Due& due : all) {
    const Tracked& tracked = tracked_[due.machine];
    const LineReport& report = due.report;
    if (report.job == 0 || report.job != tracked.job.id || tracked.over) continue;
    store::NewLedgerRow row{
        .job = report.job,
        .counts = {.handed = report.handed, .clocked = report.clocked, .confirmed = report.confirmed, .reserve = 0},
        .note = {}};
    const bool runs = report.end == JobEnd::none;
    // A window is opened anew when half of it is used, so that a feed at full speed never meets its end.
    const std::uint64_t window = reserve_window(report);
    const bool open_more = runs && tracked.committed.reserve < report.handed + window / 2 + window / 4;
    row.counts.reserve = open_more ? report.handed + window : std::max(tracked.committed.reserve, report.handed);
    if (report.stall != tracked.last.stall || report.state != tracked.last.state)
      row.note = runs ? std::string(report.stall) : reason_of(report);
    if (!same_counts(row.counts, tracked.committed) || !runs || !row.note.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

// Moves the job's state after the line's, and publishes.
void Keeper::follow(Tracked& tracked, const Due& due) {
  const LineReport& report = due.report;
  events_.progress(due.machine, report);
  if (report.unarmed_starts != tracked.unarmed_starts) {
    tracked.unarmed_starts = report.unarmed_starts;
    events_.publish({.id = 0,
                     .kind = EventKind::alarm,
                     .machine = due.machine,
                     .job = {},
                     .verdict = 0,
                     .outcome = {},
                     .text = "the control asked for a program (DC1); nothing is armed, nothing was sent"});
  }
  if (report.state != tracked.last.state) {
    events_.publish({.id = 0,
                     .kind = EventKind::machine,
                     .machine = due.machine,
                     .job = {},
                     .verdict = 0,
                     .outcome = {},
                     .text = {}});
  }
  tracked.last = report;
  if (report.job == 0 || report.job != tracked.job.id || tracked.over) return;
  const auto target = target_of(report);
  if (!target || *target == tracked.job.state) return;
  for (const store::JobState step : way(tracked.job.state, *target)) move(tracked, step, report);
  if (report.end == JobEnd::none) return;
  tracked.over = true;
  const std::lock_guard lock(sources_mutex_);
  sources_.erase(due.machine);
}

void Keeper::move(Tracked& tracked, store::JobState to, const LineReport& report) {
  const bool ends = store::ended(to);
  const store::JobMove step{.to = to,
                            .reason = ends ? reason_of(report) : std::string(report.stall),
                            .torn = ends && report.state == LineState::torn};
  const auto moved = store_.jobs().move(tracked.job.id, step, {std::string(kActor), clock_.wall_ms()});
  if (!moved) {
    spdlog::error("job {}: {}", tracked.job.id, store::message_of(moved.error()));
    return;
  }
  tracked.job = *moved;
  spdlog::info("job {} on {}: {} {}", moved->id, moved->machine, store::name_of(to), step.reason);
  events_.publish({.id = 0,
                   .kind = EventKind::job,
                   .machine = moved->machine,
                   .job = *moved,
                   .verdict = 0,
                   .outcome = {},
                   .text = step.reason});
}

}  // namespace dripfeed::app
