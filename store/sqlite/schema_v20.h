// Version 20: an operator's sign-off; jobs on hold, and queued again.
#pragma once

namespace dripfeed::sqlite {

extern const char* const kSchemaV20;

}  // namespace dripfeed::sqlite
