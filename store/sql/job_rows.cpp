// The columns of a job.
#include "store/sql/job_rows.h"

#include <ctime>
#include <optional>

#include <fmt/format.h>

namespace dripfeed::sql {
namespace {

using store::Id;
using store::Job;

constexpr std::string_view kInsert =
    "INSERT INTO job (text_release, program, revision, sha256, machine, delivery, link, bytes_total, state, reason, "
    "created_by, armed_by, created_at_ms, armed_at_ms, started_at_ms, ended_at_ms, torn, confirmed_by, confirm_reason, "
    "confirmed_at_ms, queue_rank, work_order, not_before_ms, choice, end_check, retry_of) VALUES (?, ?, ?, ?, ?, ?, ?, "
    "?, ?, '', ?, '', ?, 0, 0, 0, 0, '', '', 0, ?, ?, ?, ?, ?, ?)";
constexpr std::string_view kInsertHead =
    "INSERT INTO ledger_head (job, last, seq, at_ms, handed, clocked, confirmed, reserve) VALUES (?, NULL, 0, 0, 0, 0, "
    "0, 0)";
constexpr std::string_view kUpdate =
    "UPDATE job SET state = ?, reason = ?, armed_by = ?, armed_at_ms = ?, started_at_ms = ?, ended_at_ms = ?, torn = "
    "?, "
    "confirmed_by = ?, confirm_reason = ?, confirmed_at_ms = ?, expires_at_ms = ?, reason_id = ?, not_before_ms = ?, "
    "end_confirmed_by = ?, end_note = ?, end_confirmed_at_ms = ?, hold_by = ?, hold_reason = ? WHERE id = ?";

// -1 in the query stands for NULL.
std::optional<std::int64_t> known(std::int64_t value) { return value < 0 ? std::nullopt : std::optional(value); }

}  // namespace

std::string utc_time(std::int64_t at_ms) {
  const auto at = static_cast<std::time_t>(at_ms / 1000);
  std::tm utc{};
  ::gmtime_r(&at, &utc);
  return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}:{:02} UTC", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday,
                     utc.tm_hour, utc.tm_min, utc.tm_sec);
}

std::string job_subject(Id job) { return fmt::format("job/{}", job); }

std::string jobs_where(std::string_view rest) {
  return fmt::format(
      "SELECT id, text_release, program, revision, sha256, machine, delivery, link, bytes_total, state, reason, "
      "created_by, armed_by, created_at_ms, armed_at_ms, started_at_ms, ended_at_ms, torn, confirmed_by, "
      "confirm_reason, "
      "confirmed_at_ms, expires_at_ms, read_back, reason_id, queue_rank, work_order, "
      "coalesce(held_ms, -1), (SELECT restart_of FROM text_release r WHERE r.id = job.text_release), (SELECT "
      "restart_line FROM text_release r WHERE r.id = job.text_release), coalesce(holds, -1), coalesce(line_ms, -1), "
      "coalesce(forecast_ms, -1), not_before_ms, choice, end_check, end_confirmed_by, end_note, end_confirmed_at_ms, "
      "hold_by, hold_reason, retry_of FROM job WHERE {}",
      rest);
}

Job read_job(Query& query) {
  Job job;
  job.id = query.number();
  job.release = query.number();
  job.program = query.number();
  job.revision = query.number();
  job.text_sha256 = query.text();
  job.machine = query.text();
  job.delivery = query.value<store::Delivery>();
  job.link = query.text();
  job.bytes_total = query.number();
  job.state = query.value<store::JobState>();
  job.reason = query.text();
  job.created_by = query.text();
  job.armed_by = query.text();
  job.created_at_ms = query.signed_number();
  job.armed_at_ms = query.signed_number();
  job.started_at_ms = query.signed_number();
  job.ended_at_ms = query.signed_number();
  job.torn = query.flag();
  job.confirmed_by = query.text();
  job.confirm_reason = query.text();
  job.confirmed_at_ms = query.signed_number();
  job.expires_at_ms = query.signed_number();
  job.read_back = query.text();
  job.reason_id = query.text();
  job.rank = query.number();
  job.order = query.number();
  job.held_ms = known(query.signed_number());
  job.restart.release = query.number();
  job.restart.line = query.number();
  if (const std::int64_t holds = query.signed_number(); holds >= 0) job.holds = static_cast<std::uint64_t>(holds);
  job.line_ms = known(query.signed_number());
  job.forecast_ms = known(query.signed_number());
  job.not_before_ms = query.signed_number();
  job.choice = query.number();
  job.end_check = query.text();
  job.end_confirmed_by = query.text();
  job.end_note = query.text();
  job.end_confirmed_at_ms = query.signed_number();
  job.hold_by = query.text();
  job.hold_reason = query.text();
  job.retry_of = query.number();
  return job;
}

Id insert_job(Session& session, const Job& job) {
  session.run(kInsert, job.release, job.program, job.revision, job.text_sha256, job.machine, job.delivery, job.link,
              job.bytes_total, job.state, job.created_by, job.created_at_ms, job.rank, NumberOrNull{job.order},
              job.not_before_ms, NumberOrNull{job.choice}, job.end_check, NumberOrNull{job.retry_of});
  const Id id = session.last_id();
  session.run(kInsertHead, id);
  return id;
}

void update_job(Session& session, const Job& job) {
  session.run(kUpdate, job.state, job.reason, job.armed_by, job.armed_at_ms, job.started_at_ms, job.ended_at_ms,
              job.torn, job.confirmed_by, job.confirm_reason, job.confirmed_at_ms, job.expires_at_ms, job.reason_id,
              job.not_before_ms, job.end_confirmed_by, job.end_note, job.end_confirmed_at_ms, job.hold_by,
              job.hold_reason, job.id);
  const auto set = [&](std::string_view sql, const auto& value) {
    if (value) session.run(sql, *value, job.id);
  };
  set("UPDATE job SET held_ms = ? WHERE id = ?", job.held_ms);
  set("UPDATE job SET holds = ? WHERE id = ?", job.holds);
  set("UPDATE job SET line_ms = ? WHERE id = ?", job.line_ms);
  set("UPDATE job SET forecast_ms = ? WHERE id = ?", job.forecast_ms);
}

store::Result<void> refuse_armed(Session& session, std::string_view column, Id id) {
  const std::string sql = fmt::format("SELECT id, machine FROM job WHERE {} = ? AND state = 'armed' LIMIT 1", column);
  Query query(session, sql, id);
  if (!query.next()) return {};
  const Id job = query.number();
  return session.refuse(store::ErrorCode::machine_busy,
                        fmt::format("job {} is armed on {}: disarm it before", job, query.text()));
}

std::uint64_t reserve_of(Session& session, Id job) {
  Query query(session, "SELECT reserve FROM ledger_head WHERE job = ?", job);
  return query.next() ? query.number() : 0;
}

}  // namespace dripfeed::sql
