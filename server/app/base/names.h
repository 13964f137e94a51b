// The one rule for names: of machines, families, parts, programs, receipts that are accepted, tokens. A name stands in
// paths of the API, in headers, in logs and on screens. What a control asks of the name of a file is apart from it
// (machine::file_name_for).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace dripfeed::app {

inline constexpr std::size_t kLongestName_bytes = 200;

// What is wrong with a name, as the end of a sentence ("must not be empty"); "" where nothing is.
std::string why_no_name(std::string_view name);

inline constexpr std::size_t kLongestFolder_bytes = 200;

// The same of a folder of the library: names with slashes between. "" is no folder, and nothing is wrong with it.
std::string why_no_folder(std::string_view folder);

}  // namespace dripfeed::app
