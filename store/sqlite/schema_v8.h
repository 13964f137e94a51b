// Version 8: the order of the jobs that wait, why a job moved as a word, and how long its control held.
#pragma once

namespace dripfeed::sqlite {

extern const char* const kSchemaV8;

}  // namespace dripfeed::sqlite
