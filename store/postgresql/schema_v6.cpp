// Never edited once it was published.
#include "store/postgresql/schema_v6.h"

namespace dripfeed::postgresql {

const char* const kSchemaV6 = R"sql(
ALTER TABLE job ADD COLUMN holds BIGINT CHECK (holds >= 0);
ALTER TABLE job ADD COLUMN line_ms BIGINT CHECK (line_ms >= 0);
ALTER TABLE job ADD COLUMN forecast_ms BIGINT CHECK (forecast_ms >= 0);
ALTER TABLE job ADD COLUMN not_before_ms BIGINT NOT NULL DEFAULT 0 CHECK (not_before_ms >= 0);
ALTER TABLE job ADD COLUMN choice BIGINT REFERENCES job (id);
ALTER TABLE job ADD COLUMN end_check bytewise NOT NULL DEFAULT '';
ALTER TABLE job ADD COLUMN end_confirmed_by bytewise NOT NULL DEFAULT '';
ALTER TABLE job ADD COLUMN end_note bytewise NOT NULL DEFAULT '';
ALTER TABLE job ADD COLUMN end_confirmed_at_ms BIGINT NOT NULL DEFAULT 0 CHECK (end_confirmed_at_ms >= 0);
CREATE INDEX job_end_time ON job (ended_at_ms) WHERE ended_at_ms <> 0;
CREATE INDEX job_choice ON job (choice, state) WHERE choice IS NOT NULL;
CREATE INDEX job_end_waits ON job (machine, id)
  WHERE end_check <> '' AND end_confirmed_at_ms = 0 AND started_at_ms <> 0 AND ended_at_ms <> 0;
CREATE TRIGGER job_plan_update BEFORE UPDATE ON job FOR EACH ROW
WHEN (NEW.end_check IS DISTINCT FROM OLD.end_check OR (OLD.choice IS NOT NULL AND NEW.choice IS DISTINCT FROM OLD.choice)
      OR (OLD.end_confirmed_at_ms <> 0 AND (NEW.end_confirmed_by, NEW.end_note, NEW.end_confirmed_at_ms)
          IS DISTINCT FROM (OLD.end_confirmed_by, OLD.end_note, OLD.end_confirmed_at_ms)))
EXECUTE FUNCTION refuse_change();
)sql";

}  // namespace dripfeed::postgresql
