// What only a Mitsubishi has among the controls with #-variables, in code or as its name in a comment.
#pragma once

#include <span>
#include <string_view>

#include "dialects/ir/dialect_mark.h"

namespace dripfeed::mitsubishi {

std::span<const ir::DialectMark> marks();

}  // namespace dripfeed::mitsubishi
