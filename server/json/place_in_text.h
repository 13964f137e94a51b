// Where in a JSON text a member stands, for people who wrote it in an editor.
#pragma once

#include <cstdint>
#include <string_view>

namespace dripfeed::json {

struct TextPlace {
  std::uint32_t line = 0;    // from 1
  std::uint32_t column = 0;  // from 1, in bytes
  friend bool operator==(const TextPlace&, const TextPlace&) = default;
};

// Of the name of the member, or of the element, that a JSON pointer names. `text` is a document that parse() has taken.
// Where there is no such member (it is missing, or its name is written with escapes): of the object that should have
// it.
TextPlace place_in_text(std::string_view text, std::string_view pointer);

}  // namespace dripfeed::json
