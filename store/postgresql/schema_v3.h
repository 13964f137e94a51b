// Version 3 of the schema, as SQL.
#pragma once

namespace dripfeed::postgresql {

extern const char* const kSchemaV3;

}  // namespace dripfeed::postgresql
