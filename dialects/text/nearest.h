// Which known word a misspelled one most likely means.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace dripfeed::text {

// Changes (insert, drop, replace a letter) from one word to the other.
std::size_t edit_distance(std::string_view a, std::string_view b);
// From so many changes on another word is too far from `word` to be meant: one in three letters, and two more.
std::size_t far_from(std::string_view word);
// The word that is most like `word`; "" when none is near.
std::string_view nearest_of(std::string_view word, std::span<const std::string_view> words);

}  // namespace dripfeed::text
