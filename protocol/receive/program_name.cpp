// One function a method of naming; the table is asked line by line, so that what stands first wins.
#include "protocol/receive/program_name.h"

#include <array>

namespace dripfeed::receive {
namespace {

constexpr std::string_view kDigits = "0123456789";
constexpr std::string_view kNameCharacters = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-.";
constexpr std::size_t kLongestComment = 32;

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

// The next line and the rest.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  const std::string_view line = trimmed(text.substr(0, end));
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line;
}

std::string_view leading(std::string_view text, std::string_view members) {
  return text.substr(0, text.find_first_not_of(members));
}

using Found = std::optional<std::string>;

Found okuma(std::string_view line) {
  if (!line.starts_with('$') || !line.ends_with('%')) return std::nullopt;
  const std::string_view name = line.substr(1, line.size() - 2);
  if (name.empty() || leading(name, kNameCharacters) != name) return std::nullopt;
  return std::string(name.substr(0, name.find('.')));
}

Found sinumerik(std::string_view line) {
  constexpr std::string_view kPrefix = "%_N_";
  if (!line.starts_with(kPrefix)) return std::nullopt;
  const std::string_view name = leading(line.substr(kPrefix.size()), kNameCharacters);
  if (name.empty()) return std::nullopt;
  return std::string(name);
}

Found fagor(std::string_view line) {
  if (!line.starts_with('%')) return std::nullopt;
  const std::size_t comma = line.find(',');
  if (comma == std::string_view::npos || line.substr(comma + 1, 1) != "M") return std::nullopt;
  const std::string_view name = trimmed(line.substr(1, comma - 1));
  if (name.empty()) return std::nullopt;
  return std::string(name);
}

Found heidenhain(std::string_view line) {
  constexpr std::string_view kBegin = "0 BEGIN PGM ";
  if (!line.starts_with(kBegin)) return std::nullopt;
  const std::string_view rest = line.substr(kBegin.size());
  const std::string_view name = rest.substr(0, rest.find(' '));
  if (name.empty()) return std::nullopt;
  return std::string(name);
}

Found header(std::string_view line) {
  if (!line.starts_with('%')) return std::nullopt;
  const std::string_view name = leading(line.substr(1), kNameCharacters);
  if (name.empty()) return std::nullopt;
  return std::string(name);
}

Found number(std::string_view line) {
  if (!line.starts_with('O') && !line.starts_with(':')) return std::nullopt;
  const std::string_view digits = leading(line.substr(1), kDigits);
  if (digits.empty() || digits.size() > 8) return std::nullopt;
  return "O" + std::string(digits);
}

Found angle(std::string_view line) {
  if (!line.starts_with('<')) return std::nullopt;
  const std::size_t end = line.find('>');
  if (end == std::string_view::npos || end < 2) return std::nullopt;
  return std::string(line.substr(1, end - 1));
}

struct NameRow {
  NameStyle style;
  std::string_view name;
  Found (*find)(std::string_view line);
};
constexpr std::array<NameRow, 7> kNames{{
    {NameStyle::okuma, "okuma", okuma},
    {NameStyle::sinumerik, "sinumerik", sinumerik},
    {NameStyle::fagor, "fagor", fagor},
    {NameStyle::heidenhain, "heidenhain", heidenhain},
    {NameStyle::header, "header", header},
    {NameStyle::number, "number", number},
    {NameStyle::angle, "angle", angle},
}};

// What begins a program inside a punch of several.
bool begins_program(std::string_view line) {
  return number(line).has_value() || (angle(line).has_value() && line.ends_with('>'));
}

std::string_view comment_in(std::string_view line) {
  const std::size_t open = line.find_first_of("(;");
  if (open == std::string_view::npos) return {};
  if (line[open] == ';') return trimmed(line.substr(open + 1));
  return trimmed(line.substr(open + 1, line.find(')', open) - open - 1));
}

// Nothing where something stands after a '%' that is not a program: it would be lost, or become a part of one.
std::vector<std::string> split_at_numbers(std::string_view text) {
  std::vector<std::string> programs;
  std::string before = "%\n";
  std::string_view rest = text;
  take_line(rest);  // the first '%'
  bool is_between = false;
  while (!rest.empty()) {
    const std::string_view raw = rest;
    const std::string_view line = take_line(rest);
    const std::string_view whole = raw.substr(0, raw.size() - rest.size());
    is_between = is_between || line == "%";
    if (is_between && (line.empty() || line == "%")) continue;
    const bool begins = begins_program(line);
    if (is_between && !begins) return {};
    is_between = false;
    if (begins) programs.emplace_back("%\n");
    (programs.empty() ? before : programs.back()) += whole;
  }
  // What stands before the first number belongs to the first program.
  if (!programs.empty() && before.size() > 2) programs.front().insert(2, before, 2);
  for (std::string& program : programs) program += "%\n";
  return programs;
}

std::vector<std::string> split_at_headers(std::string_view text) {
  std::vector<std::string> programs;
  while (!text.empty()) {
    const std::string_view raw = text;
    const std::string_view line = take_line(text);
    if (sinumerik(line) || programs.empty()) programs.emplace_back();
    programs.back() += raw.substr(0, raw.size() - text.size());
  }
  return programs;
}

}  // namespace

std::string_view name(NameStyle style) {
  return style == NameStyle::comment ? "comment" : kNames[static_cast<std::size_t>(style)].name;
}

std::string_view first_comment(std::string_view text, std::size_t lines) {
  for (std::size_t i = 0; i < lines && !text.empty(); ++i) {
    const std::string_view line = take_line(text);
    if (line.starts_with(";$PATH")) continue;
    if (const std::string_view found = comment_in(line); !found.empty()) return found;
  }
  return {};
}

std::optional<ProgramName> find_name(std::string_view text) {
  std::string_view rest = text;
  for (std::size_t i = 0; i < kNameLines && !rest.empty(); ++i) {
    const std::string_view line = take_line(rest);
    for (const NameRow& row : kNames) {
      auto found = row.find(line);
      if (!found) continue;
      ProgramName name{.style = row.style, .name = std::move(*found), .path = {}};
      constexpr std::string_view kPath = ";$PATH=";
      const std::string_view next = take_line(rest);
      if (row.style == NameStyle::sinumerik && next.starts_with(kPath)) name.path = next.substr(kPath.size());
      return name;
    }
  }
  const std::string_view comment = first_comment(text, kNameLines);
  if (comment.empty()) return std::nullopt;
  return ProgramName{.style = NameStyle::comment, .name = std::string(comment.substr(0, kLongestComment)), .path = {}};
}

std::vector<std::string> split_programs(std::string_view text) {
  std::vector<std::string> programs;
  if (text.starts_with("%\n")) programs = split_at_numbers(text);
  if (text.starts_with("%_N_")) programs = split_at_headers(text);
  if (programs.size() < 2) return {std::string(text)};
  return programs;
}

}  // namespace dripfeed::receive
