// Version 6: alarms.
#pragma once

namespace dripfeed::sqlite {

extern const char* const kSchemaV6;

}  // namespace dripfeed::sqlite
