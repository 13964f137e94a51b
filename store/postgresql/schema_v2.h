// The SQL of version 2.
#pragma once

namespace dripfeed::postgresql {

extern const char* const kSchemaV2;

}  // namespace dripfeed::postgresql
