// An entry as bytes: numbers in decimal, texts with their length before them, so that a text may have any bytes.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "store/journal/entry.h"

namespace dripfeed::journal {

std::string text_of(const Entry& entry);
// Nothing where the bytes are not what text_of() writes.
std::optional<Entry> entry_of(std::string_view text);

}  // namespace dripfeed::journal
