// Statements are written with a question mark for each parameter; PostgreSQL wants "$1", "$2", …
#pragma once

#include <string>
#include <string_view>

namespace dripfeed::postgresql {

// A question mark in a text ('…'), a name ("…") or a comment stays.
std::string numbered_parameters(std::string_view sql);
// The table of an INSERT; "" for another statement.
std::string_view table_of_insert(std::string_view sql);

}  // namespace dripfeed::postgresql
