// The SQL of version 1.
#pragma once

namespace dripfeed::postgresql {

extern const char* const kSchemaV1;

}  // namespace dripfeed::postgresql
