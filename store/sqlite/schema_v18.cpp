// Never edited once it was published.
#include "store/sqlite/schema_v18.h"

namespace dripfeed::sqlite {

// `provider` is the issuer, '' for an account of this shop alone; `provider_subject` is whom it means. A session by a
// provider counts as one by a password.
const char* const kSchemaV18 = R"sql(
ALTER TABLE account ADD COLUMN provider TEXT NOT NULL DEFAULT '';
ALTER TABLE account ADD COLUMN provider_subject TEXT NOT NULL DEFAULT '';
CREATE UNIQUE INDEX account_of_provider ON account (provider, provider_subject) WHERE provider <> '';
CREATE TRIGGER account_provider_update BEFORE UPDATE OF provider, provider_subject ON account
BEGIN SELECT RAISE(ABORT, 'append-only'); END;
ALTER TABLE browser_session ADD COLUMN by_provider INTEGER NOT NULL DEFAULT 0 CHECK (by_provider IN (0, 1));
)sql";

}  // namespace dripfeed::sqlite
