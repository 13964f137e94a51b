// Never edited once it was published.
#include "store/postgresql/schema_v10.h"

namespace dripfeed::postgresql {

// An operator signs a proving off where the machine's group does not waive that; a queued job may be put on hold, and
// one that ended queued again. A server of an older version arms a job that is on hold here.
const char* const kSchemaV10 = R"sql(
ALTER TABLE machine_group ADD COLUMN operator_sign_off BIGINT NOT NULL DEFAULT 1 CHECK (operator_sign_off IN (0, 1));
ALTER TABLE job ADD COLUMN hold_by bytewise NOT NULL DEFAULT '';
ALTER TABLE job ADD COLUMN hold_reason bytewise NOT NULL DEFAULT '';
ALTER TABLE job ADD COLUMN retry_of BIGINT REFERENCES job (id);
CREATE INDEX job_release ON job (text_release, started_at_ms) WHERE state = 'done';
)sql";

}  // namespace dripfeed::postgresql
