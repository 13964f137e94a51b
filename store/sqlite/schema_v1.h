// Version 1 of the schema, as SQL.
#pragma once

namespace dripfeed::sqlite {

extern const char* const kSchemaV1;

}  // namespace dripfeed::sqlite
