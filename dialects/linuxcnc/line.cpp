// Tokens are for those who show the text: parsing reads the line.
#include "dialects/linuxcnc/line.h"

#include "dialects/text/source.h"

namespace dripfeed::linuxcnc {

namespace {

using ir::TokenKind;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\0' || c == '\x1A'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_number(char c) { return (c >= '0' && c <= '9') || c == '.'; }
char small(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// The end of the run of characters from `at` that are alike.
template <class Alike>
std::size_t run_end(std::string_view line, std::size_t at, Alike alike) {
  while (at < line.size() && alike(line[at])) ++at;
  return at;
}

struct Piece {
  TokenKind kind;
  std::size_t end;
};

Piece piece_at(std::string_view line, std::size_t at) {
  const char c = line[at];
  const auto through = [&](char closing) {
    const std::size_t found = line.find(closing, at);
    return found == std::string_view::npos ? line.size() : found + 1;
  };
  if (is_blank(c)) return {TokenKind::white, run_end(line, at, is_blank)};
  if (c == '(') return {TokenKind::comment, through(')')};
  if (c == ';') return {TokenKind::comment, line.size()};
  if (c == '%') return {TokenKind::tape_mark, line.size()};
  if (c == '#') return {TokenKind::variable, at + 1};
  if (c == '<') return {TokenKind::name, through('>')};
  if (is_number(c)) return {TokenKind::number, run_end(line, at, is_number)};
  const std::size_t letters = run_end(line, at, is_letter);
  if (letters > at) return {letters == at + 1 ? TokenKind::address : TokenKind::name, letters};
  return {static_cast<unsigned char>(c) < 0x80 ? TokenKind::symbol : TokenKind::invalid, at + 1};
}

}  // namespace

std::uint32_t read_line(std::string_view text, std::uint32_t at, Line& line, std::vector<ir::Token>& tokens) {
  line = {};
  const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
  const std::string_view whole = text.substr(at, end - at);
  for (std::size_t i = 0; i < whole.size();) {
    const Piece piece = piece_at(whole, i);
    const text::Span span = {at + static_cast<std::uint32_t>(i), at + static_cast<std::uint32_t>(piece.end)};
    tokens.push_back({piece.kind, span});
    if (piece.kind == TokenKind::comment) line.comments.push_back(span);
    line.is_tape_mark = line.is_tape_mark || (piece.kind == TokenKind::tape_mark && line.text.empty());
    const bool counts = piece.kind != TokenKind::comment && piece.kind != TokenKind::tape_mark;
    for (; i < piece.end; ++i) {
      if (!counts || is_blank(whole[i])) continue;
      line.text += small(whole[i]);
      line.offsets.push_back(at + static_cast<std::uint32_t>(i));
    }
  }
  const auto line_end = static_cast<std::uint32_t>(end);
  line.offsets.push_back(line_end);
  const std::uint32_t length = text::eob_length(text, end);
  if (length > 0) tokens.push_back({TokenKind::eob, {line_end, line_end + length}});
  return line_end + length;
}

}  // namespace dripfeed::linuxcnc
