// The SQL of version 5: programs that were deleted.
#pragma once

namespace dripfeed::postgresql {

extern const char* const kSchemaV5;

}  // namespace dripfeed::postgresql
