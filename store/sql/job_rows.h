// Jobs as rows: reading and writing their columns. Which change is allowed is decided in job_table.
#pragma once

#include "store/jobs.h"
#include "store/sql/session.h"

namespace dripfeed::sql {

// "2026-11-27 14:00:00 UTC", for people.
std::string utc_time(std::int64_t at_ms);
std::string job_subject(store::Id job);
// A SELECT of the columns that read_job() reads.
std::string jobs_where(std::string_view rest);
store::Job read_job(Query& query);
// With the empty head of its ledger; the new id.
store::Id insert_job(Session& session, const store::Job& job);
// All that may change of a job.
void update_job(Session& session, const store::Job& job);
// A job that was armed is sent as soon as its control asks, whatever becomes meanwhile of what it was made of: the row
// `id` that the job's `column` names. A feed that began goes on: no release and no order stops a line. Errors:
// machine_busy.
store::Result<void> refuse_armed(Session& session, std::string_view column, store::Id id);
// Of the ledger's last row, 0 without one.
std::uint64_t reserve_of(Session& session, store::Id job);

}  // namespace dripfeed::sql
