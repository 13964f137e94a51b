// A job moves by the table of store/jobs.h. That a line feeds one job is also an index of the schema.
#include "store/sql/job_table.h"

#include <algorithm>

#include <fmt/format.h>

#include "store/sql/audit_table.h"
#include "store/sql/event_table.h"
#include "store/sql/job_rows.h"
#include "store/sql/order_table.h"
#include "store/sql/paging.h"

namespace dripfeed::sql {
namespace {

using store::Error;
using store::ErrorCode;
using store::Id;
using store::Job;
using store::JobMove;
using store::JobState;
using store::Result;
using store::Stamp;

std::unexpected<Error> refuse(ErrorCode code, std::string detail) {
  return std::unexpected(Error{code, std::move(detail)});
}

bool is_audited(JobState from, JobState to) {
  return std::ranges::any_of(store::job_transitions(), [&](const store::JobTransition& transition) {
    return transition.from == from && transition.to == to && transition.audited;
  });
}

// The job after a move that is allowed.
Job moved(Job job, const JobMove& move, const Stamp& by) {
  job.state = move.to;
  job.reason = move.reason;
  job.reason_id = move.reason_id;
  job.expires_at_ms = move.to == JobState::armed ? move.expires_at_ms : 0;
  if (move.to == JobState::armed) {
    job.armed_by = by.actor;
    job.armed_at_ms = by.at_ms;
    job.forecast_ms = move.forecast_ms;
  }
  if (move.to == JobState::feeding && job.started_at_ms == 0) job.started_at_ms = by.at_ms;
  if (store::ended(move.to)) {
    job.ended_at_ms = by.at_ms;
    job.torn = move.torn;
    job.held_ms = move.held_ms;
    job.holds = move.holds;
    job.line_ms = move.line_ms;
  }
  return job;
}

void log_event(Session& session, const Job& job, const Stamp& by) {
  add_event_row(session,
                {.topic = store::EventTopic::job,
                 .word = std::string(store::name_of(job.state)),
                 .subject = job.id,
                 .machine = job.machine,
                 .job = job.id,
                 .program = job.program,
                 .revision = job.revision,
                 .cause = job.reason_id,
                 .text = job.reason},
                by);
}

void write_move(Session& session, JobState from, const Job& job, const Stamp& by) {
  update_job(session, job);
  if (!is_audited(from, job.state)) return;
  add_audit_row(session,
                {.action = "job.move",
                 .subject = job_subject(job.id),
                 .detail = fmt::format("{} to {}{}: {}", store::name_of(from), store::name_of(job.state),
                                       job.torn ? ", torn" : "", job.reason)},
                by);
  log_event(session, job, by);
}

Result<void> refuse_on_hold(const Job& job) {
  if (job.hold_by.empty()) return {};
  return refuse(ErrorCode::on_hold, fmt::format("job {}, by {}: {}", job.id, job.hold_by, job.hold_reason));
}

// Before its time only with a reason, which the audit keeps.
Result<void> check_time(Session& session, const Job& job, const JobMove& move, const Stamp& by) {
  if (by.at_ms >= job.not_before_ms) return {};
  if (move.early_reason.empty())
    return refuse(ErrorCode::too_early, fmt::format("job {} not before {}", job.id, utc_time(job.not_before_ms)));
  add_audit_row(session,
                {.action = "job.arm-early",
                 .subject = job_subject(job.id),
                 .detail = fmt::format("not before {}: {}", utc_time(job.not_before_ms), move.early_reason)},
                by);
  return {};
}

// Of a choice one job is armed: the others leave the queue with it.
void withdraw_others(Session& session, const Job& armed, const Stamp& by) {
  if (armed.choice == 0) return;
  std::vector<Job> others;
  {
    static const std::string kSql = jobs_where("choice = ? AND id <> ? AND state = 'queued' ORDER BY id");
    Query query(session, kSql, armed.choice, armed.id);
    while (query.next()) others.push_back(read_job(query));
  }
  for (const Job& other : others) {
    const Job gone =
        moved(other,
              {.to = JobState::cancelled,
               .reason = fmt::format("withdrawn: job {} of the same choice was armed on {}", armed.id, armed.machine),
               .reason_id = "withdrawn"},
              by);
    write_move(session, other.state, gone, by);
  }
}

// The queued jobs of a machine in their order, but for one.
std::vector<Job> queue_without(Session& session, std::string_view machine, Id id) {
  static const std::string kSql = jobs_where("machine = ? AND state = 'queued' AND id <> ? ORDER BY queue_rank, id");
  Query query(session, kSql, machine, id);
  std::vector<Job> queue;
  while (query.next()) queue.push_back(read_job(query));
  return queue;
}

// Gives the jobs their ranks in this order; those whose rank changed.
std::vector<Job> rank(Session& session, std::vector<Job> queue) {
  std::vector<Job> changed;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    if (queue[i].rank == i + 1) continue;
    queue[i].rank = i + 1;
    session.run("UPDATE job SET queue_rank = ? WHERE id = ?", queue[i].rank, queue[i].id);
    changed.push_back(queue[i]);
  }
  return changed;
}

std::uint64_t last_rank(Session& session, std::string_view machine) {
  Query query(session, "SELECT coalesce(max(queue_rank), 0) FROM job WHERE machine = ? AND state = 'queued'", machine);
  return query.next() ? query.number() : 0;
}

// After all that are as urgent, wherever people put those.
void place_by_priority(Session& session, Job& added) {
  const std::uint64_t own = priority_of(session, added.order);
  if (own == 0) return;
  std::vector<Job> queue = queue_without(session, added.machine, added.id);
  auto place = queue.end();
  while (place != queue.begin() && priority_of(session, std::prev(place)->order) < own) --place;
  if (place == queue.end()) return;
  queue.insert(place, added);
  for (const Job& job : rank(session, std::move(queue)))
    if (job.id == added.id) added.rank = job.rank;
}

}  // namespace

