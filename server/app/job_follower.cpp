// Only the newest report of a line counts: a job passes through all the states between, and no line begins another job
// before this one has moved in the store.
#include "server/app/job_follower.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <deque>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "server/app/job_words.h"

namespace dripfeed::app {

namespace {

constexpr std::chrono::milliseconds kRound{250};
constexpr feed::Time kAlarmAgain = std::chrono::minutes(1);  // a control that asks over and over
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

std::string_view machine_state(const LineReport& report) {
  return report.machine ? report.machine->state : std::string_view();
}

}  // namespace

JobFollower::JobFollower(store::Store& store, Events& events, TextReader& texts, const Clock& clock)
    : store_(store), events_(events), texts_(texts), clock_(clock), thread_("follower", kRound, Urgency::usual, [this] {
        round();
      }) {}

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

// To those who watch a machine that is concerned; once and not ten times a second.
void JobFollower::report_complaint(const std::string& complaint) {
  if (complaint == complaint_) return;
  complaint_ = complaint;
  if (complaint.empty()) return;
  for (const auto& [machine, followed] : followed_) {
    if (!followed.over) alarm(machine, fmt::format("the ledger cannot be written: {}", complaint));
  }
}

void JobFollower::alarm(const std::string& machine, std::string text) {
  spdlog::warn("{}: {}", machine, text);
  events_.publish({.id = 0,
                   .kind = EventKind::alarm,
                   .machine = machine,
                   .job = {},
                   .verdict = 0,
                   .outcome = {},
                   .text = std::move(text)});
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

// The first one at once; of a control that goes on asking, how often, once a minute.
void JobFollower::report_unarmed_starts(Followed& followed, const Booked& booked) {
  const std::uint64_t starts = booked.report.unarmed_starts;
  const feed::Time now = clock_.now();
  if (starts < followed.starts_alarmed) followed.starts_alarmed = 0;  // a line that was made anew
  if (starts == followed.starts_alarmed || now < followed.quiet_until) return;
  const std::uint64_t more = starts - std::exchange(followed.starts_alarmed, starts);
  followed.quiet_until = now + kAlarmAgain;
  const std::string often = more > 1 ? fmt::format(" {} times", more) : std::string();
  alarm(booked.machine,
        fmt::format("the control asked for a program (DC1){}; nothing is armed, nothing was sent", often));
}

void JobFollower::follow(const Booked& booked) {
  Followed& followed = followed_[booked.machine];
  const LineReport& report = booked.report;
  const LineReport& last = followed.last;
  events_.progress(booked.machine, report);
  if (!booked.is_booked) return begin(followed, booked);
  report_unarmed_starts(followed, booked);
  if (std::string text = new_alarm(report, last); !text.empty()) alarm(booked.machine, std::move(text));
  if (report.stall == kResetSuspected && last.stall != kResetSuspected)
    alarm(booked.machine,
          "the control asked for a program (DC1) while the feed was stopped: it may have been reset. The "
          "job cannot be resumed: cancel it");
  if (report.answer.stage == AnswerStage::torn && report.answer != last.answer)
    alarm(booked.machine, fmt::format("an answer broke off inside a block ({}): reset the control and confirm it",
                                      report.answer.cause));
  if (followed.refusal != booked.refusal) {
    followed.refusal = booked.refusal;
    if (!booked.refusal.empty()) alarm(booked.machine, "nothing leaves on its line: " + booked.refusal);
  }
  // What a device server did not confirm, or a ring that nobody saw come.
  if (!report.link_note.empty() && report.link_note != last.link_note) alarm(booked.machine, report.link_note);
  // A stall within a state ("CTS off" while feeding) is a transition, too.
  const bool changed =
      report.state != last.state || report.stall != last.stall || machine_state(report) != machine_state(last);
  if (changed) publish_machine(booked);
  followed.last = report;
  begin(followed, booked);
  follow_job(followed, booked);
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
  const store::JobMove step{.to = to,
                            .reason = ends || disarms ? reason_of(report) : std::string(report.stall),
                            .torn = ends && report.state == LineState::torn};
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
