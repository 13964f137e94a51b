// One pass over the bytes. A point belongs to a number only when no second one follows: "10..400" is a range.
#include "dialects/family/lexer.h"

#include <algorithm>
#include <array>

#include "dialects/family/native_text.h"
#include "dialects/text/source.h"

namespace dripfeed::family {

namespace {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

constexpr std::string_view kSymbols = "+-*/^()[]=<>,";
constexpr std::array<std::string_view, 4> kDoubles = {"..", "<=", ">=", "!="};
// A line that ends in one of these is not finished.
constexpr std::array<std::string_view, 7> kOpenEnds = {"+", "-", "*", "/", "^", "(", ","};

class Lexer {
 public:
  explicit Lexer(std::string_view text) : text_(text) {}

  std::vector<Lexeme> run() {
    while (at_ < text_.size()) step();
    if (out_.empty() || out_.back().kind != LexemeKind::end_of_line) add(LexemeKind::end_of_line, 0);
    return std::move(out_);
  }

 private:
  void step() {
    const char c = text_[at_];
    if (const std::uint32_t eob = text::eob_length(text_, at_); eob != 0) {
      end_line(eob);
    } else if (c == ' ' || c == '\t') {
      ++at_;
    } else if (const std::size_t target = follows_is() ? target_length(text_.substr(at_)) : 0; target != 0) {
      add(LexemeKind::word, target);
    } else if (c == '#') {
      at_ = line_end();
    } else if (is_letter(c)) {
      add(LexemeKind::word, word_length());
    } else if (is_digit(c)) {
      add(LexemeKind::number, number_length());
    } else if (c == '"') {
      string();
    } else {
      symbol();
    }
  }

  void end_line(std::uint32_t eob) {
    if (!goes_on()) add(LexemeKind::end_of_line, 0);
    at_ += eob;
    ++line_;
  }

  // What follows may be a place in a native program, where # is not a comment.
  [[nodiscard]] bool follows_is() const {
    return !out_.empty() && out_.back().kind == LexemeKind::word && out_.back().span.in(text_) == "is";
  }

  [[nodiscard]] bool goes_on() const {
    return !out_.empty() && out_.back().kind == LexemeKind::symbol &&
           std::ranges::find(kOpenEnds, out_.back().span.in(text_)) != kOpenEnds.end();
  }

  void string() {
    const std::size_t close = text_.substr(0, line_end()).find('"', at_ + 1);
    if (close == std::string_view::npos) {
      add(LexemeKind::invalid, line_end() - at_);
    } else {
      add(LexemeKind::string, close + 1 - at_);
    }
  }

  void symbol() {
    const std::string_view two = text_.substr(at_, 2);
    if (std::ranges::find(kDoubles, two) != kDoubles.end()) {
      add(LexemeKind::symbol, 2);
    } else if (kSymbols.contains(text_[at_])) {
      add(LexemeKind::symbol, 1);
    } else {
      add(LexemeKind::invalid,
          std::max<std::size_t>(1, run_of([](char d) { return static_cast<signed char>(d) < 0; })));
    }
  }

  // A point and a letter may follow: an axis of a list of points, "corners.x".
  [[nodiscard]] std::size_t word_length() const {
    const std::size_t name = run_of([](char d) { return is_letter(d) || is_digit(d); });
    const std::string_view rest = text_.substr(at_ + name);
    const bool has_axis = rest.size() > 1 && rest[0] == '.' && rest[1] >= 'x' && rest[1] <= 'z' &&
                          (rest.size() == 2 || !(is_letter(rest[2]) || is_digit(rest[2])));
    return has_axis ? name + 2 : name;
  }

  [[nodiscard]] std::size_t number_length() const {
    std::size_t end = at_;
    while (end < text_.size() && is_digit(text_[end])) ++end;
    if (end < text_.size() && text_[end] == '.' && !text_.substr(end).starts_with("..")) {
      ++end;
      while (end < text_.size() && is_digit(text_[end])) ++end;
    }
    return end - at_;
  }

  template <class Belongs>
  [[nodiscard]] std::size_t run_of(Belongs belongs) const {
    std::size_t end = at_;
    while (end < text_.size() && belongs(text_[end])) ++end;
    return end - at_;
  }

  [[nodiscard]] std::size_t line_end() const { return std::min(text_.find_first_of("\r\n", at_), text_.size()); }

  void add(LexemeKind kind, std::size_t length) {
    const auto begin = static_cast<std::uint32_t>(at_);
    out_.push_back({kind, {begin, begin + static_cast<std::uint32_t>(length)}, line_});
    at_ += length;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::uint32_t line_ = 1;
  std::vector<Lexeme> out_;
};

constexpr auto kKeywords = [] {
  auto words = std::to_array<std::string_view>({
      // declarations
      "family",
      "machine",
      "lathe",
      "mill",
      "is",
      "diameter",
      "radius",
      "param",
      "length",
      "angle",
      "feed",
      "speed",
      "time",
      "count",
      "ratio",
      "in",
      "let",
      "const",
      "list",
      "of",
      "choice",
      "yes_no",
      "group",
      "function",
      "sub",
      "call",
      "set",
      "while",
      "require",
      "stock",
      "cylinder",
      "box",
      "bore",
      "nominal",
      "for",
      "tolerance",
      "program",
      "native",
      "plane",
      "chamfer",
      "rounding",
      "by",
      "end",
      // steps
      "work",
      "offset",
      "tool",
      "nose",
      "tip",
      "spindle",
      "limit",
      "cw",
      "ccw",
      "off",
      "coolant",
      "compensate",
      "left",
      "right",
      "flood",
      "mist",
      "rapid",
      "cut",
      "arc",
      "center",
      "retract",
      "then",
      "profile",
      "from",
      "down",
      "to",
      "step",
      "if",
      "else",
      "message",
      "dwell",
      "stop",
      "optional",
      // axes
      "x",
      "y",
      "z",
      "a",
      "b",
      "c",
      "i",
      "j",
      "k",
      "u",
      "v",
      "w",
      // expressions
      "and",
      "or",
      "not",
      "pi",
      "sin",
      "cos",
      "tan",
      "asin",
      "acos",
      "atan",
      "atan2",
      "sqrt",
      "abs",
      "max",
      "round",
      "trunc",
      "ln",
      "exp",
      "radians",
      // units; min is a function as well
      "mm",
      "deg",
      "rad",
      "s",
      "ms",
      "min",
      "rpm",
      "rev",
      "m",
      "ft",
  });
  std::ranges::sort(words);
  return words;
}();

}  // namespace

std::vector<Lexeme> lex(std::string_view text) { return Lexer(text).run(); }

bool is_keyword(std::string_view word) { return std::ranges::binary_search(kKeywords, word); }

}  // namespace dripfeed::family
