// Never edited once it was published.
#include "store/sqlite/schema_v9.h"

namespace dripfeed::sqlite {

// Programs from before were changed in the order of their ids, as far as anybody knows.
const char* const kSchemaV9 = R"sql(
ALTER TABLE program ADD COLUMN folder TEXT NOT NULL DEFAULT '';
ALTER TABLE program ADD COLUMN archived_at_ms INTEGER NOT NULL DEFAULT 0 CHECK (archived_at_ms >= 0);
ALTER TABLE program ADD COLUMN archived_by TEXT NOT NULL DEFAULT '';
ALTER TABLE program ADD COLUMN archive_reason TEXT NOT NULL DEFAULT '';
ALTER TABLE program ADD COLUMN change_number INTEGER NOT NULL DEFAULT 0 CHECK (change_number >= 0);
UPDATE program SET change_number = id;
CREATE INDEX program_change ON program (change_number);
CREATE INDEX program_folder ON program (folder) WHERE folder <> '';
CREATE TABLE program_tag (
  program INTEGER NOT NULL REFERENCES program (id), tag TEXT NOT NULL CHECK (tag <> ''),
  PRIMARY KEY (program, tag)) STRICT, WITHOUT ROWID;
CREATE INDEX program_tag_tag ON program_tag (tag, program);
CREATE INDEX job_program ON job (program, id);
)sql";

}  // namespace dripfeed::sqlite
