// Never edited once it was published.
#include "store/sqlite/schema_v7.h"

namespace dripfeed::sqlite {

const char* const kSchemaV7 = R"sql(
CREATE TABLE browser_session (
  hash TEXT PRIMARY KEY CHECK (hash <> ''), token INTEGER NOT NULL REFERENCES token (id),
  opened_at_ms INTEGER NOT NULL, used_at_ms INTEGER NOT NULL CHECK (used_at_ms >= opened_at_ms)) STRICT, WITHOUT ROWID;
CREATE INDEX browser_session_token ON browser_session (token, used_at_ms);
)sql";

}  // namespace dripfeed::sqlite
