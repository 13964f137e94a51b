// Real programs as families: what is proposed for one gives its bytes back, and a changed value changes one number.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "dialects/compile/dialect/dialect.h"

namespace dripfeed::corpus {

struct Wrapped {
  std::size_t parameters = 0;
  std::optional<std::string> fault;
};
Wrapped wrap(const text::Source& source, const compile::Dialect& dialect, const ir::Control& control);

}  // namespace dripfeed::corpus
