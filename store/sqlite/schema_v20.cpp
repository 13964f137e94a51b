// Never edited once it was published.
#include "store/sqlite/schema_v20.h"

namespace dripfeed::sqlite {

// An operator signs a proving off where the machine's group does not waive that; a queued job may be put on hold, and
// one that ended queued again.
const char* const kSchemaV20 = R"sql(
ALTER TABLE machine_group ADD COLUMN operator_sign_off INTEGER NOT NULL DEFAULT 1 CHECK (operator_sign_off IN (0, 1));
ALTER TABLE job ADD COLUMN hold_by TEXT NOT NULL DEFAULT '';
ALTER TABLE job ADD COLUMN hold_reason TEXT NOT NULL DEFAULT '';
ALTER TABLE job ADD COLUMN retry_of INTEGER REFERENCES job (id);
CREATE INDEX job_release ON job (text_release, started_at_ms) WHERE state = 'done';
)sql";

}  // namespace dripfeed::sqlite
