// Version 7: sessions of browsers outlive the server.
#pragma once

namespace dripfeed::sqlite {

extern const char* const kSchemaV7;

}  // namespace dripfeed::sqlite
