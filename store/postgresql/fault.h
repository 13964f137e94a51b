// What PostgreSQL's error codes mean to the store.
#pragma once

#include <string_view>

#include "store/error.h"

namespace dripfeed::postgresql {

// Of an SQLSTATE, five letters or digits; "" stands for a connection that broke.
store::ErrorCode code_of(std::string_view sql_state);

}  // namespace dripfeed::postgresql
