// Version 15: attachments.
#pragma once

namespace dripfeed::sqlite {

extern const char* const kSchemaV15;

}  // namespace dripfeed::sqlite
