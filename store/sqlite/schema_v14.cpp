// Never edited once it was published.
#include "store/sqlite/schema_v14.h"

namespace dripfeed::sqlite {

// The points of a verdict; of a waiver, '' stands for all of them, and 0 for no end.
const char* const kSchemaV14 = R"sql(
CREATE TABLE verdict_point (
  verdict INTEGER NOT NULL REFERENCES verdict (id), n INTEGER NOT NULL, text TEXT NOT NULL CHECK (text <> ''),
  PRIMARY KEY (verdict, n)) STRICT, WITHOUT ROWID;
CREATE TRIGGER verdict_point_update BEFORE UPDATE ON verdict_point BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER verdict_point_delete BEFORE DELETE ON verdict_point BEGIN SELECT RAISE(ABORT, 'append-only'); END;
ALTER TABLE waiver ADD COLUMN point TEXT NOT NULL DEFAULT '';
ALTER TABLE waiver ADD COLUMN expires_at_ms INTEGER NOT NULL DEFAULT 0;
)sql";

}  // namespace dripfeed::sqlite
