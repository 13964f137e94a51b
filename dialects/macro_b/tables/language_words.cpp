// What a keyword is for stands with its role; of functions and infix words it is the operator's.
#include "dialects/macro_b/tables/language_words.h"

namespace dripfeed::macro_b {

namespace {

struct RoleText {
  ir::WordSort sort = ir::WordSort::keyword;
  std::string_view about;
};

RoleText text_of(const Keyword& keyword) {
  switch (keyword.role) {
    case KeywordRole::if_word: return {ir::WordSort::keyword, "condition of a jump or a statement"};
    case KeywordRole::then_word: return {ir::WordSort::keyword, "what is done where the condition holds"};
    case KeywordRole::else_word: return {ir::WordSort::keyword, "what is done where the condition does not hold"};
    case KeywordRole::end_if: return {ir::WordSort::keyword, "end of a condition"};
    case KeywordRole::go_to: return {ir::WordSort::keyword, "jump to a block number"};
    case KeywordRole::while_word: return {ir::WordSort::keyword, "loop as long as the condition holds"};
    case KeywordRole::do_word: return {ir::WordSort::keyword, "start of a loop"};
    case KeywordRole::end_word: return {ir::WordSort::keyword, "end of a loop"};
    case KeywordRole::function: return {ir::WordSort::function, ir::about_operator(keyword.op)};
    case KeywordRole::infix: return {ir::WordSort::keyword, ir::about_operator(keyword.op)};
    case KeywordRole::unmodelled_function:
      return {ir::WordSort::function, "known to the control; its value is the control's"};
    case KeywordRole::output: return {ir::WordSort::keyword, "output to a device: neither moves nor changes state"};
    case KeywordRole::set_name: return {ir::WordSort::keyword, "gives variables names"};
  }
  return {};
}

}  // namespace

std::vector<ir::LanguageWord> language_words(const Grammar& grammar) {
  std::vector<ir::LanguageWord> words;
  words.reserve(grammar.keywords.size());
  for (const Keyword& keyword : grammar.keywords) {
    const RoleText text = text_of(keyword);
    const bool is_reported = keyword.role == KeywordRole::unmodelled_function;
    const bool is_quiet = keyword.role == KeywordRole::output || keyword.role == KeywordRole::set_name;
    words.push_back({keyword.spelling, text.sort, text.about,
                     is_reported ? ir::WordState::reported
                     : is_quiet  ? ir::WordState::without_effect
                                 : ir::WordState::interpreted});
  }
  return words;
}

}  // namespace dripfeed::macro_b
