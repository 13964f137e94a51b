// Version 17: what a job's line did, jobs that are planned and chosen, and ends that a person confirms.
#pragma once

namespace dripfeed::sqlite {

extern const char* const kSchemaV17;

}  // namespace dripfeed::sqlite
