// Languages that are read and run, but not written: no program is translated to or from them, and they are in no list
// of dialects.
#pragma once

#include <string_view>

#include "dialects/compile/dialect/dialect.h"

namespace dripfeed::compile {

// A dialect, or one that is only read: there `raise` and `print` are nullptr. nullptr when there is none of that name.
const Dialect* find_reader(std::string_view name);

}  // namespace dripfeed::compile
