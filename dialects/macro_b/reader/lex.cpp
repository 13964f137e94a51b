// One pass over the bytes with a table of character classes. Nothing is allocated but the token vector, which is
// reserved by the length of the text.
#include "dialects/macro_b/reader/lex.h"

#include <array>
#include <cstdint>

#include "dialects/text/look_alike.h"
#include "dialects/text/source.h"

namespace dripfeed::macro_b {

namespace {

enum class Class : std::uint8_t {
  white,
  letter,
  digit,
  eob,
  percent,
  open_comment,
  slash,
  hash,
  less,
  symbol,
  invalid
};

constexpr std::array<Class, 256> make_classes() {
  std::array<Class, 256> classes{};
  classes.fill(Class::invalid);
  const auto set = [&](std::string_view characters, Class c) {
    for (const char character : characters) classes[static_cast<unsigned char>(character)] = c;
  };
  set("ABCDEFGHIJKLMNOPQRSTUVWXYZ", Class::letter);
  set("0123456789.", Class::digit);
  set("+-*[],=:&?@\"'>)", Class::symbol);
  set("\n\r;", Class::eob);
  set("%", Class::percent);
  set("(", Class::open_comment);
  set("/", Class::slash);
  set("#", Class::hash);
  set("<", Class::less);
  // NUL and DEL are leader, DC1..DC4 the puncher's and reader's own, ^Z ends a file of DOS: the control skips them as
  // it does blanks.
  set(" \t\x11\x12\x13\x14\x1A\x7F", Class::white);
  classes[0] = Class::white;
  return classes;
}
constexpr std::array<Class, 256> kClasses = make_classes();

Class class_of(char c) { return kClasses[static_cast<unsigned char>(c)]; }
bool ends_line(char c) { return c == '\n' || c == '\r'; }

class Lexer {
 public:
  Lexer(std::string_view text, const Grammar& grammar, std::vector<ir::Token>& tokens)
      : text_(text), keywords_(grammar.keywords), tokens_(tokens) {}

  void run() {
    tokens_.reserve(tokens_.size() + text_.size() / 3 + 16);
    while (at_ < text_.size()) step();
  }

 private:
  void step() {
    switch (class_of(text_[at_])) {
      case Class::white: return take(ir::TokenKind::white, while_class(at_ + 1, Class::white));
      case Class::letter: return letters();
      case Class::digit: return digits();
      case Class::eob: return end_of_block();
      case Class::percent: return take(ir::TokenKind::tape_mark, end_of_line(at_));
      case Class::open_comment: return comment();
      case Class::slash: return slash();
      case Class::hash: return hash();
      case Class::less: return program_name();
      case Class::symbol: return symbol();
      case Class::invalid: return invalid();
    }
  }

  void take(ir::TokenKind kind, std::size_t end) {
    tokens_.push_back({kind, {static_cast<std::uint32_t>(at_), static_cast<std::uint32_t>(end)}});
    at_ = end;
  }

  [[nodiscard]] std::size_t while_class(std::size_t i, Class c) const {
    while (i < text_.size() && class_of(text_[i]) == c) ++i;
    return i;
  }
  [[nodiscard]] std::size_t end_of_line(std::size_t i) const {
    while (i < text_.size() && !ends_line(text_[i])) ++i;
    return i;
  }

  void letters() {
    block_begins_ = block_begins_ && text_[at_] == 'N';
    if (at_ + 1 >= text_.size() || class_of(text_[at_ + 1]) != Class::letter) {
      return take(ir::TokenKind::address, at_ + 1);
    }
    const KeywordIndex::Match match = keywords_.match(text_.substr(at_));
    if (match.keyword == nullptr) return take(ir::TokenKind::address, at_ + 1);
    using enum KeywordRole;
    bracket_is_text_ |= match.keyword->role == set_name || match.keyword->spelling.ends_with("PRNT");
    take(ir::TokenKind::name, at_ + match.length);
  }

  void digits() { take(ir::TokenKind::number, while_class(at_ + 1, Class::digit)); }

  void end_of_block() {
    const std::uint32_t length = text::eob_length(text_, at_);
    take(ir::TokenKind::eob, at_ + (length == 0 ? 1 : length));  // ';' is no EOB of a line
    block_begins_ = true;
    bracket_is_text_ = false;
  }

  // To the first ')', or to the end of the line where there is none.
  void comment() {
    std::size_t end = at_ + 1;
    while (end < text_.size() && text_[end] != ')' && !ends_line(text_[end])) ++end;
    take(ir::TokenKind::comment, end < text_.size() && text_[end] == ')' ? end + 1 : end);
  }

  // Block skip stands before the words of a block, N excepted; everywhere else '/' divides.
  void slash() {
    if (!block_begins_) return take(ir::TokenKind::symbol, at_ + 1);
    const bool numbered = at_ + 1 < text_.size() && text_[at_ + 1] >= '1' && text_[at_ + 1] <= '9';
    take(ir::TokenKind::skip, at_ + (numbered ? 2 : 1));
  }

  void hash() {
    block_begins_ = false;
    take(ir::TokenKind::variable, at_ + 1);
    std::size_t end = at_;
    while (end < text_.size() && (class_of(text_[end]) == Class::letter || text_[end] == '_' ||
                                  (end > at_ && text_[end] >= '0' && text_[end] <= '9'))) {
      ++end;
    }
    if (end > at_) take(ir::TokenKind::name, end);
  }

  // <NAME>; a '<' that is not closed on its line is a character.
  void program_name() {
    block_begins_ = false;
    std::size_t end = at_ + 1;
    while (end < text_.size() && text_[end] != '>' && !ends_line(text_[end])) ++end;
    const bool closed = end < text_.size() && text_[end] == '>';
    take(closed ? ir::TokenKind::string : ir::TokenKind::symbol, closed ? end + 1 : at_ + 1);
  }

  void symbol() {
    block_begins_ = false;
    if (text_[at_] == '[' && bracket_is_text_) return bracketed_text();
    take(ir::TokenKind::symbol, at_ + 1);
  }

  void bracketed_text() {
    std::size_t end = at_;
    int depth = 0;
    while (end < text_.size() && !ends_line(text_[end])) {
      const char c = text_[end++];
      if (c == '[') ++depth;
      if (c == ']' && --depth == 0) break;
    }
    bracket_is_text_ = false;
    take(ir::TokenKind::string, end);
  }

  void invalid() {
    block_begins_ = false;
    take(ir::TokenKind::invalid, at_ + text::read_character(text_.substr(at_)).length);
  }

  std::string_view text_;
  KeywordIndex keywords_;
  std::vector<ir::Token>& tokens_;
  std::size_t at_ = 0;
  bool block_begins_ = true;
  bool bracket_is_text_ = false;  // after DPRNT, BPRNT, SETVN
};

}  // namespace

void lex(std::string_view text, const Grammar& grammar, std::vector<ir::Token>& tokens) {
  Lexer(text, grammar, tokens).run();
}

}  // namespace dripfeed::macro_b
