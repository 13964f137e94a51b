// The words of a language, found by what stands in a text: a code with or without its zeros, any case of letters, a
// numbered variable within its range.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/compile/dialect/language.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

class WordIndex {
 public:
  WordIndex() = default;
  explicit WordIndex(std::vector<DialectWord> words);

  // "g2" and "G002" are G02, "#5041" is in the range from #5021. nullptr when the language has no such word.
  [[nodiscard]] const DialectWord* find(std::string_view written) const;
  [[nodiscard]] const std::vector<DialectWord>& words() const { return words_; }

 private:
  std::vector<DialectWord> words_;
  std::map<std::string, std::size_t, std::less<>> by_key_;
};

// Where the word stands in which the offset lies: a name, or an address or '#' with the number that follows it. The
// end of a word counts where no other word begins there. Nothing in comments and texts.
std::optional<text::Span> written_word_at(const ir::Program& program, std::uint32_t offset);

}  // namespace dripfeed::compile
