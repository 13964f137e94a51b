// Letters beyond ASCII are left out: the family language has none in names.
#include "dialects/compile/propose/proposed_names.h"

#include <algorithm>

#include <fmt/format.h>

#include "dialects/family/lexer.h"
#include "dialects/text/look_alike.h"

namespace dripfeed::compile {

namespace {

constexpr std::size_t kLongestName = 24;
constexpr std::size_t kLongestText = 80;
constexpr std::size_t kMostWords = 3;

bool is_letter(char c) { return c >= 'a' && c <= 'z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// The words of a text, of letters and digits alone, in lower case and joined; as many as find room.
std::string joined_words(std::string_view text, char joint) {
  std::string out;
  std::string word;
  std::size_t words = 0;
  const auto end_word = [&] {
    if (!word.empty() && words < kMostWords && out.size() + 1 + word.size() <= kLongestName) {
      if (!out.empty()) out += joint;
      out += word;
      ++words;
    } else if (!word.empty()) {
      words = kMostWords;
    }
    word.clear();
  };
  for (const char raw : text) {
    const char c = lower(raw);
    if (is_letter(c) || is_digit(c))
      word += c;
    else
      end_word();
  }
  end_word();
  return out;
}

std::string with_letter_first(std::string name, std::string_view prefix) {
  if (name.empty() || is_letter(name.front())) return name;
  return fmt::format("{}{}", prefix, name);
}

}  // namespace

std::string quoted_text(std::string_view text) {
  std::string out = "\"";
  while (!text.empty() && out.size() < kLongestText) {
    const text::Character character = text::read_character(text);
    const std::string_view bytes = text.substr(0, character.length);
    const bool lone = character.code_point >= 0xD800 && character.code_point < 0xE000;
    if (bytes == "\"")
      out += '\'';
    else if (lone)
      out += '?';
    else
      out += character.code_point < ' ' || character.code_point == 0x7F ? std::string_view(" ") : bytes;
    text.remove_prefix(std::min<std::size_t>(character.length, text.size()));
  }
  return out + "\"";
}

std::string proposed_family_name(std::string_view path) {
  if (const std::size_t slash = path.find_last_of("/\\"); slash != std::string_view::npos)
    path.remove_prefix(slash + 1);
  if (const std::size_t point = path.rfind('.'); point != std::string_view::npos && point != 0)
    path = path.substr(0, point);
  const std::string name = with_letter_first(joined_words(path, '-'), "program-");
  return name.empty() ? "wrapped-program" : name;
}

std::string ProposedNames::name_for(std::string_view text, std::string_view fallback) {
  std::string name = joined_words(text, '_');
  const bool has_word = std::ranges::count_if(name, is_letter) > 1;
  if (!has_word) name = joined_words(fallback, '_');
  name = with_letter_first(name, "v");
  if (name.empty()) name = "value";
  if (family::is_keyword(name)) name += "_value";
  std::string unique = name;
  for (int count = 2; !taken_.insert(unique).second; ++count) unique = fmt::format("{}_{}", name, count);
  return unique;
}

}  // namespace dripfeed::compile
