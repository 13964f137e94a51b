// Numbers made of digits alone: block numbers, G numbers, extensions of addresses.
#pragma once

#include <cstdint>
#include <string_view>

#include "dialects/sinumerik/tables/name_index.h"

namespace dripfeed::sinumerik {

inline constexpr std::uint32_t kNoNumber = 0xFFFFFFFFU;

// A whole number of digits only; kNoNumber for anything else and above nine digits.
inline std::uint32_t whole_number(std::string_view digits) {
  if (digits.empty() || digits.size() > 9) return kNoNumber;
  std::uint32_t value = 0;
  for (const char c : digits) {
    if (!is_digit(c)) return kNoNumber;
    value = value * 10 + static_cast<std::uint32_t>(c - '0');
  }
  return value;
}

}  // namespace dripfeed::sinumerik
