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
constexpr feed::Time kRestoreEvery = std::chrono::seconds(10);
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

// The shortest allowed way from one state to another.
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

// A line may have passed through several states between two rounds. One that handed bytes has fed, and that counts as a
// transfer, however soon it broke off.
std::vector<store::JobState> steps_to(store::JobState from, store::JobState to, const LineReport& report) {
  if (from != store::JobState::armed || report.handed == 0) return way(from, to);
  std::vector<store::JobState> steps = {store::JobState::feeding};
  const std::vector<store::JobState> rest = way(store::JobState::feeding, to);
  steps.insert(steps.end(), rest.begin(), rest.end());
  return steps;
}

// An alarm that was not there at the last look; "" for none.
std::string new_alarm(const LineReport& report, const LineReport& last) {
  if (!report.machine || report.machine->alarm == 0) return {};
  if (last.machine && last.machine->alarm == report.machine->alarm) return {};
  return alarm_text(*report.machine);
}

std::string_view machine_state(const LineReport& report) {
  return report.machine ? report.machine->state : std::string_view();
}

std::string reason_of(const LineReport& report) {
  if (report.end == JobEnd::none || report.end == JobEnd::done) return std::string(report.stall);
  if (report.end == JobEnd::disarmed) return fmt::format("disarmed, nothing was sent: {}", report.cause);
  std::string reason = fmt::format("{}: between wire byte {} and {} of {} may have reached the control", report.cause,
                                   report.known.from, report.known.to, report.total);
  if (report.known.from_line > 0)
    reason += fmt::format(" (line {} to {})", report.known.from_line, report.known.to_line);
  if (report.machine && report.machine->alarm > 0) reason += "; " + alarm_text(*report.machine);
  if (report.state == LineState::torn) reason += "; a block is torn: reset the control and confirm it";
  if (!report.link_error.empty()) reason += fmt::format("; {}", report.link_error);
  return reason;
}

}  // namespace

std::uint64_t reserve_window(const LineReport& report) {
  if (report.char_s <= 0.0) return kReserveOfBlocks;
  return std::max(kReserveAtLeast, static_cast<std::uint64_t>(kReserveAhead_s / report.char_s));
}

Keeper::Keeper(store::Store& store, Lines& lines, Events& events, const Clock& clock, Ballast* ballast)
    : store_(store),
      lines_(lines),
      events_(events),
      clock_(clock),
      ballast_(ballast),
      thread_([this](const std::stop_token& stop) { loop(stop); }) {}

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

void Keeper::note(store::Id job, std::string_view text) {
  const std::lock_guard lock(round_mutex_);
  std::string& note = notes_[job];
  note += note.empty() ? "" : "; ";
  note += text;
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
  for (auto& [machine, line] : lines_.all()) all.push_back({machine, line, line->report(), tracked_[machine]});
  for (const Due& due : all) begin(due);

  const std::vector<store::NewLedgerRow> rows = rows_of(all);
  if (!rows.empty()) {
    const auto faults = append(rows);
    if (!faults) {
      // Nothing is reserved, so the feeds stop at what they have and say that they wait for the ledger. No job moves
      // without its row.
      complain(store::message_of(faults.error()), all);
      for (const Due& due : all) events_.progress(due.machine, due.report);
      return;
    }
    if (!complaint_.empty()) spdlog::info("ledger: it is written again");
    complaint_.clear();
    for (const store::LedgerFault& fault : *faults) spdlog::error("ledger: job {}: {}", fault.job, fault.why);
    commit(rows, *faults, all);
  }
  for (const Due& due : all) follow(due);
  if (ballast_ != nullptr && clock_.now() >= restore_at_) {
    restore_at_ = clock_.now() + kRestoreEvery;
    ballast_->restore();
  }
}

// On a full disk the ballast makes room, once.
store::Result<std::vector<store::LedgerFault>> Keeper::append(std::span<const store::NewLedgerRow> rows) {
  auto faults = store_.ledger().append(rows, clock_.wall_ms());
  const bool full = !faults && faults.error().code == store::ErrorCode::disk_full;
  if (full && ballast_ != nullptr && ballast_->give_up()) {
    restore_at_ = clock_.now() + kRestoreEvery;
    faults = store_.ledger().append(rows, clock_.wall_ms());
  }
  return faults;
}

// Says it once and not ten times a second, to the log and to who watches a machine that is concerned.
void Keeper::complain(const std::string& error, const std::vector<Due>& all) {
  if (error == complaint_) return;
  complaint_ = error;
  spdlog::error("ledger: {}", error);
  for (const Due& due : all) {
    if (due.tracked.over) continue;
    events_.publish({.id = 0,
                     .kind = EventKind::alarm,
                     .machine = due.machine,
                     .job = {},
                     .verdict = 0,
                     .outcome = {},
                     .text = fmt::format("the ledger cannot be written: {}", error)});
  }
}

// The rows are durable: their windows may be used.
void Keeper::commit(std::span<const store::NewLedgerRow> rows, std::span<const store::LedgerFault> faults,
                    const std::vector<Due>& all) {
  auto next = rows.begin();  // they stand in the order of `all`
  for (const Due& due : all) {
    Tracked& tracked = due.tracked;
    if (next == rows.end() || due.report.job != tracked.job.id || next->job != tracked.job.id) continue;
    const auto row = next++;
    const auto fault = std::ranges::find(faults, tracked.job.id, &store::LedgerFault::job);
    if (fault != faults.end() && !fault->written) continue;
    tracked.committed = row->counts;
    notes_.erase(tracked.job.id);
    due.line->extend_reserve(tracked.job.id, row->counts.reserve);
  }
}

