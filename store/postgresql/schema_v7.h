// Version 7: users whom an OpenID Connect provider vouches for.
#pragma once

namespace dripfeed::postgresql {

extern const char* const kSchemaV7;

}  // namespace dripfeed::postgresql
