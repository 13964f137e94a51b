// What only a Mazak has among the controls with #-variables, in code or as its name in a comment.
#pragma once

#include <span>
#include <string_view>

#include "dialects/ir/dialect_mark.h"

namespace dripfeed::mazak {

std::span<const ir::DialectMark> marks();
// Endings of the names of its files, in capitals.
std::span<const std::string_view> file_endings();

}  // namespace dripfeed::mazak
