// Never edited once it was published.
#include "store/sqlite/schema_v12.h"

namespace dripfeed::sqlite {

const char* const kSchemaV12 = R"sql(
CREATE TABLE verdict_call (
  verdict INTEGER NOT NULL REFERENCES verdict (id), name TEXT NOT NULL CHECK (name <> ''),
  program INTEGER NOT NULL, revision INTEGER NOT NULL, PRIMARY KEY (verdict, name),
  FOREIGN KEY (program, revision) REFERENCES program_revision (program, revision)) STRICT, WITHOUT ROWID;
CREATE TRIGGER verdict_call_update BEFORE UPDATE ON verdict_call BEGIN SELECT RAISE(ABORT, 'append-only'); END;
CREATE TRIGGER verdict_call_delete BEFORE DELETE ON verdict_call BEGIN SELECT RAISE(ABORT, 'append-only'); END;
)sql";

}  // namespace dripfeed::sqlite
