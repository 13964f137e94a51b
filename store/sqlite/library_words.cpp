// Words of a program have a letter and a number; controls read G1 and G01 alike, so both are looked for.
#include "store/sqlite/library_words.h"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

namespace dripfeed::sqlite {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
// As the tokenizer sees it, all beyond ASCII is a letter.
bool is_word(char c) { return is_digit(c) || is_letter(c) || static_cast<unsigned char>(c) >= 0x80U; }
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool has_word(std::string_view text) { return std::ranges::any_of(text, is_word); }

std::string in_quotes(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    if (c != '\0') out += c;
  }
  return out + '"';
}

// A word of a program or a number, or nothing: "T0505" has the letter T and the number 505.
struct CodeWord {
  std::string_view letter;
  std::string_view digits;
};
std::optional<CodeWord> code_word(std::string_view term) {
  const std::size_t letters = !term.empty() && is_letter(term.front()) ? 1 : 0;
  const std::string_view digits = term.substr(letters);
  if (digits.empty() || !std::ranges::all_of(digits, is_digit)) return std::nullopt;
  return CodeWord{term.substr(0, letters), digits};
}

std::string code_match(const CodeWord& word, bool begins) {
  const std::string_view bare =
      word.digits.substr(std::min(word.digits.find_first_not_of('0'), word.digits.size() - 1));
  std::vector<std::string> forms = {fmt::format("{}{}", word.letter, word.digits)};
  for (const std::size_t width : {bare.size(), std::size_t{2}, std::size_t{4}}) {
    if (width < bare.size()) continue;
    std::string form = fmt::format("{}{}{}", word.letter, std::string(width - bare.size(), '0'), bare);
    if (std::ranges::find(forms, form) == forms.end()) forms.push_back(std::move(form));
  }
  std::string out;
  for (const std::string& form : forms)
    out += fmt::format("{}{}{}", out.empty() ? "" : " OR ", in_quotes(form), begins ? "*" : "");
  return forms.size() == 1 ? out : "(" + out + ")";
}

SearchTerm term_of(std::string_view typed) {
  const bool begins = typed.ends_with('*');
  while (typed.ends_with('*')) typed.remove_suffix(1);
  constexpr std::size_t kLeastBeginning = 2;  // with an asterisk
  constexpr std::size_t kLeastWord = 3;       // without
  SearchTerm term;
  for (const char c : typed) term.word += lower(c);
  const auto code = code_word(typed);
  if (code) {
    term.in_head = code_match(*code, begins || code->letter.empty());
    term.in_text = code_match(*code, begins && typed.size() >= kLeastBeginning && !code->letter.empty());
    return term;
  }
  const bool begins_in_text = typed.size() >= (begins ? kLeastBeginning : kLeastWord);
  term.in_head = in_quotes(typed) + "*";
  term.in_text = begins_in_text ? term.in_head : in_quotes(typed);
  return term;
}

// The next term; a phrase has its quotation marks taken off.
std::string_view next_term(std::string_view& words, bool& is_phrase) {
  words.remove_prefix(std::min(words.find_first_not_of(" \t\r\n"), words.size()));
  is_phrase = words.starts_with('"');
  if (is_phrase) words.remove_prefix(1);
  const std::size_t end = std::min(is_phrase ? words.find('"') : words.find_first_of(" \t\r\n\""), words.size());
  const std::string_view term = words.substr(0, end);
  words.remove_prefix(is_phrase ? std::min(end + 1, words.size()) : end);
  return term;
}

constexpr std::size_t kMostTerms = 16;
constexpr std::size_t kLongestTerm = 64;
constexpr std::size_t kLettersAFault = 4;

// Edits with exchanged neighbours counted as one (optimal string alignment).
std::size_t edits(std::string_view a, std::string_view b) {
  std::array<std::vector<std::size_t>, 3> rows;
  for (auto& row : rows) row.assign(b.size() + 1, 0);
  for (std::size_t j = 0; j <= b.size(); ++j) rows[1][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    rows[2][0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      rows[2][j] = std::min({rows[1][j] + 1, rows[2][j - 1] + 1, rows[1][j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        rows[2][j] = std::min(rows[2][j], rows[0][j - 2] + 1);
    }
    std::rotate(rows.begin(), rows.begin() + 1, rows.end());
  }
  return rows[1][b.size()];
}

}  // namespace

std::vector<SearchTerm> terms_of(std::string_view words) {
  std::vector<SearchTerm> terms;
  while (!words.empty() && terms.size() < kMostTerms) {
    bool is_phrase = false;
    const std::string_view typed = next_term(words, is_phrase).substr(0, kLongestTerm);
    if (!has_word(typed)) continue;
    if (is_phrase)
      terms.push_back({.word = {}, .in_head = in_quotes(typed), .in_text = in_quotes(typed)});
    else
      terms.push_back(term_of(typed));
  }
  return terms;
}

std::string match_of(const std::vector<SearchTerm>& terms, Reach reach) {
  std::string out;
  for (const SearchTerm& one : terms)
    out += fmt::format("{}{}", out.empty() ? "" : " AND ", reach == Reach::head ? one.in_head : one.in_text);
  return out;
}

std::vector<std::string> name_words(std::string_view text) {
  std::vector<std::string> words;
  bool in_word = false;
  for (const char c : text) {
    if (is_word(c)) {
      if (!in_word) words.emplace_back();
      words.back() += lower(c);
    }
    in_word = is_word(c);
  }
  return words;
}

bool may_have_a_fault(std::string_view word) {
  return word.size() >= kLettersAFault && word.size() <= kLongestTerm && std::ranges::none_of(word, is_digit);
}

std::string marked_word(std::string_view word) { return fmt::format("^^{}$", word); }

std::string pieces_of(std::string_view word) {
  const std::string marked = marked_word(word);
  std::string out;
  for (std::size_t i = 0; i + 3 <= marked.size(); ++i)
    out += fmt::format("{}{}", out.empty() ? "" : " OR ", in_quotes(std::string_view(marked).substr(i, 3)));
  return out;
}

bool is_near(std::string_view wanted, std::string_view word) {
  const std::size_t most = wanted.size() / kLettersAFault;
  if (word.size() + most < wanted.size()) return false;
  return edits(wanted, word) <= most ||
         (word.size() > wanted.size() && edits(wanted, word.substr(0, wanted.size())) <= most);
}

}  // namespace dripfeed::sqlite
