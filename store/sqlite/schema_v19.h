// Version 19: users whom an OpenID Connect provider vouches for.
#pragma once

namespace dripfeed::sqlite {

extern const char* const kSchemaV19;

}  // namespace dripfeed::sqlite
