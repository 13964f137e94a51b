// Names whose upper and lower case are one.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace dripfeed::text {

// ASCII letters; all other bytes stay.
inline std::string upper_case(std::string_view name) {
  std::string out(name);
  std::ranges::transform(out, out.begin(),
                         [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return out;
}

}  // namespace dripfeed::text
