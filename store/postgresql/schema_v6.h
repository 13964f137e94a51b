// Version 6: what a job's line did, jobs that are planned and chosen, and ends that a person confirms.
#pragma once

namespace dripfeed::postgresql {

extern const char* const kSchemaV6;

}  // namespace dripfeed::postgresql
