// Texts of the store may have any bytes: a name may come from a control. PostgreSQL takes UTF-8 without zero bytes.
// Each byte that is not a part of such a text goes there as a character of its own, U+10FF00 and on, which no one else
// uses.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace dripfeed::postgresql {

// Nothing: the text goes as it is.
std::optional<std::string> to_database(std::string_view text);
// The text that to_database() had. Nothing: it is as it came.
std::optional<std::string> from_database(std::string_view text);

}  // namespace dripfeed::postgresql
