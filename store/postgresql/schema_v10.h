// Version 10: an operator's sign-off; jobs on hold, and queued again.
#pragma once

namespace dripfeed::postgresql {

extern const char* const kSchemaV10;

}  // namespace dripfeed::postgresql
