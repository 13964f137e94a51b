// One row a control. Sources: Fanuc data server and memory card (O and four or eight digits, or a name of at most 32
// characters); SINUMERIK 840D sl programming manual, names of programs (24 characters, the first two letters or
// underscores, type suffix); Mazak and Mitsubishi: names of at most 32 characters.
#include "server/machine/file_drop.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace dripfeed::machine {

namespace {

struct NameRule {
  std::string_view dialect;
  std::string_view extension;  // added where the name has none
  std::size_t most;            // characters without the extension
  std::string_view others;     // allowed besides letters and digits
  bool letters_first;          // two letters or underscores begin it
};
constexpr std::array kRules = {
    NameRule{"fanuc", "", 32, "_-+.", false},          NameRule{"haas", ".NC", 32, "_-+.", false},
    NameRule{"mazak", ".EIA", 32, "_-+.", false},      NameRule{"mitsubishi-m80", "", 32, "_-+.", false},
    NameRule{"sinumerik-840d", ".MPF", 24, "_", true},
};

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::expected<void, std::string> obeys(std::string_view stem, const NameRule& rule) {
  if (stem.empty()) return std::unexpected(std::string("the program has no name"));
  if (stem.front() == '.') return std::unexpected(fmt::format("the name \"{}\" begins with a point", stem));
  if (stem.size() > rule.most)
    return std::unexpected(fmt::format("the name \"{}\" has more than {} characters", stem, rule.most));
  for (const char c : stem) {
    if (is_letter(c) || is_digit(c) || rule.others.find(c) != std::string_view::npos) continue;
    return std::unexpected(
        fmt::format("the name \"{}\" has a character that the control does not take: \"{}\"", stem, c));
  }
  if (rule.letters_first && (stem.size() < 2 || !is_letter(stem[0]) || !is_letter(stem[1])))
    return std::unexpected(fmt::format("the name \"{}\" does not begin with two letters", stem));
  return {};
}

// Where the next line begins.
std::size_t after_line(std::string_view text, std::size_t at) {
  at = text.find_first_of("\r\n", at);
  if (at == std::string_view::npos) return text.size();
  return at + (text.substr(at).starts_with("\r\n") ? 2 : 1);
}

bool is_eob(char c) { return c == '\r' || c == '\n'; }

}  // namespace

bool drops_bare_files(const Profile& profile) {
  return profile.line.link.kind == LinkKind::dir && profile.control.dialect.starts_with("sinumerik");
}

std::size_t archive_head(std::string_view beginning) {
  if (!beginning.starts_with('%')) return 0;
  std::size_t at = after_line(beginning, 0);
  if (beginning.substr(at).starts_with(";$PATH=")) at = after_line(beginning, at);
  return at;
}

std::size_t archive_tail(std::string_view end) {
  std::size_t at = end.size();
  while (at > 0 && (is_eob(end[at - 1]) || end[at - 1] == ' ')) --at;
  const bool alone = at > 0 && end[at - 1] == '%' && (at == 1 || is_eob(end[at - 2]));
  return alone ? end.size() - at + 1 : 0;
}

std::string_view file_part(std::string_view text) {
  const std::size_t head = archive_head(text);
  const std::size_t tail = archive_tail(text);
  return head + tail >= text.size() ? std::string_view() : text.substr(head, text.size() - head - tail);
}

std::expected<std::string, std::string> file_name_for(const Profile& profile, std::string_view program) {
  const auto* rule = std::ranges::find(kRules, profile.control.dialect, &NameRule::dialect);
  if (rule == kRules.end()) rule = kRules.begin();
  std::string name(program);
  std::string extension(rule->extension);
  if (const auto given = profile.line.link.options.find("ext"); given != profile.line.link.options.end())
    extension = given->second == "none" ? "" : "." + given->second;
  // SINUMERIK's inner names carry their type after an underscore: _N_SHAFT_MPF is SHAFT.MPF outside.
  if (rule->letters_first) {
    if (name.starts_with("_N_")) name.erase(0, 3);
    for (const std::string_view type : {"_MPF", "_SPF"}) {
      if (!name.ends_with(type)) continue;
      name.resize(name.size() - type.size());
      extension = fmt::format(".{}", type.substr(1));
    }
  }
  const std::size_t point = rule->extension.empty() ? std::string::npos : name.rfind('.');
  if (point != std::string::npos) {
    extension = name.substr(point);
    name.resize(point);
  }
  std::ranges::transform(name, name.begin(), upper);
  std::ranges::transform(extension, extension.begin(), upper);
  if (const auto obeyed = obeys(name, *rule); !obeyed) return std::unexpected(obeyed.error());
  return name + extension;
}

}  // namespace dripfeed::machine
