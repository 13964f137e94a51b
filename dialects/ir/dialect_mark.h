// What a line of a text holds that only one dialect has: by these a text without a name shows whose it is.
#pragma once

#include <string_view>

namespace dripfeed::ir {

struct DialectMark {
  std::string_view text;
  bool at_start = false;  // blanks and a block number before it count as nothing
};

}  // namespace dripfeed::ir