Result<void> JobTable::check_clearance(const Job& job, std::int64_t now_ms) {
  const auto release = releases_.get(job.release);
  if (!release) return std::unexpected(release.error());
  const auto clearance = releases_.clearance_of(*release, now_ms);
  if (!clearance) return std::unexpected(clearance.error());
  return {};
}

Result<void> JobTable::check_line(const Job& job) {
  const auto other = on_line(job.machine);
  if (!other) return std::unexpected(other.error());
  if (*other)
    return refuse(ErrorCode::machine_busy, fmt::format("job {} has the line of {}", (*other)->id, job.machine));
  const auto torn = torn_on(job.machine);
  if (!torn) return std::unexpected(torn.error());
  if (*torn) return refuse(ErrorCode::machine_torn, fmt::format("job {} on {}", (*torn)->id, job.machine));
  const auto answer = answers_.torn_on(job.machine);
  if (!answer) return std::unexpected(answer.error());
  if (*answer) return refuse(ErrorCode::machine_torn, fmt::format("answer {} on {}", (*answer)->id, job.machine));
  const auto end = end_waits_on(job.machine);
  if (!end) return std::unexpected(end.error());
  if (*end)
    return refuse(ErrorCode::end_not_confirmed,
                  fmt::format("job {} on {}: {}", (*end)->id, job.machine, (*end)->end_check));
  return {};
}

Result<void> JobTable::check_retry(const store::NewJob& job) {
  if (job.retry_of == 0) return {};
  const auto old = get(job.retry_of);
  if (!old) return std::unexpected(old.error());
  if (!store::ended(old->state) || old->release != job.release)
    return refuse(ErrorCode::refused_transition,
                  fmt::format("job {} has not ended, or is of another release", old->id));
  return {};
}

Result<Job> JobTable::add(const store::NewJob& job, const Stamp& by) {
  return database_.write_shared("job", [&](Session& session) -> Result<Job> {
    const auto release = releases_.get(job.release);
    if (!release && release.error().code == ErrorCode::not_found) {
      return session.refuse(ErrorCode::broken_reference, fmt::format("release {}", job.release));
    }
    if (!release) return std::unexpected(release.error());
    if (const auto clearance = releases_.clearance_of(*release, by.at_ms); !clearance)
      return std::unexpected(clearance.error());
    Job added;
    added.release = job.release;
    added.program = release->of.program;
    added.revision = release->of.revision;
    added.text_sha256 = release->text_sha256;
    added.machine = release->of.machine;
    added.delivery = release->of.delivery;
    added.link = job.link;
    added.bytes_total = job.bytes_total;
    added.order = job.order;
    if (auto fits = refuse_unfit(session, added); !fits) return std::unexpected(fits.error());
    if (auto again = check_retry(job); !again) return std::unexpected(again.error());
    added.retry_of = job.retry_of;
    added.not_before_ms = job.not_before_ms;
    added.end_check = job.end_check;
    added.choice = job.choice;
    added.restart = release->of.restart;
    added.created_by = by.actor;
    added.created_at_ms = by.at_ms;
    added.rank = last_rank(session, added.machine) + 1;
    added.id = insert_job(session, added);
    place_by_priority(session, added);
    if (job.begins_choice) {
      added.choice = added.id;
      session.run("UPDATE job SET choice = ? WHERE id = ?", added.choice, added.id);
    }
    add_audit_row(session,
                  {.action = "job.add",
                   .subject = job_subject(added.id),
                   .detail = fmt::format("release {} text {} to {}{}{}", added.release, added.text_sha256,
                                         added.machine, store::words_of(added.restart),
                                         added.retry_of == 0 ? "" : fmt::format(", job {} again", added.retry_of))},
                  by);
    log_event(session, added, by);
    return added;
  });
}

