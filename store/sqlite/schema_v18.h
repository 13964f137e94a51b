// Version 18: users whom an OpenID Connect provider vouches for.
#pragma once

namespace dripfeed::sqlite {

extern const char* const kSchemaV18;

}  // namespace dripfeed::sqlite
