// A number in the form in which a native program has it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "dialects/compile/native/native_targets.h"

namespace dripfeed::compile {

struct NativeNumber {
  std::optional<std::string> text;
  std::string why;  // without a text
};

// `value` in the place of `old`: with a point where the old number has one, with as many decimals as it needs and
// `most_digits` allow (0: no limit). A value that the program has already keeps its bytes.
NativeNumber number_in_place(const NativeConstant& old, std::string_view old_text, double value,
                             std::uint32_t most_digits);

}  // namespace dripfeed::compile