Result<Job> JobTable::move(Id job, const JobMove& move, const Stamp& by) {
  return database_.write(job_subject(job), [&](Session& session) -> Result<Job> {
    const auto old = get(job);
    if (!old) return old;
    if (!store::allowed(old->state, move.to)) {
      return session.refuse(ErrorCode::refused_transition,
                            fmt::format("{} to {}", store::name_of(old->state), store::name_of(move.to)));
    }
    const bool breaks = store::ended(move.to) && move.to != JobState::done;
    if (move.torn && !breaks) return session.refuse(ErrorCode::invalid_value, "only a job that broke off can be torn");
    if (move.to == JobState::armed) {
      if (auto free = refuse_on_hold(*old); !free) return std::unexpected(free.error());
      if (auto fits = refuse_unfit(session, *old); !fits) return std::unexpected(fits.error());
      if (auto clear = check_clearance(*old, by.at_ms); !clear) return std::unexpected(clear.error());
      if (auto line = check_line(*old); !line) return std::unexpected(line.error());
      if (auto time = check_time(session, *old, move, by); !time) return std::unexpected(time.error());
    }
    Job next = moved(*old, move, by);
    if (move.to == JobState::armed) withdraw_others(session, next, by);
    if (old->started_at_ms == 0 && move.to == JobState::feeding) ReleaseTable::count_transfer(session, old->release);
    write_move(session, old->state, next, by);
    return next;
  });
}

Result<Job> JobTable::confirm_reset(std::string_view machine, std::string_view reason, const Stamp& by) {
  return database_.write(fmt::format("machine/{}", machine), [&](Session& session) -> Result<Job> {
    if (reason.empty() || by.actor.empty()) {
      return session.refuse(ErrorCode::invalid_value, "a confirmation needs a reason and a name");
    }
    const auto torn = torn_on(machine);
    if (!torn) return std::unexpected(torn.error());
    if (!*torn) return session.refuse(ErrorCode::not_found);
    Job job = **torn;
    job.confirmed_by = by.actor;
    job.confirm_reason = reason;
    job.confirmed_at_ms = by.at_ms;
    update_job(session, job);
    add_audit_row(session,
                  {.action = "job.confirm_reset", .subject = job_subject(job.id), .detail = std::string(reason)}, by);
    return job;
  });
}

Result<std::vector<Job>> JobTable::move_before(Id id, Id before, const Stamp& by) {
  return database_.write(job_subject(id), [&](Session& session) -> Result<std::vector<Job>> {
    const auto job = get(id);
    if (!job) return std::unexpected(job.error());
    if (job->state != JobState::queued) return session.refuse(ErrorCode::refused_transition, "it is not queued");
    std::vector<Job> queue = queue_without(session, job->machine, id);
    const auto place = before == 0 ? queue.end() : std::ranges::find(queue, before, &Job::id);
    if (before != 0 && place == queue.end())
      return session.refuse(ErrorCode::invalid_value,
                            fmt::format("job {} is not another one that is queued for {}", before, job->machine));
    queue.insert(place, *job);
    std::vector<Job> changed = rank(session, std::move(queue));
    if (changed.empty()) return changed;
    const std::string where = before == 0 ? std::string("to the end") : fmt::format("before job {}", before);
    add_audit_row(session, {.action = "job.reorder", .subject = job_subject(id), .detail = where}, by);
    return changed;
  });
}

