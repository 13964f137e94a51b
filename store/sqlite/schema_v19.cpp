// Never edited once it was published.
#include "store/sqlite/schema_v19.h"

namespace dripfeed::sqlite {

// `rules`: the revision of the code that judged; '' for a verdict of a program that did not state it.
const char* const kSchemaV19 = R"sql(
ALTER TABLE verdict ADD COLUMN rules TEXT NOT NULL DEFAULT '';
CREATE TRIGGER verdict_rules_update BEFORE UPDATE OF rules ON verdict
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
)sql";

}  // namespace dripfeed::sqlite
