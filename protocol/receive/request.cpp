// The verbs are a table. Spaces are dropped before anything is compared, as operators type them where they like.
#include "protocol/receive/request.h"

#include <algorithm>
#include <array>

#include "protocol/receive/program_name.h"

namespace dripfeed::receive {
namespace {

constexpr std::size_t kLongestArgument = 32;

struct VerbRow {
  std::string_view word;
  Verb verb;
  bool takes;           // an argument
  bool needs;           // one
  bool counts = false;  // and it is a number: with other words it is any program's comment, "PARTS FOR VALVES"
};
constexpr std::array<VerbRow, 12> kVerbs{{
    {"LOAD", Verb::load, true, true},
    {"PRG=", Verb::load, true, true},
    {"GET", Verb::load, true, true},
    {"DNC", Verb::drip, true, true},
    {"DRIP", Verb::drip, true, true},
    {"DIR", Verb::dir, true, false},
    {"SAVE", Verb::save, true, false},
    {"CANCEL", Verb::cancel, false, false},
    {"STATUS", Verb::status, false, false},
    {"RESTART", Verb::restart, true, true},
    {"PARTS", Verb::parts, true, true, true},
    {"SCRAP", Verb::scrap, true, true, true},
}};
constexpr std::array<std::string_view, 9> kVerbNames{"load",   "drip",    "dir",   "save", "cancel",
                                                     "status", "restart", "parts", "scrap"};

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

std::string without_spaces(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c != ' ' && c != '\t') out += upper(c);
  }
  return out;
}

bool is_number(std::string_view argument) {
  return !argument.empty() && std::ranges::all_of(argument, [](char c) { return c >= '0' && c <= '9'; });
}

bool legal(std::string_view argument, Verb verb) {
  if (argument.size() > kLongestArgument || argument.find("..") != std::string_view::npos) return false;
  for (const char c : argument) {
    const bool plain = (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.' || c == '-';
    const bool wild = verb == Verb::dir && (c == '*' || c == '?');
    if (!plain && !wild) return false;
  }
  return true;
}

// O9999, O09999 and :9999 are one number.
bool has_number(std::string_view name, std::uint32_t wanted) {
  std::uint64_t number = 0;
  bool digits = false;
  for (const char c : name) {
    if (c < '0' || c > '9') {
      if (digits) return false;
      continue;
    }
    digits = true;
    number = number * 10 + static_cast<std::uint64_t>(c - '0');
  }
  return digits && number == wanted;
}

bool is_for_us(std::string_view text, const RequestGrammar& grammar) {
  if (grammar.program_number == 0 && grammar.marker.empty()) return true;
  const auto own = find_name(text);
  if (!own || own->style == NameStyle::comment) return false;
  if (!grammar.marker.empty())
    return without_spaces(own->name).find(without_spaces(grammar.marker)) != std::string::npos;
  std::string_view name = own->name;
  // A control with names calls it 9999_MPF or MPF9999.
  for (const std::string_view suffix : {"_MPF", "_SPF"}) {
    if (name.ends_with(suffix)) name.remove_suffix(suffix.size());
  }
  return has_number(name, grammar.program_number);
}

}  // namespace

std::string_view name(Verb verb) { return kVerbNames[static_cast<std::size_t>(verb)]; }

std::optional<Request> find_request(std::string_view text, const RequestGrammar& grammar) {
  if (!is_for_us(text, grammar)) return std::nullopt;
  const std::string_view comment = first_comment(text, grammar.scan_lines);
  const std::string words = without_spaces(comment);
  for (const VerbRow& row : kVerbs) {
    if (!words.starts_with(row.word)) continue;
    std::string_view argument = std::string_view(words).substr(row.word.size());
    while (argument.starts_with('=') || argument.starts_with(':')) argument.remove_prefix(1);
    if (!row.takes && !argument.empty()) continue;
    if (row.counts && !is_number(argument)) continue;
    return Request{.verb = row.verb,
                   .argument = std::string(argument),
                   .legal = legal(argument, row.verb) && (!row.needs || !argument.empty()),
                   .as_written = std::string(comment)};
  }
  return std::nullopt;
}

// The usual two-pointer match: after a '*' the rest is tried from each place on.
bool fits_mask(std::string_view name, std::string_view mask) {
  std::size_t at = 0;
  std::size_t m = 0;
  std::size_t star = std::string_view::npos;
  std::size_t retry = 0;
  while (at < name.size()) {
    if (m < mask.size() && mask[m] == '*') {
      star = m++;
      retry = at;
    } else if (m < mask.size() && (mask[m] == '?' || upper(mask[m]) == upper(name[at]))) {
      ++m;
      ++at;
    } else if (star != std::string_view::npos) {
      m = star + 1;
      at = ++retry;
    } else {
      return false;
    }
  }
  while (m < mask.size() && mask[m] == '*') ++m;
  return m == mask.size();
}

}  // namespace dripfeed::receive
