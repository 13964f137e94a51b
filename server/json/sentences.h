// Sentences of the server as a stable id with values, so that others say them in their language. The sentence itself is
// what is stored and logged; its words are found again here, and one that is not in the table is shown as it came.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dripfeed::json {

struct KnownSentence {
  std::string_view id;
  // By the names in the pattern; `detail` is what the store added in brackets.
  std::vector<std::pair<std::string_view, std::string_view>> values;
};

// Into `sentence`.
std::optional<KnownSentence> sentence_of(std::string_view sentence);
// All ids, in the order of the table.
std::vector<std::string_view> sentence_ids();

}  // namespace dripfeed::json
