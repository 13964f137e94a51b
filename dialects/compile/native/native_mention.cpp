// By its letters alone: what stands before and after it says whether it is the name, and whether it is set.
#include "dialects/compile/native/native_mention.h"

#include <algorithm>
#include <optional>
#include <string>

#include "dialects/text/number.h"
#include "dialects/text/upper_case.h"

namespace dripfeed::compile {

namespace {

bool is_in_name(char c) { return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || c == '_'; }

// "R10": 'R' and 10.
std::optional<std::int64_t> number_of(std::string_view target) {
  if (target.front() != '#' && target.front() != 'R') return std::nullopt;
  return text::parse_integer(target.substr(1));
}

// Of the '[' at `open`; the text's end where none closes it.
std::size_t closing_bracket(std::string_view text, std::size_t open) {
  int depth = 0;
  for (std::size_t at = open; at < text.size(); ++at) {
    if (text[at] == '[') ++depth;
    if (text[at] == ']' && --depth == 0) return at;
  }
  return text.size();
}

// After the name when it stands at `at`.
std::optional<std::size_t> end_of_name(std::string_view text, std::size_t at, std::string_view target) {
  if (text.substr(at).starts_with(target)) {
    const std::size_t end = at + target.size();
    return end < text.size() && is_in_name(text[end]) ? std::nullopt : std::optional(end);
  }
  const std::optional<std::int64_t> number = number_of(target);
  if (!number || text[at] != target.front() || !text.substr(at + 1).starts_with('[')) return std::nullopt;
  const std::size_t close = closing_bracket(text, at + 1);
  if (close == text.size()) return std::nullopt;
  const auto written = text::parse_integer(text.substr(at + 2, close - at - 2));
  if (written && *written != *number) return std::nullopt;
  return close + 1;
}

bool is_set_after(std::string_view text, std::size_t end) {
  end = text.find_first_not_of(" \t", end);
  return end != std::string_view::npos && text[end] == '=' && !text.substr(end).starts_with("==");
}

}  // namespace

Mention mention_of(std::string_view text, std::string_view target) {
  const std::string upper = text::upper_case(text);
  Mention found = Mention::none;
  for (std::size_t at = 0; at < upper.size(); ++at) {
    if (at > 0 && target.front() != '#' && is_in_name(upper[at - 1])) continue;
    const auto end = end_of_name(upper, at, target);
    if (!end) continue;
    if (is_set_after(upper, *end)) return Mention::sets;
    found = Mention::reads;
  }
  return found;
}

// The first argument of each: VAR INT, whether it went well (PGA, "Read lines in the file", "Write file", "Delete
// file", "Read out file information", "Process DataShare"). What else they give back are texts.
bool is_given_back(std::string_view text, std::string_view target) {
  constexpr std::string_view kProcedures[] = {"READ",     "WRITE",    "DELETE",   "EXTOPEN",  "EXTCLOSE",
                                              "FILEDATE", "FILETIME", "FILESIZE", "FILESTAT", "FILEINFO"};
  const std::string upper = text::upper_case(text);
  const auto after_blanks = [&upper](std::size_t at) {
    return std::min(upper.find_first_not_of(" \t", at), upper.size());
  };
  for (const std::string_view name : kProcedures) {
    for (std::size_t at = upper.find(name); at != std::string::npos; at = upper.find(name, at + 1)) {
      const std::size_t open = after_blanks(at + name.size());
      if ((at > 0 && is_in_name(upper[at - 1])) || open == upper.size() || upper[open] != '(') continue;
      const std::size_t argument = after_blanks(open + 1);
      if (argument == upper.size()) continue;
      const auto end = end_of_name(upper, argument, target);
      const std::size_t next = end ? after_blanks(*end) : upper.size();
      if (next < upper.size() && (upper[next] == ',' || upper[next] == ')')) return true;
    }
  }
  return false;
}

}  // namespace dripfeed::compile
