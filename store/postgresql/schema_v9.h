// Version 9: by what a verdict was made.
#pragma once

namespace dripfeed::postgresql {

extern const char* const kSchemaV9;

}  // namespace dripfeed::postgresql
