// What only a text of a control with #-variables has, whichever of them it is.
#pragma once

#include <span>
#include <string_view>

#include "dialects/ir/dialect_mark.h"

namespace dripfeed::macro_b {

std::span<const ir::DialectMark> marks();

}  // namespace dripfeed::macro_b
