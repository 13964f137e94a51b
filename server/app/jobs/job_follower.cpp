// Only the newest report of a line counts: a job passes through all the states between, and no line begins another job
// before this one has moved in the store.
#include "server/app/jobs/job_follower.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <deque>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "server/app/jobs/job_words.h"

namespace dripfeed::app {

namespace {

constexpr std::chrono::milliseconds kRound{250};
constexpr feed::Time kLinkMissed = std::chrono::seconds(5);  // a link that is down so long
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

// The shortest allowed path from one state to another.
std::vector<store::JobState> path(store::JobState from, store::JobState to) {
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
  if (from != store::JobState::armed || report.handed == 0) return path(from, to);
  std::vector<store::JobState> steps = {store::JobState::feeding};
  const std::vector<store::JobState> rest = path(store::JobState::feeding, to);
  steps.insert(steps.end(), rest.begin(), rest.end());
  return steps;
}

// Something of ours is on the line, or may be in a moment.
bool has_line(LineState state) {
  return state == LineState::armed || state == LineState::feeding || state == LineState::held ||
         state == LineState::draining || state == LineState::answering;
}

bool is_down(const LineReport& report) { return report.state == LineState::disconnected || !report.link_error.empty(); }

// Lines that have a time of a character count their holds; a folder and a block transfer do not.
void add_line_figures(const LineReport& report, store::JobMove& move) {
  if (report.char_s <= 0.0) return;
  move.held_ms = static_cast<std::int64_t>(report.hold_s * 1e3);
  move.holds = report.holds;
  move.line_ms = static_cast<std::int64_t>(report.line_s * 1e3);
}

std::string_view machine_state(const LineReport& report) {
  return report.machine ? report.machine->state : std::string_view();
}

}  // namespace

JobFollower::JobFollower(store::Store& store, Events& events, Alarms& alarms, TextReader& texts, const Clock& clock)
    : store_(store),
      events_(events),
      alarms_(alarms),
      texts_(texts),
      clock_(clock),
      thread_("follower", kRound, Urgency::usual, [this] { round(); }) {}

void JobFollower::take(std::vector<Booked> lines, const std::string& complaint) {
  {
    const std::lock_guard lock(mutex_);
    waiting_complaint_ = complaint;
    for (Booked& line : lines) {
      const std::string machine = line.machine;
      waiting_[machine] = std::move(line);
    }
  }
  thread_.wake();
}

void JobFollower::round() {
  std::map<std::string, Booked> lines;
  std::string complaint;
  {
    const std::lock_guard lock(mutex_);
    lines.swap(waiting_);
    complaint = waiting_complaint_;
  }
  for (const auto& [machine, booked] : lines) follow(booked);
  report_complaint(complaint);
}

// At the machines that are concerned; once and not ten times a second.
void JobFollower::report_complaint(const std::string& complaint) {
  if (complaint == complaint_) return;
  complaint_ = complaint;
  for (const auto& [machine, followed] : followed_) {
    if (complaint.empty()) {
      alarms_.clear(machine, AlarmKind::ledger_failed);
    } else if (!followed.over) {
      alarms_.raise(machine, AlarmKind::ledger_failed, fmt::format("the ledger cannot be written: {}", complaint),
                    followed.job.id);
    }
  }
}

void JobFollower::publish_machine(const Booked& booked) {
  events_.publish({.id = 0,
                   .kind = EventKind::machine,
                   .machine = booked.machine,
                   .job = {},
                   .verdict = 0,
                   .outcome = {},
                   .text = std::string(booked.report.stall)});
}

// What lasts on a line is reported when it begins and when it ends. Of a line that is seen first all is reported: an
// alarm may be left from a server before this one.
void JobFollower::report_line(Followed& followed, const Booked& booked) {
  const LineReport& report = booked.report;
  const std::string& machine = booked.machine;
  const bool first = !std::exchange(followed.is_seen, true);
  const bool is_torn = report.state == LineState::torn;
  if (first || is_torn != followed.is_torn) alarms_.line_is_torn(machine, is_torn, booked.left_torn);
  followed.is_torn = is_torn;
  const bool suspected = report.stall == kResetSuspected;
  if (suspected && !followed.reset_suspected)
    alarms_.raise(machine, AlarmKind::reset_suspected,
                  "the control asked for a program (DC1) while the feed was stopped: it may have been reset. The job "
                  "cannot be resumed: cancel it",
                  report.job);
  if (!suspected && (first || followed.reset_suspected)) alarms_.clear(machine, AlarmKind::reset_suspected);
  followed.reset_suspected = suspected;
  if (!booked.refusal.empty() && booked.refusal != followed.refusal)
    alarms_.raise(machine, AlarmKind::line_refused, "nothing leaves on its line: " + booked.refusal);
  if (booked.refusal.empty() && (first || !followed.refusal.empty())) alarms_.clear(machine, AlarmKind::line_refused);
  followed.refusal = booked.refusal;
  if (first) forget_old(booked);
  report_note(followed, booked);
  report_link(followed, booked);
  report_machine(followed, booked);
}

// What was left on, and is not on as far as this round can see; what is on is raised after it.
void JobFollower::forget_old(const Booked& booked) {
  using enum AlarmKind;
  const LineReport& report = booked.report;
  if (complaint_.empty()) alarms_.clear(booked.machine, ledger_failed);
  for (const AlarmKind kind : {link_note, line_flooded}) alarms_.clear(booked.machine, kind);
  if (is_down(report)) return;
  alarms_.clear(booked.machine, link_lost);
  if (!report.machine || report.machine->alarm == 0) alarms_.clear(booked.machine, machine_alarm);
}

// What a device server did not confirm, a ring that no one saw come, a peer that floods.
void JobFollower::report_note(Followed& followed, const Booked& booked) {
  const auto kind_of = [](const std::string& note) {
    return note == kFloodNote ? AlarmKind::line_flooded : AlarmKind::link_note;
  };
  const std::string& note = booked.report.link_note;
  if (note == followed.link_note) return;
  if (!followed.link_note.empty()) alarms_.clear(booked.machine, kind_of(followed.link_note));
  if (!note.empty()) alarms_.raise(booked.machine, kind_of(note), note);
  followed.link_note = note;
}

// A cable that is plugged is no alarm; one that was pulled from a job is, at once.
void JobFollower::report_link(Followed& followed, const Booked& booked) {
  const LineReport& report = booked.report;
  const bool was_down = followed.is_down;
  followed.is_down = is_down(report);
  if (!followed.is_down) {
    followed.is_lost = false;
    if (was_down) alarms_.clear(booked.machine, AlarmKind::link_lost);
    return;
  }
  if (!was_down) followed.down_since = clock_.now();
  const bool lost_a_job = !was_down && has_line(followed.last.state);
  if (followed.is_lost || (!lost_a_job && clock_.now() - followed.down_since <= kLinkMissed)) return;
  followed.is_lost = true;
  const std::string why = report.link_error.empty() ? std::string() : ": " + report.link_error;
  alarms_.raise(booked.machine, AlarmKind::link_lost, "the link is down" + why, lost_a_job ? followed.last.job : 0);
}

// While its words are missing nothing is known of it, so its alarm stays.
void JobFollower::report_machine(Followed& followed, const Booked& booked) {
  const LineReport& report = booked.report;
  if (!report.machine && followed.is_down) return;
  const std::uint32_t alarm = report.machine ? report.machine->alarm : 0;
  if (alarm == followed.machine_alarm) return;
  followed.machine_alarm = alarm;
  if (alarm == 0) return alarms_.clear(booked.machine, AlarmKind::machine_alarm);
  alarms_.raise(booked.machine, AlarmKind::machine_alarm, alarm_text(*report.machine));
}

void JobFollower::follow(const Booked& booked) {
  Followed& followed = followed_[booked.machine];
  const LineReport& report = booked.report;
  const LineReport& last = followed.last;
  const Asks asks = asks_.look(booked.machine, report, clock_.now(), clock_.wall_ms());
  events_.progress(booked.machine, report, asks);
  totals_.look(booked.machine, report, clock_.wall_ms());
  if (!booked.is_booked) return begin(followed, booked);
  // A stall within a state ("CTS off" while feeding) is a transition, too.
  const bool changed =
      report.state != last.state || report.stall != last.stall || machine_state(report) != machine_state(last);
  if (changed) publish_machine(booked);
  begin(followed, booked);
  follow_job(followed, booked);
  report_line(followed, booked);  // after the job: its torn block is looked up
  followed.last = report;
}

void JobFollower::begin(Followed& followed, const Booked& booked) {
  const LineReport& report = booked.report;
  if (report.job == 0 || (report.job == followed.job.id && report.session == followed.session)) return;
  const auto job = store_.jobs().get(report.job);
  if (!job) return spdlog::error("{}: job {}: {}", booked.machine, report.job, store::message_of(job.error()));
  followed.job = *job;
  followed.session = report.session;
  followed.over = store::ended(job->state);
}

void JobFollower::follow_job(Followed& followed, const Booked& booked) {
  const LineReport& report = booked.report;
  if (report.job == 0 || report.job != followed.job.id || followed.over) return;
  const auto target = target_of(report);
  if (!target || *target == followed.job.state) return;
  for (const store::JobState step : steps_to(followed.job.state, *target, report)) move(followed, step, report);
  // What the store did not take is tried again in the next round.
  if (report.end == JobEnd::none || (followed.job.state != *target && !store::ended(followed.job.state))) return;
  followed.over = true;
  texts_.arming_is_over(followed.session);
}

void JobFollower::move(Followed& followed, store::JobState to, const LineReport& report) {
  const bool ends = store::ended(to);
  const bool disarms = to == store::JobState::queued;
  store::JobMove step{.to = to,
                      .reason = ends || disarms ? reason_of(report) : std::string(report.stall),
                      .torn = ends && report.state == LineState::torn,
                      .expires_at_ms = 0,
                      .reason_id = reason_id_of(report)};
  if (ends) add_line_figures(report, step);
  const auto moved = store_.jobs().move(followed.job.id, step, {std::string(kActor), clock_.wall_ms()});
  if (!moved) {
    spdlog::error("job {}: {}", followed.job.id, store::message_of(moved.error()));
    if (const auto now = store_.jobs().get(followed.job.id)) followed.job = *now;
    return;
  }
  followed.job = *moved;
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
