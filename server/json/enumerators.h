// All names of an enum, from the function that writes them: a schema lists the same words as the documents have, also
// when the enum grows. The compiler is asked which values have an enumerator, for C++23 has no reflection.
#pragma once

#include <cstddef>
#include <string_view>

#include "server/json/schema.h"

namespace dripfeed::json {

// Of a value without an enumerator the compiler writes a cast: "(dripfeed::app::LineState)9".
template <auto Value>
consteval bool is_enumerator() {
  const std::string_view function = __PRETTY_FUNCTION__;
  return function.find("= (") == std::string_view::npos;
}

// How many enumerators an enum has that counts from 0 without a gap.
template <class Enum, std::size_t Count = 0>
consteval std::size_t enumerators() {
  if constexpr (is_enumerator<static_cast<Enum>(Count)>()) {
    return enumerators<Enum, Count + 1>();
  } else {
    return Count;
  }
}

// Without "", which stands for none and is shown as null.
template <class Enum>
Words names_of(std::string_view (*name)(Enum)) {
  Words words;
  for (std::size_t i = 0; i < enumerators<Enum>(); ++i) {
    const std::string_view word = name(static_cast<Enum>(i));
    if (!word.empty()) words.push_back(word);
  }
  return words;
}

}  // namespace dripfeed::json
