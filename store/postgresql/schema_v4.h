// The SQL of version 4: programs that were deleted.
#pragma once

namespace dripfeed::postgresql {

extern const char* const kSchemaV4;

}  // namespace dripfeed::postgresql
