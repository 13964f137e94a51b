// The keyword table and the matching of keywords in a run of letters, where addresses and keywords touch each other:
// XROUND[#1] is X and ROUND, #20NEFIX[#20] is NE and FIX.
#include "dialects/macro_b/tables/grammar.h"

#include <algorithm>

namespace dripfeed::macro_b {

namespace {

using enum KeywordRole;
using ir::Operator;

constexpr auto kKeywords = std::to_array<Keyword>({
    {"ABS", function, Operator::abs},
    {"ACOS", function, Operator::acos},
    {"ADP", unmodelled_function},
    {"AND", infix, Operator::bit_and},
    {"ASIN", function, Operator::asin},
    {"ATAN", function, Operator::atan},
    {"BCD", function, Operator::bcd},
    {"BIN", function, Operator::bin},
    {"BPRNT", output},
    {"COS", function, Operator::cos},
    {"DO", do_word},
    {"DPRNT", output},
    {"ELSE", else_word},
    {"END", end_word},
    {"ENDIF", end_if},
    {"EQ", infix, Operator::equal},
    {"EXP", function, Operator::exp},
    {"FIX", function, Operator::truncate},
    {"FUP", function, Operator::round_up},
    {"GE", infix, Operator::greater_equal},
    {"GOTO", go_to},
    {"GT", infix, Operator::greater},
    {"IF", if_word},
    {"LE", infix, Operator::less_equal},
    {"LN", function, Operator::ln},
    {"LT", infix, Operator::less},
    {"MOD", infix, Operator::modulo},
    {"NE", infix, Operator::not_equal},
    {"OR", infix, Operator::bit_or},
    {"PCLOS", output},
    {"POPEN", output},
    {"POW", function, Operator::power},
    {"PRM", unmodelled_function},
    {"ROUND", function, Operator::round},
    {"SETVN", set_name},
    {"SIN", function, Operator::sin},
    {"SQRT", function, Operator::sqrt},
    {"TAN", function, Operator::tan},
    {"THEN", then_word},
    {"WHILE", while_word},
    {"XOR", infix, Operator::bit_xor},
});
static_assert(std::ranges::is_sorted(kKeywords, {}, &Keyword::spelling));

constexpr bool is_letter(char c) { return c >= 'A' && c <= 'Z'; }
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

// What may follow a keyword that is shortened to two letters: without it MO[ would be found in M O…
bool can_follow(KeywordRole role, char next) {
  switch (role) {
    case function:
    case unmodelled_function:
    case if_word:
    case while_word:
    case output: return next == '[';
    case go_to: return next == '[' || next == '#' || is_digit(next);
    case do_word:
    case end_word:
    case set_name: return is_digit(next);
    case infix: return next == '[' || next == '#' || next == '-' || is_digit(next);
    case then_word: return next == '#' || is_letter(next);
    case else_word:
    case end_if: return false;
  }
  return false;
}

}  // namespace

KeywordIndex::KeywordIndex(std::span<const Keyword> table) : table_(table) {
  for (std::size_t letter = 0; letter < first_of_.size(); ++letter) {
    const auto row = std::ranges::find_if(
        table_, [&](const Keyword& k) { return static_cast<std::size_t>(k.spelling.front() - 'A') >= letter; });
    first_of_[letter] = static_cast<std::uint16_t>(row - table_.begin());
  }
}

std::span<const Keyword> KeywordIndex::starting_with(char letter) const {
  const auto index = static_cast<std::size_t>(letter - 'A');
  return table_.subspan(first_of_[index], static_cast<std::size_t>(first_of_[index + 1] - first_of_[index]));
}

KeywordIndex::Match KeywordIndex::match(std::string_view text) const {
  Match best;
  if (!is_letter(text.front())) return best;
  for (const Keyword& keyword : starting_with(text.front())) {
    if (text.starts_with(keyword.spelling) && keyword.spelling.size() > best.length) {
      best = {&keyword, static_cast<std::uint32_t>(keyword.spelling.size())};
    }
  }
  const std::size_t after = text.find_first_not_of(" \t", 2);
  if (best.keyword != nullptr || after == std::string_view::npos) return best;
  const char next = text[after];
  for (const Keyword& keyword : starting_with(text.front())) {
    if (keyword.spelling.size() > 2 && keyword.spelling[1] == text[1] && can_follow(keyword.role, next)) {
      return {&keyword, 2};
    }
  }
  return best;
}

std::span<const Keyword> common_keywords() { return kKeywords; }

std::string_view spelling_of(const Grammar& grammar, ir::Operator op) {
  const auto row = std::ranges::find_if(
      grammar.keywords, [&](const Keyword& k) { return (k.role == function || k.role == infix) && k.op == op; });
  return row == grammar.keywords.end() ? std::string_view() : row->spelling;
}

}  // namespace dripfeed::macro_b
