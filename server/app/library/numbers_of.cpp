// By the tokens of the dialect's own reader.
#include "server/app/library/numbers_of.h"

#include <algorithm>
#include <cmath>

#include "dialects/text/number.h"
#include "dialects/text/upper_case.h"

namespace dripfeed::app {

namespace {

using ir::TokenKind;

bool counts(TokenKind kind) {
  return kind != TokenKind::white && kind != TokenKind::comment && kind != TokenKind::tape_mark;
}

// After these a sign is an operator; anywhere else it belongs to the number that follows.
bool is_operand(TokenKind kind, std::string_view text) {
  return kind == TokenKind::number || kind == TokenKind::variable || kind == TokenKind::name || text == "]" ||
         text == ")";
}

// A block of O and a number alone: the program's own.
bool is_program_number(const NumbersOf& of, std::size_t first) {
  return of.words.size() == first + 2 && of.words[first] == "O" && of.words.back() == "0";
}

}  // namespace

NumbersOf numbers_of(std::string_view text, const compile::Dialect& dialect, const ir::Control& control) {
  const text::Source source("program", std::string(text));
  const ir::Program program = dialect.read(source, control).program;
  NumbersOf out;
  std::size_t block = 0;  // where its words begin
  TokenKind before = TokenKind::eob;
  std::string_view before_text;
  double sign = 1.0;
  for (const ir::Token& token : program.tokens) {
    if (!counts(token.kind)) continue;
    const std::string_view word = token.span.in(program.source.text());
    const std::uint32_t line = program.source.position(token.span.begin).line;
    if (token.kind == TokenKind::eob) {
      if (is_program_number(out, block)) {
        out.words.resize(block);
        out.word_lines.resize(block);
        out.numbers.pop_back();
      }
      if (out.words.size() > block) {
        out.words.emplace_back("\n");
        out.word_lines.push_back(line);
      }
      block = out.words.size();
    } else if (token.kind == TokenKind::number) {
      out.numbers.push_back({.value = sign * text::parse_number(word).value_or(0.0), .line = line});
      out.words.emplace_back("0");
      out.word_lines.push_back(line);
      sign = 1.0;
    } else if ((word == "-" || word == "+") && !is_operand(before, before_text)) {
      sign = word == "-" ? -sign : sign;
    } else {
      out.words.push_back(text::upper_case(word));
      out.word_lines.push_back(line);
      sign = 1.0;
    }
    before = token.kind;
    before_text = word;
  }
  return out;
}

std::optional<std::uint32_t> first_other_word(const NumbersOf& expected, const NumbersOf& found) {
  const auto [one, other] = std::ranges::mismatch(expected.words, found.words);
  if (one == expected.words.end() && other == found.words.end()) return std::nullopt;
  if (found.word_lines.empty()) return 1;
  const auto at = static_cast<std::size_t>(other - found.words.begin());
  return found.word_lines[std::min(at, found.word_lines.size() - 1)];
}

std::vector<std::size_t> other_numbers(const NumbersOf& expected, const NumbersOf& found) {
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < std::min(expected.numbers.size(), found.numbers.size()); ++i)
    if (std::abs(expected.numbers[i].value - found.numbers[i].value) > kSameNumber) others.push_back(i);
  return others;
}

}  // namespace dripfeed::app
