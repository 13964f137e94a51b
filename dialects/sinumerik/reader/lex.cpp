// One pass over the bytes, one table look-up a token to find its kind. A letter followed by a digit is an address with
// a number, because names begin with two letters or an underscore; that is what lets "G0G90X=R24Y=R25" be read without
// a blank.
#include "dialects/sinumerik/reader/lex.h"

#include <array>
#include <cstdint>

#include "dialects/sinumerik/tables/name_index.h"
#include "dialects/text/source.h"

namespace dripfeed::sinumerik {

namespace {

using ir::TokenKind;

enum class ByteClass : std::uint8_t { white, eob, letter, underscore, digit, point, quote, symbol, invalid };

constexpr std::array<ByteClass, 256> make_classes() {
  std::array<ByteClass, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const char c = static_cast<char>(i);
    table[i] = i < 0x20 || i == 0x7F || c == ' ' ? ByteClass::white
               : is_letter(c)                    ? ByteClass::letter
               : is_digit(c)                     ? ByteClass::digit
                                                 : ByteClass::invalid;
  }
  const auto set = [&table](std::string_view bytes, ByteClass value) {
    for (const char c : bytes) table[static_cast<unsigned char>(c)] = value;
  };
  set("&", ByteClass::white);
  set("\r\n", ByteClass::eob);
  set("_", ByteClass::underscore);
  set(".", ByteClass::point);
  set("\"", ByteClass::quote);
  set("()[]<>:=/*+-,'?!%;$", ByteClass::symbol);
  return table;
}
constexpr std::array<ByteClass, 256> kClasses = make_classes();

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

class Lexer {
 public:
  Lexer(std::string_view text, std::vector<ir::Token>& tokens) : text_(text), tokens_(tokens) {}

  void run() {
    if (text_.starts_with(kByteOrderMark)) push(TokenKind::white, kByteOrderMark.size());
    while (at_ < text_.size()) next();
  }

 private:
  [[nodiscard]] ByteClass class_at(std::size_t i) const {
    return i < text_.size() ? kClasses[static_cast<unsigned char>(text_[i])] : ByteClass::eob;
  }
  [[nodiscard]] char byte_at(std::size_t i) const { return i < text_.size() ? text_[i] : '\0'; }
  [[nodiscard]] bool digit_at(std::size_t i) const { return i < text_.size() && is_digit(text_[i]); }

  void push(TokenKind kind, std::size_t length) {
    tokens_.push_back({kind, {static_cast<std::uint32_t>(at_), static_cast<std::uint32_t>(at_ + length)}});
    at_ += length;
    if (kind == TokenKind::eob) {
      block_start_ = true;
    } else if (kind != TokenKind::white) {
      block_start_ = false;
    }
  }

  void next() {
    switch (class_at(at_)) {
      case ByteClass::white: push(TokenKind::white, run_of(ByteClass::white)); return;
      case ByteClass::eob: push(TokenKind::eob, text::eob_length(text_, at_)); return;
      case ByteClass::letter:
      case ByteClass::underscore: word(); return;
      case ByteClass::digit: push(TokenKind::number, number_length(at_)); return;
      case ByteClass::point:
        if (digit_at(at_ + 1)) {
          push(TokenKind::number, number_length(at_));
        } else {
          push(TokenKind::symbol, 1);
        }
        return;
      case ByteClass::quote: quoted(); return;
      case ByteClass::symbol: symbol(); return;
      case ByteClass::invalid: push(TokenKind::invalid, run_of(ByteClass::invalid)); return;
    }
  }

  [[nodiscard]] std::size_t run_of(ByteClass wanted) const {
    std::size_t i = at_ + 1;
    while (i < text_.size() && class_at(i) == wanted) ++i;
    return i - at_;
  }

  [[nodiscard]] std::size_t to_line_end() const {
    const std::size_t end = text_.find_first_of("\r\n", at_);
    return (end == std::string_view::npos ? text_.size() : end) - at_;
  }

  // Digits with at most one point, then EX with its exponent.
  [[nodiscard]] std::size_t number_length(std::size_t start) const {
    std::size_t i = start;
    while (digit_at(i)) ++i;
    if (byte_at(i) == '.') {
      ++i;
      while (digit_at(i)) ++i;
    }
    if (to_upper(byte_at(i)) == 'E' && to_upper(byte_at(i + 1)) == 'X') {
      const bool sign = byte_at(i + 2) == '-' || byte_at(i + 2) == '+';
      std::size_t digits = i + 2 + (sign ? 1U : 0U);
      if (digit_at(digits)) {
        while (digit_at(digits)) ++digits;
        i = digits;
      }
    }
    return i - start;
  }

