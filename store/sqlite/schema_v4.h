// Version 4 of the schema, as SQL: an index that finds the torn job of a machine without walking all its jobs.
#pragma once

namespace dripfeed::sqlite {

extern const char* const kSchemaV4;

}  // namespace dripfeed::sqlite
