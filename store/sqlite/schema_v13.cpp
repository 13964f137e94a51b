// Never edited once it was published.
#include "store/sqlite/schema_v13.h"

namespace dripfeed::sqlite {

// Of a restart: the release whose text it continues, and the line of that text where it begins.
const char* const kSchemaV13 = R"sql(
ALTER TABLE text_release ADD COLUMN restart_of INTEGER REFERENCES text_release (id);
ALTER TABLE text_release ADD COLUMN restart_line INTEGER NOT NULL DEFAULT 0 CHECK ((restart_of IS NULL) = (restart_line = 0));
CREATE TRIGGER text_release_restart_update BEFORE UPDATE OF restart_of, restart_line ON text_release
WHEN (NEW.restart_of, NEW.restart_line) IS NOT (OLD.restart_of, OLD.restart_line)
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
)sql";

}  // namespace dripfeed::sqlite
