// Never edited once it was published.
#include "store/postgresql/schema_v9.h"

namespace dripfeed::postgresql {

// `rules`: the revision of the code that judged; '' for a verdict of a program that did not state it.
const char* const kSchemaV9 = R"sql(
ALTER TABLE verdict ADD COLUMN rules bytewise NOT NULL DEFAULT '';
CREATE TRIGGER verdict_rules_update BEFORE UPDATE ON verdict FOR EACH ROW
WHEN (NEW.rules IS DISTINCT FROM OLD.rules)
EXECUTE FUNCTION refuse_change();
)sql";

}  // namespace dripfeed::postgresql
