// Never edited once it was published.
#include "store/postgresql/schema_v7.h"

namespace dripfeed::postgresql {

const char* const kSchemaV7 = R"sql(
ALTER TABLE account ADD COLUMN provider bytewise NOT NULL DEFAULT '';
ALTER TABLE account ADD COLUMN provider_subject bytewise NOT NULL DEFAULT '';
CREATE UNIQUE INDEX account_of_provider ON account (provider, provider_subject) WHERE provider <> '';
CREATE TRIGGER account_provider_update BEFORE UPDATE ON account FOR EACH ROW
WHEN ((NEW.provider, NEW.provider_subject) IS DISTINCT FROM (OLD.provider, OLD.provider_subject))
EXECUTE FUNCTION refuse_change();
ALTER TABLE browser_session ADD COLUMN by_provider BIGINT NOT NULL DEFAULT 0 CHECK (by_provider IN (0, 1));
)sql";

}  // namespace dripfeed::postgresql
