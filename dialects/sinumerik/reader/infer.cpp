// Mill or lathe, by the first line that has what only one of them would have:
//   lathe: DIAMON, DIAM90, LIMS=, G96, G961, G18, a turning cycle (CYCLE93 to 99, 930, 940, 95x), a blank "CYLINDER";
//   mill:  a Y word, G17, G19, CYCLE800, POCKETn, SLOTn, HOLESn, CYCLE61 to 79, a blank "BOX".
// Without any it is a mill. The axes are those of the kind and every further letter that the text moves.
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "dialects/ir/axis_letters.h"
#include "dialects/sinumerik/reader/lex.h"
#include "dialects/sinumerik/sinumerik.h"
#include "dialects/sinumerik/tables/name_index.h"

namespace dripfeed::sinumerik {

namespace {

using ir::TokenKind;

enum class Sign : std::uint8_t { nothing, lathe, mill };

struct NameSign {
  std::string_view name;
  Sign sign;
};
constexpr NameSign kNames[] = {
    {"DIAMON", Sign::lathe},   {"DIAM90", Sign::lathe},   {"LIMS", Sign::lathe},     {"CYCLE93", Sign::lathe},
    {"CYCLE94", Sign::lathe},  {"CYCLE95", Sign::lathe},  {"CYCLE96", Sign::lathe},  {"CYCLE97", Sign::lathe},
    {"CYCLE98", Sign::lathe},  {"CYCLE99", Sign::lathe},  {"CYCLE930", Sign::lathe}, {"CYCLE940", Sign::lathe},
    {"CYCLE950", Sign::lathe}, {"CYCLE951", Sign::lathe}, {"CYCLE952", Sign::lathe}, {"\"CYLINDER\"", Sign::lathe},
    {"CYCLE800", Sign::mill},  {"POCKET1", Sign::mill},   {"POCKET2", Sign::mill},   {"POCKET3", Sign::mill},
    {"POCKET4", Sign::mill},   {"SLOT1", Sign::mill},     {"SLOT2", Sign::mill},     {"HOLES1", Sign::mill},
    {"HOLES2", Sign::mill},    {"CYCLE61", Sign::mill},   {"CYCLE62", Sign::mill},   {"CYCLE63", Sign::mill},
    {"CYCLE64", Sign::mill},   {"CYCLE71", Sign::mill},   {"CYCLE72", Sign::mill},   {"CYCLE76", Sign::mill},
    {"CYCLE77", Sign::mill},   {"CYCLE79", Sign::mill},   {"\"BOX\"", Sign::mill},
};

struct CodeSign {
  std::string_view number;
  Sign sign;
};
constexpr CodeSign kCodes[] = {
    {"96", Sign::lathe}, {"961", Sign::lathe}, {"18", Sign::lathe}, {"17", Sign::mill}, {"19", Sign::mill},
};

// Bytes that are lexed at once: the tokens of a long program are looked at and forgotten.
constexpr std::size_t kPiece = 65'536;

class Inference {
 public:
  void run(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = at + kPiece < text.size() ? text.find('\n', at + kPiece) : std::string_view::npos;
      text_ = text.substr(at, end == std::string_view::npos ? text.size() - at : end + 1 - at);
      base_ = static_cast<std::uint32_t>(at);
      tokens_.clear();
      lex(text_, tokens_);
      piece();
      at += text_.size();
    }
  }

  [[nodiscard]] Sign sign() const { return sign_; }
  [[nodiscard]] std::uint32_t offset() const { return offset_; }
  [[nodiscard]] bool moves(char letter) const { return letters_.find(letter) != std::string::npos; }

 private:
  void piece() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const ir::Token& token = tokens_[i];
      if (token.kind == TokenKind::eob) in_definition_ = false;
      if (token.kind == TokenKind::name && is_definition(token.span.in(text_))) in_definition_ = true;
      if (token.kind == TokenKind::address) address(i);
      if (sign_ == Sign::nothing && (token.kind == TokenKind::name || token.kind == TokenKind::string))
        decide(sign_of_name(token.span.in(text_)), i);
    }
  }

  static bool is_definition(std::string_view name) { return same_name(name, "DEF") || same_name(name, "PROC"); }

  // V and A1 are names where the program defines them, axes elsewhere.
  void address(std::size_t i) {
    if (!in_definition_ && defined_.empty()) {
      if (tokens_[i].span.size() == 1) letter(i);
      return;
    }
    const std::uint32_t begin = tokens_[i].span.begin;
    std::uint32_t end = begin;
    while (end < text_.size() && is_name_character(text_[end])) ++end;
    const UpperName name(text_.substr(begin, end - begin));
    const bool known = std::ranges::find(defined_, name.view()) != defined_.end();
    if (in_definition_ && !known) defined_.emplace_back(name.view());
    if (!in_definition_ && !known && tokens_[i].span.size() == 1) letter(i);
  }

  // A letter is a word when a value follows: a number with or without sign, or '='.
  [[nodiscard]] std::size_t after(std::size_t i) const {
    ++i;
    while (i < tokens_.size() && tokens_[i].kind == TokenKind::white) ++i;
    return i;
  }

  void letter(std::size_t i) {
    const char letter = to_upper(text_[tokens_[i].span.begin]);
    const std::size_t next = after(i);
    if (next >= tokens_.size()) return;
    const std::string_view value = tokens_[next].span.in(text_);
    if (letter == 'G' && sign_ == Sign::nothing) {
      const auto row = std::ranges::find(kCodes, value, &CodeSign::number);
      if (row != std::end(kCodes)) decide(row->sign, i);
    }
    const bool has_value = tokens_[next].kind == TokenKind::number || value == "=" || value == "-" || value == "+";
    if (!has_value || std::string_view("YABCUVW").find(letter) == std::string_view::npos) return;
    if (!moves(letter)) letters_ += letter;
    if (letter == 'Y' && sign_ == Sign::nothing) decide(Sign::mill, i);
  }

  static Sign sign_of_name(std::string_view name) {
    const auto row = std::ranges::find_if(kNames, [name](const NameSign& n) { return same_name(n.name, name); });
    return row == std::end(kNames) ? Sign::nothing : row->sign;
  }

  void decide(Sign sign, std::size_t token) {
    sign_ = sign;
    if (sign != Sign::nothing) offset_ = base_ + tokens_[token].span.begin;
  }

  std::string_view text_;   // of the piece
  std::uint32_t base_ = 0;  // where it begins
  std::vector<ir::Token> tokens_;
  Sign sign_ = Sign::nothing;
  std::uint32_t offset_ = 0;
  std::string letters_;
  bool in_definition_ = false;
  std::vector<std::string> defined_;  // names that begin as an address does
};

}  // namespace

ir::Control infer_control(const text::Source& source) {
  Inference inference;
  inference.run(source.text());
  ir::Control result = control(inference.sign() == Sign::lathe ? ir::MachineKind::lathe : ir::MachineKind::mill);
  if (inference.sign() != Sign::nothing) result.because_line = source.position(inference.offset()).line;
  std::string axes;
  for (const char letter : ir::kAxisLetters)
    if (result.axes.find(letter) != std::string::npos || inference.moves(letter)) axes += letter;
  result.axes = axes;
  return result;
}

}  // namespace dripfeed::sinumerik
