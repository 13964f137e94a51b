// One comment a line.
#include "server/app/receive/answers.h"

#include <algorithm>

#include <fmt/format.h>

#include "protocol/tape_code/character_set.h"

namespace dripfeed::app {

namespace {

constexpr std::size_t kUsualBlock = 64;  // every control takes so many characters
constexpr std::size_t kLinesAtMost = 200;

bool is_sinumerik(const machine::Profile& profile) { return profile.control.dialect.starts_with("sinumerik"); }

// Capitals, because the oldest readers take no others; no sign that ends a comment, a block or the reading.
std::string legal(const machine::Profile& profile, std::string_view text) {
  const tape_code::CharacterSet set = machine::characters_of(profile.line);
  std::string out;
  for (const char c : text) {
    const char upper = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    const bool sign = upper == '(' || upper == ')' || upper == '%' || upper == ';' || upper == '\n' || upper == '\t';
    const bool taken = set.has(static_cast<std::uint8_t>(upper));
    out += sign || !taken || static_cast<std::uint8_t>(upper) < 0x20 ? '.' : upper;
  }
  return out;
}

// Pieces of at most `room` characters, cut at spaces where there is one.
std::vector<std::string> wrapped(std::string text, std::size_t room) {
  std::vector<std::string> pieces;
  while (text.size() > room) {
    const std::size_t space = text.rfind(' ', room);
    const std::size_t cut = space == std::string::npos || space == 0 ? room : space;
    pieces.push_back(text.substr(0, cut));
    text.erase(0, text[cut] == ' ' ? cut + 1 : cut);
  }
  pieces.push_back(std::move(text));
  return pieces;
}

}  // namespace

std::uint32_t answer_number_of(const machine::ReceiveSettings& receive) {
  return receive.answer_number != 0 ? receive.answer_number : receive.request_number;
}

std::string answer_program(const machine::Profile& profile, const std::vector<std::string>& lines) {
  const bool sinumerik = is_sinumerik(profile);
  const std::string number = fmt::format("O{:04}", answer_number_of(profile.line.receive));
  const std::size_t block =
      std::min<std::size_t>(profile.control.block_length_bytes.value_or(kUsualBlock), kUsualBlock);
  const std::size_t room = std::max<std::size_t>(block, 16) - number.size() - 3;
  std::vector<std::string> comments;
  for (const std::string& line : lines) {
    for (std::string& piece : wrapped(legal(profile, line), room)) {
      if (comments.size() < kLinesAtMost) comments.push_back(std::move(piece));
    }
  }
  std::string text = sinumerik ? "%_N_DRIPFEED_MPF\n;$PATH=/_N_MPF_DIR\n" : "%\n" + number;
  for (const std::string& comment : comments) text += sinumerik ? ";" + comment + "\n" : "(" + comment + ")\n";
  return text + (sinumerik ? "M30\n" : "M30\n%\n");
}

feed::ProgramSyntax answer_syntax(const machine::Profile& profile) {
  if (!is_sinumerik(profile)) return feed::kParenthesesSyntax;
  feed::ProgramSyntax syntax = feed::kSemicolonSyntax;
  syntax.final_percent = false;
  return syntax;
}

}  // namespace dripfeed::app
