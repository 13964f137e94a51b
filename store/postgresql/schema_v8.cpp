// Never edited once it was published.
#include "store/postgresql/schema_v8.h"

namespace dripfeed::postgresql {

// `needs`: the oldest schema whose programs work with the store once it has this one; NULL: the version itself.
// `knows`: the newest schema of the program that the node runs. Programs before this one know 7 and do not write it.
const char* const kSchemaV8 = R"sql(
ALTER TABLE migration ADD COLUMN needs BIGINT CHECK (needs > 0 AND needs <= version);
ALTER TABLE node ADD COLUMN knows BIGINT NOT NULL DEFAULT 7;
)sql";

}  // namespace dripfeed::postgresql
