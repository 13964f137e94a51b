// Never edited once it was published.
#include "store/sqlite/schema_v17.h"

namespace dripfeed::sqlite {

// `choice` is the first job of the choice, itself too.
const char* const kSchemaV17 = R"sql(
ALTER TABLE job ADD COLUMN holds INTEGER CHECK (holds >= 0);
ALTER TABLE job ADD COLUMN line_ms INTEGER CHECK (line_ms >= 0);
ALTER TABLE job ADD COLUMN forecast_ms INTEGER CHECK (forecast_ms >= 0);
ALTER TABLE job ADD COLUMN not_before_ms INTEGER NOT NULL DEFAULT 0 CHECK (not_before_ms >= 0);
ALTER TABLE job ADD COLUMN choice INTEGER REFERENCES job (id);
ALTER TABLE job ADD COLUMN end_check TEXT NOT NULL DEFAULT '';
ALTER TABLE job ADD COLUMN end_confirmed_by TEXT NOT NULL DEFAULT '';
ALTER TABLE job ADD COLUMN end_note TEXT NOT NULL DEFAULT '';
ALTER TABLE job ADD COLUMN end_confirmed_at_ms INTEGER NOT NULL DEFAULT 0 CHECK (end_confirmed_at_ms >= 0);
CREATE INDEX job_end_time ON job (ended_at_ms) WHERE ended_at_ms <> 0;
CREATE INDEX job_choice ON job (choice, state) WHERE choice IS NOT NULL;
CREATE INDEX job_end_waits ON job (machine, id)
  WHERE end_check <> '' AND end_confirmed_at_ms = 0 AND started_at_ms <> 0 AND ended_at_ms <> 0;
CREATE TRIGGER job_plan_update BEFORE UPDATE OF choice, end_check, end_confirmed_by, end_note, end_confirmed_at_ms ON job
WHEN NEW.end_check IS NOT OLD.end_check OR (OLD.choice IS NOT NULL AND NEW.choice IS NOT OLD.choice)
     OR (OLD.end_confirmed_at_ms <> 0 AND (NEW.end_confirmed_by, NEW.end_note, NEW.end_confirmed_at_ms)
         IS NOT (OLD.end_confirmed_by, OLD.end_note, OLD.end_confirmed_at_ms))
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
)sql";

}  // namespace dripfeed::sqlite
