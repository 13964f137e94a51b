// Version 16: programs that were deleted.
#pragma once

namespace dripfeed::sqlite {

extern const char* const kSchemaV16;

}  // namespace dripfeed::sqlite
