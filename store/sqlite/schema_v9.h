// Version 9: tags, folders and the archive of programs, and in which order programs were changed.
#pragma once

namespace dripfeed::sqlite {

extern const char* const kSchemaV9;

}  // namespace dripfeed::sqlite
