// A name counts where a line begins with it.
#include "server/app/shop/program_pieces.h"

#include <algorithm>
#include <utility>

#include "dialects/text/source.h"

namespace dripfeed::app {

namespace {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string without_zeros(std::string_view digits) {
  return std::string(digits.substr(std::min(digits.find_first_not_of('0'), digits.size() - 1)));
}

// "" for a line that begins no program.
std::string name_in_head(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t%"), line.size()));
  if (line.empty()) return {};
  const bool lettered = line.front() == 'O' || line.front() == ':';
  if (lettered) line.remove_prefix(1);
  if (!line.empty() && line.front() == '<') {
    const std::size_t end = line.find('>');
    return end == std::string_view::npos ? std::string() : std::string(line.substr(1, end - 1));
  }
  const auto digits_end = std::ranges::find_if_not(line, is_digit);
  const auto count = static_cast<std::size_t>(digits_end - line.begin());
  return lettered && count > 0 ? "O" + without_zeros(line.substr(0, count)) : std::string();
}

}  // namespace

std::vector<ProgramPiece> pieces_of(std::string_view text) {
  std::vector<ProgramPiece> pieces;
  ProgramPiece piece;
  std::size_t begin = 0;
  std::size_t lines = 0;
  const auto keep = [&](std::size_t end) {
    piece.text = text.substr(begin, end - begin);
    if (!piece.name.empty()) pieces.push_back(std::move(piece));
  };
  for (std::size_t at = 0; at < text.size(); ++lines) {
    const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
    if (std::string here = name_in_head(text.substr(at, end - at)); !here.empty()) {
      keep(at);
      piece = {.name = std::move(here), .text = {}, .lines_before = lines};
      begin = at;
    }
    at = end == text.size() ? end : end + text::eob_length(text, end);
  }
  keep(text.size());
  return pieces;
}

std::string number_name(std::string_view name) {
  const bool is_number = name.size() > 1 && name.front() == 'O' && std::ranges::all_of(name.substr(1), is_digit);
  return is_number ? "O" + without_zeros(name.substr(1)) : std::string(name);
}

}  // namespace dripfeed::app
