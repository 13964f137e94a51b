// What only a text of a SINUMERIK has. Small letters count as capitals at the start of a line alone: inside it
// they may be words of a comment.
#pragma once

#include <span>
#include <string_view>

#include "dialects/ir/dialect_mark.h"

namespace dripfeed::sinumerik {

std::span<const ir::DialectMark> marks();
// Endings of the names of its files, in capitals.
std::span<const std::string_view> file_endings();

}  // namespace dripfeed::sinumerik
