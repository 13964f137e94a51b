// Version 19: the revision of the rules by which a verdict was reached.
#pragma once

namespace dripfeed::sqlite {

extern const char* const kSchemaV19;

}  // namespace dripfeed::sqlite
