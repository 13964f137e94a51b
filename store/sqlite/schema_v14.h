// Version 14: waivers of single points, and waivers that end.
#pragma once

namespace dripfeed::sqlite {

extern const char* const kSchemaV14;

}  // namespace dripfeed::sqlite