Result<std::vector<store::JobUse>> JobTable::used(std::string_view machine, std::int64_t from_ms, std::int64_t to_ms) {
  return database_.read(
      fmt::format("machine/{}", machine), [&](Session& session) -> Result<std::vector<store::JobUse>> {
        std::vector<store::JobUse> used;
        {
          static const std::string kSql = jobs_where(
              "machine = ? AND created_at_ms < ? AND (ended_at_ms >= ? OR ended_at_ms = 0 AND "
              "started_at_ms <> 0) ORDER BY id");
          Query query(session, kSql, machine, to_ms, std::max<std::int64_t>(from_ms, 1));  // 0: not ended
          while (query.next()) used.push_back({.job = read_job(query)});
        }
        for (store::JobUse& use : used) {
          Query head(session, "SELECT clocked, at_ms FROM ledger_head WHERE job = ?", use.job.id);
          if (!head.next()) continue;
          use.clocked = head.number();
          use.ledger_at_ms = head.signed_number();
        }
        return used;
      });
}

Result<Job> JobTable::set_read_back(Id job, std::string_view result, const Stamp& by) {
  return database_.write(job_subject(job), [&](Session& session) -> Result<Job> {
    session.run("UPDATE job SET read_back = ? WHERE id = ?", result, job);
    add_audit_row(session, {.action = "job.read-back", .subject = job_subject(job), .detail = std::string(result)}, by);
    if (!session.ok()) return std::unexpected(session.error());
    return get(job);
  });
}

Result<Job> JobTable::get(Id job) {
  return database_.read(job_subject(job), [&](Session& session) -> Result<Job> {
    static const std::string kSql = jobs_where("id = ?");
    Query query(session, kSql, job);
    if (!query.next()) return session.refuse(ErrorCode::not_found);
    return read_job(query);
  });
}

Result<store::Page<Job>> JobTable::list(const store::PageRequest& page, const store::JobFilter& filter) {
  return database_.read("jobs", [&](Session& session) -> Result<store::Page<Job>> {
    const auto from = newest_first(page);
    if (!from) return std::unexpected(from.error());
    const std::string sql = jobs_where(
        fmt::format("{} AND {} AND {} AND {} AND {} AND id < ? ORDER BY id DESC LIMIT ?",
                    filter.machine.empty() ? "? = ''" : "machine = ?", filter.state ? "state = ?" : "? = ''",
                    filter.program == 0 ? "? = 0" : "program = ?", filter.order == 0 ? "? = 0" : "work_order = ?",
                    filter.choice == 0 ? "? = 0" : "choice = ?"));
    const std::string_view state = filter.state ? store::name_of(*filter.state) : std::string_view();
    Query query(session, sql, filter.machine, state, filter.program, filter.order, filter.choice, from->after,
                from->rows);
    return collect(query, page, read_job, [](const Job& job) { return fmt::format("{}", job.id); });
  });
}

Result<std::optional<Job>> JobTable::find(std::string_view sql, std::string_view machine) {
  return database_.read(fmt::format("machine/{}", machine), [&](Session& session) -> Result<std::optional<Job>> {
    Query query(session, sql, machine);
    if (!query.next()) return std::nullopt;
    return read_job(query);
  });
}

Result<std::optional<Job>> JobTable::on_line(std::string_view machine) {
  static const std::string kSql = jobs_where("machine = ? AND state IN ('armed', 'feeding', 'held', 'draining')");
  return find(kSql, machine);
}

Result<std::optional<Job>> JobTable::torn_on(std::string_view machine) {
  static const std::string kSql =
      jobs_where("machine = ? AND torn = 1 AND confirmed_at_ms = 0 ORDER BY id DESC LIMIT 1");
  return find(kSql, machine);
}

Result<std::vector<Job>> JobTable::interrupt_unfinished(const Stamp& by, const store::OfMachines& of) {
  return database_.write("jobs", [&](Session& session) -> Result<std::vector<Job>> {
    std::vector<Job> jobs;
    {
      static const std::string kSql = jobs_where("state IN ('armed', 'feeding', 'held', 'draining') ORDER BY id");
      Query query(session, kSql);
      while (query.next()) jobs.push_back(read_job(query));
    }
    if (of) std::erase_if(jobs, [&](const Job& job) { return !of(job.machine); });
    for (Job& job : jobs) {
      const JobState from = job.state;
      // An armed job may have begun after the last commit, as far as its reserve reaches.
      const bool may_have_fed = from != JobState::armed || reserve_of(session, job.id) > 0;
      const std::string_view reason =
          may_have_fed ? "the server stopped" : "the server stopped before anything was sent";
      job = moved(job,
                  {.to = JobState::interrupted,
                   .reason = std::string(reason),
                   .torn = may_have_fed,
                   .reason_id = "server_stopped"},
                  by);
      write_move(session, from, job, by);
    }
    return jobs;
  });
}

}  // namespace dripfeed::sql
