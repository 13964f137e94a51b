// Version 8: servers of neighbouring versions on one store.
#pragma once

namespace dripfeed::postgresql {

extern const char* const kSchemaV8;

}  // namespace dripfeed::postgresql
