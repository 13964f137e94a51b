// What SQLite's result codes mean to the store.
#pragma once

#include "store/error.h"

struct sqlite3;

namespace dripfeed::sqlite {

// The error of the connection's last call, by its extended result code. `about` names what the call was for; the
// engine's own words follow it.
store::Error fault_of(sqlite3* connection, std::string_view about);
store::ErrorCode code_of(int extended_result_code);

}  // namespace dripfeed::sqlite
