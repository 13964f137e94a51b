// Never edited once it was published.
#include "store/sqlite/schema_v8.h"

namespace dripfeed::sqlite {

// Jobs from before have the rank 0, so that they stand in the order of their ids before all that came later.
const char* const kSchemaV8 = R"sql(
ALTER TABLE job ADD COLUMN queue_rank INTEGER NOT NULL DEFAULT 0 CHECK (queue_rank >= 0);
ALTER TABLE job ADD COLUMN reason_id TEXT NOT NULL DEFAULT '';
ALTER TABLE job ADD COLUMN held_ms INTEGER CHECK (held_ms >= 0);
CREATE INDEX job_queue ON job (machine, queue_rank, id) WHERE state = 'queued';
CREATE INDEX job_ended ON job (machine, ended_at_ms);
)sql";

}  // namespace dripfeed::sqlite
