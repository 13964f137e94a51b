// Version 10: users, groups of machines, and tokens with a user, a scope and an end.
#pragma once

namespace dripfeed::sqlite {

extern const char* const kSchemaV10;

}  // namespace dripfeed::sqlite
