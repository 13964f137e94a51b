// What only a Haas has among the controls with #-variables, in code or as its name in a comment.
#pragma once

#include <span>
#include <string_view>

#include "dialects/ir/dialect_mark.h"

namespace dripfeed::haas {

std::span<const ir::DialectMark> marks();

}  // namespace dripfeed::haas
