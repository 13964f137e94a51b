// The words of a control's language, each with a line for people: what an editor shows next to a word. The spellings
// are the dialects' own tables'; a code (G02, DIAMON) says by its function what it does.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/ir/expression.h"
#include "dialects/ir/function.h"

namespace dripfeed::ir {

enum class WordSort : std::uint8_t { code, keyword, function, cycle, variable };
// By WordSort.
inline constexpr std::array<std::string_view, 5> kWordSortNames = {"code", "keyword", "function", "cycle", "variable"};
constexpr std::string_view name_of(WordSort sort) { return kWordSortNames[static_cast<std::size_t>(sort)]; }

// What a run makes of a word.
enum class WordState : std::uint8_t {
  interpreted,
  without_effect,  // on what is checked
  reported,        // known to the control and not to us: what it does is named as not known
};
// By WordState.
inline constexpr std::array<std::string_view, 3> kWordStateNames = {"interpreted", "without-effect", "reported"};
constexpr std::string_view name_of(WordState state) { return kWordStateNames[static_cast<std::size_t>(state)]; }

// A word that is not a code.
struct LanguageWord {
  std::string_view spelling;
  WordSort sort = WordSort::keyword;
  std::string_view about;
  WordState state = WordState::interpreted;
};

// What an operator or function gives, in a few words; "" for leaves.
std::string_view about_operator(Operator op);
// What a code does, in a few words.
std::string about_code(const CodeRow& row);
WordState state_of(const CodeRow& row);

}  // namespace dripfeed::ir
