// What is planned of jobs and the result of them: the time before which one is not armed, holds in the queue, the
// confirmation of an end, and the jobs that ended in a time.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "store/sql/audit_table.h"
#include "store/sql/event_table.h"
#include "store/sql/job_rows.h"
#include "store/sql/job_table.h"

namespace dripfeed::sql {

namespace {

// What a person planned of a job, or states of it: its state stays.
void log_plan(Session& session, const store::Job& job, std::string_view word, std::string text,
              const store::Stamp& by) {
  add_event_row(session,
                {.topic = store::EventTopic::job,
                 .word = std::string(word),
                 .subject = job.id,
                 .machine = job.machine,
                 .job = job.id,
                 .program = job.program,
                 .revision = job.revision,
                 .text = std::move(text)},
                by);
}

}  // namespace

using store::EndedJob;
using store::ErrorCode;
using store::Id;
using store::Job;
using store::JobState;
using store::Result;
using store::Stamp;

Result<Job> JobTable::schedule(Id id, std::int64_t not_before_ms, const Stamp& by) {
  return database_.write(job_subject(id), [&](Session& session) -> Result<Job> {
    auto job = get(id);
    if (!job) return job;
    if (job->state != JobState::queued) return session.refuse(ErrorCode::refused_transition, "it is not queued");
    if (not_before_ms < 0) return session.refuse(ErrorCode::invalid_value, "a time before 1970");
    job->not_before_ms = not_before_ms;
    update_job(session, *job);
    const std::string when =
        not_before_ms == 0 ? std::string("at any time") : fmt::format("not before {}", utc_time(not_before_ms));
    add_audit_row(session, {.action = "job.schedule", .subject = job_subject(id), .detail = when}, by);
    log_plan(session, *job, store::kJobEvents[0], when, by);
    if (!session.ok()) return std::unexpected(session.error());
    return job;
  });
}

Result<Job> JobTable::hold(Id id, std::string_view reason, const Stamp& by) {
  return database_.write(job_subject(id), [&](Session& session) -> Result<Job> {
    auto job = get(id);
    if (!job) return job;
    if (job->state != JobState::queued) return session.refuse(ErrorCode::refused_transition, "it is not queued");
    if (!job->hold_by.empty()) return session.refuse(ErrorCode::refused_transition, "it is on hold already");
    if (reason.empty() || by.actor.empty())
      return session.refuse(ErrorCode::invalid_value, "a hold needs a reason and a name");
    job->hold_by = by.actor;
    job->hold_reason = reason;
    update_job(session, *job);
    add_audit_row(session, {.action = "job.hold", .subject = job_subject(id), .detail = std::string(reason)}, by);
    log_plan(session, *job, store::kJobEvents[3], std::string(reason), by);
    if (!session.ok()) return std::unexpected(session.error());
    return job;
  });
}

Result<Job> JobTable::end_hold(Id id, const Stamp& by) {
  return database_.write(job_subject(id), [&](Session& session) -> Result<Job> {
    auto job = get(id);
    if (!job) return job;
    if (job->state != JobState::queued || job->hold_by.empty())
      return session.refuse(ErrorCode::refused_transition, "it is not on hold");
    const std::string was = fmt::format("by {}: {}", job->hold_by, job->hold_reason);
    job->hold_by.clear();
    job->hold_reason.clear();
    update_job(session, *job);
    add_audit_row(session, {.action = "job.end-hold", .subject = job_subject(id), .detail = was}, by);
    log_plan(session, *job, store::kJobEvents[4], was, by);
    if (!session.ok()) return std::unexpected(session.error());
    return job;
  });
}

Result<Job> JobTable::confirm_end(Id id, std::string_view note, const Stamp& by) {
  return database_.write(job_subject(id), [&](Session& session) -> Result<Job> {
    auto job = get(id);
    if (!job) return job;
    if (!job->needs_end_confirmation())
      return session.refuse(ErrorCode::refused_transition, "its end waits for no confirmation");
    if (by.actor.empty()) return session.refuse(ErrorCode::invalid_value, "a confirmation needs a name");
    job->end_confirmed_by = by.actor;
    job->end_note = note;
    job->end_confirmed_at_ms = by.at_ms;
    update_job(session, *job);
    add_audit_row(session,
                  {.action = "job.confirm-end",
                   .subject = job_subject(id),
                   .detail = fmt::format("{}{}{}", job->end_check, note.empty() ? "" : ": ", note)},
                  by);
    log_plan(session, *job, store::kJobEvents[1], std::string(note), by);
    if (!session.ok()) return std::unexpected(session.error());
    return job;
  });
}

Result<std::optional<Job>> JobTable::end_waits_on(std::string_view machine) {
  static const std::string kSql = jobs_where(
      "machine = ? AND end_check <> '' AND end_confirmed_at_ms = 0 AND started_at_ms <> 0 AND ended_at_ms <> 0 ORDER "
      "BY id LIMIT 1");
  return find(kSql, machine);
}

namespace {

// -1 in the query stands for NULL.
template <class Number>
std::optional<Number> known_number(Query& query) {
  const std::int64_t value = query.signed_number();
  return value < 0 ? std::nullopt : std::optional(static_cast<Number>(value));
}

EndedJob read_ended(Query& query) {
  EndedJob job;
  job.machine = query.text();
  job.part = query.text();
  job.state = query.value<JobState>();
  job.bytes_total = query.number();
  job.started_at_ms = query.signed_number();
  job.ended_at_ms = query.signed_number();
  job.held_ms = known_number<std::int64_t>(query);
  job.holds = known_number<std::uint64_t>(query);
  job.line_ms = known_number<std::int64_t>(query);
  job.forecast_ms = known_number<std::int64_t>(query);
  return job;
}

}  // namespace

Result<void> JobTable::each_ended(const store::EndedFilter& filter, const std::function<void(const EndedJob&)>& visit) {
  return database_.read("jobs", [&](Session& session) -> Result<void> {
    const std::string sql = fmt::format(
        "SELECT j.machine, coalesce(o.part, r.part, ''), j.state, j.bytes_total, j.started_at_ms, j.ended_at_ms, "
        "coalesce(j.held_ms, -1), coalesce(j.holds, -1), coalesce(j.line_ms, -1), coalesce(j.forecast_ms, -1) FROM job "
        "j JOIN program_revision r ON r.program = j.program AND r.revision = j.revision LEFT JOIN work_order o ON o.id "
        "= j.work_order WHERE j.ended_at_ms <> 0 AND j.ended_at_ms >= ? AND j.ended_at_ms < ? AND {} AND {} ORDER BY "
        "j.ended_at_ms, j.id",
        filter.machine.empty() ? "? = ''" : "j.machine = ?", filter.state ? "j.state = ?" : "? = ''");
    const std::string_view state = filter.state ? store::name_of(*filter.state) : std::string_view();
    Query query(session, sql, filter.from_ms, filter.to_ms, filter.machine, state);
    while (query.next()) visit(read_ended(query));
    if (!session.ok()) return std::unexpected(session.error());
    return {};
  });
}

}  // namespace dripfeed::sql