  void word() {
    const bool letter = class_at(at_) == ByteClass::letter;
    if (letter && !is_name_character(byte_at(at_ + 1))) {
      push(to_upper(text_[at_]) == 'R' ? TokenKind::variable : TokenKind::address, 1);
    } else if (letter && digit_at(at_ + 1) && !is_name_with_underscore()) {
      address_with_digits();
    } else {
      std::size_t i = at_ + 1;
      while (i < text_.size() && is_name_character(text_[i])) ++i;
      push(TokenKind::name, i - at_);
    }
  }

  // G1_FAST: by the manual names begin with two letters, but no word goes on with an underscore.
  [[nodiscard]] bool is_name_with_underscore() const {
    std::size_t i = at_ + 1;
    while (digit_at(i)) ++i;
    return byte_at(i) == '_';
  }

  // X10 is an address and a number, R10 a variable, X1=5 an address with an extension, $AA_IW[X1] an axis name.
  void address_with_digits() {
    std::size_t digits_end = at_ + 1;
    while (digit_at(digits_end)) ++digits_end;
    if (to_upper(text_[at_]) == 'R') {
      push(TokenKind::variable, digits_end - at_);
      return;
    }
    const bool extended = belongs_to_address(digits_end);
    push(TokenKind::address, extended ? digits_end - at_ : 1);
    if (!extended) push(TokenKind::number, number_length(at_));
  }

  // Whether what follows digits makes them a part of the address. N, G and L take no extension.
  [[nodiscard]] bool belongs_to_address(std::size_t after) const {
    const char address = to_upper(text_[at_]);
    if (address == 'N' || address == 'G' || address == 'L') return false;
    const char c = byte_at(after);
    if (c == ']' || c == ',' || c == ')') return true;
    std::size_t i = after;
    while (byte_at(i) == ' ' || byte_at(i) == '\t') ++i;
    return byte_at(i) == '=' && byte_at(i + 1) != '=';
  }

  void quoted() {
    const std::size_t end = text_.find_first_of("\"\r\n", at_ + 1);
    if (end == std::string_view::npos) {
      push(TokenKind::string, text_.size() - at_);
    } else {
      push(TokenKind::string, end - at_ + (text_[end] == '"' ? 1 : 0));
    }
  }

  void symbol() {
    const char c = text_[at_];
    const char after = byte_at(at_ + 1);
    if (c == ';') return push(TokenKind::comment, to_line_end());
    if (c == '%' && block_start_) return push(TokenKind::tape_mark, to_line_end());
    if (c == '$') return system_name();
    if (c == '\'') return based_number();
    if (c == '/' && block_start_) {
      std::size_t i = at_ + 1;
      while (digit_at(i)) ++i;
      return push(TokenKind::skip, i - at_);
    }
    const bool pair =
        (after == '=' && (c == '=' || c == '<' || c == '>')) || (c == '<' && (after == '<' || after == '>'));
    push(TokenKind::symbol, pair ? 2 : 1);
  }

  void system_name() {
    std::size_t i = at_ + 1;
    if (byte_at(i) == '$') ++i;
    const std::size_t name = i;
    while (i < text_.size() && is_name_character(text_[i])) ++i;
    push(i == name ? TokenKind::invalid : TokenKind::variable, i - at_);
  }

  // 'H0FF', 'B1010', 'D10': a number in apostrophes.
  void based_number() {
    std::size_t i = at_ + 1;
    while (i < text_.size() && is_name_character(text_[i])) ++i;
    const bool closed = byte_at(i) == '\'' && i > at_ + 2;
    push(closed ? TokenKind::number : TokenKind::symbol, closed ? i + 1 - at_ : 1);
  }

  std::string_view text_;
  std::vector<ir::Token>& tokens_;
  std::size_t at_ = 0;
  bool block_start_ = true;  // nothing but blanks since the end of the block before
};

}  // namespace

void lex(std::string_view text, std::vector<ir::Token>& tokens) {
  // A plain block has about one token to three bytes, a commented one fewer.
  tokens.reserve(tokens.size() + text.size() / 3 + 16);
  Lexer(text, tokens).run();
}

}  // namespace dripfeed::sinumerik
