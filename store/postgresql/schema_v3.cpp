// Version 3 of the schema: how far the journals of servers are booked. Never edited once it was published.
#include "store/postgresql/schema_v3.h"

namespace dripfeed::postgresql {

const char* const kSchemaV3 = R"sql(
CREATE TABLE journal (
  name bytewise PRIMARY KEY CHECK (length(name) = 64), booked BIGINT NOT NULL CHECK (booked >= 0));
)sql";

}  // namespace dripfeed::postgresql
