// Never edited once it was published.
#include "store/sqlite/schema_v16.h"

namespace dripfeed::sqlite {

// A deleted program's row stays, so that its id never comes back and what names it stays true. Its revisions may go,
// where no foreign key names them; their contents then go as those of all others.
const char* const kSchemaV16 = R"sql(
ALTER TABLE program ADD COLUMN deleted_at_ms INTEGER NOT NULL DEFAULT 0 CHECK (deleted_at_ms >= 0);
ALTER TABLE program ADD COLUMN deleted_by TEXT NOT NULL DEFAULT '';
ALTER TABLE program ADD COLUMN delete_reason TEXT NOT NULL DEFAULT '';
DROP TRIGGER program_revision_delete;
CREATE TRIGGER program_revision_delete BEFORE DELETE ON program_revision
WHEN NOT EXISTS (SELECT 1 FROM program WHERE id = OLD.program AND deleted_at_ms <> 0)
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE INDEX receipt_program ON receipt (program, revision) WHERE program IS NOT NULL;
CREATE INDEX verdict_call_program ON verdict_call (program, revision);
)sql";

}  // namespace dripfeed::sqlite