// An arming that the line has and the books do not know yet. A disarmed job may come again, and may be disarmed again
// before anybody looked.
void Keeper::begin(const Due& due) {
  Tracked& tracked = due.tracked;
  if (due.report.job == 0 || (due.report.job == tracked.job.id && due.report.session == tracked.session)) return;
  const auto job = store_.jobs().get(due.report.job);
  const auto interval = store_.ledger().interval(due.report.job);
  if (!job || !interval) {
    spdlog::error("{}: job {} is on the line and not in the store", due.machine, due.report.job);
    return;
  }
  tracked.job = *job;
  tracked.session = due.report.session;
  tracked.committed = interval->last;
  tracked.over = store::ended(job->state);
}

std::vector<store::NewLedgerRow> Keeper::rows_of(const std::vector<Due>& all) {
  std::vector<store::NewLedgerRow> rows;
  for (const Due& due : all) {
    const Tracked& tracked = due.tracked;
    const LineReport& report = due.report;
    if (report.job == 0 || report.job != tracked.job.id || tracked.over) continue;
    store::NewLedgerRow row{
        .job = report.job,
        .counts = {.handed = report.handed, .clocked = report.clocked, .confirmed = report.confirmed, .reserve = 0},
        .note = {}};
    const bool runs = report.end == JobEnd::none;
    // A window is opened anew when half of it is used, so that a feed at full speed never meets its end.
    const std::uint64_t window = reserve_window(report);
    const bool open_more = tracked.committed.reserve < report.handed + window / 2 + window / 4;
    row.counts.reserve = std::max(tracked.committed.reserve, report.handed);
    if (open_more) row.counts.reserve = std::max(row.counts.reserve, std::min(report.handed + window, report.total));
    // A job that is over hands nothing more: what it had left of its window is given back.
    if (!runs) row.counts.reserve = report.handed;
    if (const auto note = notes_.find(report.job); note != notes_.end()) row.note = note->second;
    if (report.stall != tracked.last.stall || report.state != tracked.last.state) {
      const std::string news = runs ? std::string(report.stall) : reason_of(report);
      row.note += row.note.empty() || news.empty() ? news : "; " + news;
    }
    if (const std::string news = new_alarm(report, tracked.last); !news.empty())
      row.note += row.note.empty() ? news : "; " + news;
    if (row.counts != tracked.committed || !runs || !row.note.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

void Keeper::tell_alarm(const std::string& machine, std::string text) {
  spdlog::warn("{}: {}", machine, text);
  events_.publish({.id = 0,
                   .kind = EventKind::alarm,
                   .machine = machine,
                   .job = {},
                   .verdict = 0,
                   .outcome = {},
                   .text = std::move(text)});
}

// Moves the job's state after the line's, and publishes.
void Keeper::follow(const Due& due) {
  Tracked& tracked = due.tracked;
  const LineReport& report = due.report;
  events_.progress(due.machine, report);
  const std::uint64_t starts_before = std::exchange(tracked.unarmed_starts, report.unarmed_starts);
  if (report.unarmed_starts > starts_before)
    tell_alarm(due.machine, "the control asked for a program (DC1); nothing is armed, nothing was sent");
  if (std::string text = new_alarm(report, tracked.last); !text.empty()) tell_alarm(due.machine, std::move(text));
  // What a device server did not confirm, or a ring that nobody saw come.
  if (!report.link_note.empty() && report.link_note != tracked.last.link_note)
    tell_alarm(due.machine, report.link_note);
  // A stall within a state ("CTS off" while feeding) is a transition, too.
  if (report.state != tracked.last.state || report.stall != tracked.last.stall ||
      machine_state(report) != machine_state(tracked.last)) {
    events_.publish({.id = 0,
                     .kind = EventKind::machine,
                     .machine = due.machine,
                     .job = {},
                     .verdict = 0,
                     .outcome = {},
                     .text = std::string(report.stall)});
  }
  tracked.last = report;
  if (report.job == 0 || report.job != tracked.job.id || tracked.over) return;
  const auto target = target_of(report);
  if (!target || *target == tracked.job.state) return;
  for (const store::JobState step : steps_to(tracked.job.state, *target, report)) move(tracked, step, report);
  // What the store did not take is tried again in the next round.
  if (report.end == JobEnd::none || (tracked.job.state != *target && !store::ended(tracked.job.state))) return;
  tracked.over = true;
  notes_.erase(tracked.job.id);
  const std::lock_guard lock(sources_mutex_);
  sources_.erase(due.machine);
}

void Keeper::move(Tracked& tracked, store::JobState to, const LineReport& report) {
  const bool ends = store::ended(to);
  const bool disarms = to == store::JobState::queued;
  const store::JobMove step{.to = to,
                            .reason = ends || disarms ? reason_of(report) : std::string(report.stall),
                            .torn = ends && report.state == LineState::torn};
  const auto moved = store_.jobs().move(tracked.job.id, step, {std::string(kActor), clock_.wall_ms()});
  if (!moved) {
    spdlog::error("job {}: {}", tracked.job.id, store::message_of(moved.error()));
    if (const auto now = store_.jobs().get(tracked.job.id)) tracked.job = *now;
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
