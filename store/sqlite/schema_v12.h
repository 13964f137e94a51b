// Version 12: which programs of the library a verdict was made with.
#pragma once

namespace dripfeed::sqlite {

extern const char* const kSchemaV12;

}  // namespace dripfeed::sqlite
