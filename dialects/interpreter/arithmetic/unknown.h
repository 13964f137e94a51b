// Texts that hold a part that is not known. Numbers that are not known are NaN (arithmetic.h); a text carries a mark
// that no program can write, so that what is made from it is known to be unknown, too.
#pragma once

#include <string_view>

namespace dripfeed::interpreter {

inline constexpr char kUnknownMark = '\x1A';
inline constexpr std::string_view kUnknownText = "\x1A";
constexpr bool is_unknown(std::string_view text) { return text.find(kUnknownMark) != std::string_view::npos; }

}  // namespace dripfeed::interpreter
