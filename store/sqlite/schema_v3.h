// Version 3 of the schema, as SQL: what controls punched, what their operators asked for, and what a read-back said.
#pragma once

namespace dripfeed::sqlite {

extern const char* const kSchemaV3;

}  // namespace dripfeed::sqlite
