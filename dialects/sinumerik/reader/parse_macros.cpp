// Macros: DEFINE NAME AS text, of the program itself and of the definition files next to it. The text of the first kind
// has tokens, and is read in the place of the name; of the second, what codes and numbers it holds is taken, and
// everything else is reported as not known.
#include <algorithm>
#include <utility>

#include "dialects/sinumerik/reader/lex.h"
#include "dialects/sinumerik/reader/parse.h"
#include "dialects/sinumerik/tables/codes.h"
#include "dialects/sinumerik/tables/name_index.h"
#include "dialects/sinumerik/tables/system_variables.h"
#include "dialects/sinumerik/tables/whole_number.h"
#include "dialects/text/number.h"

namespace dripfeed::sinumerik {

namespace {

using ir::TokenKind;
using text::DiagnosticId;

// Diagnostics Manual, alarm 12280. Controls come with definition files of their own whose macros are longer: an error
// only where the block is too long, too.
constexpr std::uint32_t kLongestMacro_bytes = 256;
constexpr std::uint32_t kLongestBlock_bytes = 512;

std::string_view without_blanks(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") + 1 - begin);
}

// A code of a macro's text: G with its row, or M with its number.
struct MacroCode {
  const GCode* g = nullptr;
  std::uint32_t m = 0;
};

// Nothing where the text holds more than codes.
std::optional<std::vector<MacroCode>> codes_of_macro(std::string_view body) {
  std::vector<ir::Token> tokens;
  lex(body, tokens);
  std::vector<MacroCode> codes;
  TokenCursor cursor(body, tokens);
  for (cursor.skip_blanks(); !cursor.at_block_end(); cursor.advance()) {
    MacroCode code;
    if (cursor.kind() == TokenKind::name) {
      code.g = find_named_code(cursor.text());
      if (code.g == nullptr) return std::nullopt;
      codes.push_back(code);
      continue;
    }
    const char letter = to_upper(cursor.first());
    if (cursor.kind() != TokenKind::address || cursor.span().size() != 1 || (letter != 'G' && letter != 'M'))
      return std::nullopt;
    cursor.advance();
    const std::uint32_t number = cursor.kind() == TokenKind::number ? whole_number(cursor.text()) : kNoNumber;
    if (number == kNoNumber) return std::nullopt;
    if (letter == 'G') code.g = find_g_code(number);
    code.m = number;
    if (letter == 'G' && (code.g == nullptr || code.g->row.name == "G291")) return std::nullopt;
    codes.push_back(code);
  }
  return codes;
}

}  // namespace

// DEFINE NAME AS …: the rest of the block stands for the name from here on.
void Parser::macro_definition(text::Span head) {
  text::Span name = cursor_.span();
  cursor_.advance();
  // G306 is an address and a number to the lexer.
  while (!cursor_.at_block_end() && !cursor_.is_name("AS")) {
    name.end = cursor_.span().end;
    cursor_.advance();
  }
  if (!cursor_.take_name("AS")) return give_up(DiagnosticId::syntax_error, head, {"DEFINE has no AS"});
  const std::uint32_t first = cursor_.index();
  text::Span body = cursor_.span();
  skip_block();
  body.end = cursor_.previous_end();
  if (body.end > body.begin + kLongestMacro_bytes) {
    report(DiagnosticId::syntax_error, name,
           {"a macro of more than " + std::to_string(kLongestMacro_bytes) + " bytes"});
    if (!faulty_) diagnostics_.back().alarm = "12280";
    if (!faulty_ && body.end <= body.begin + kLongestBlock_bytes)
      diagnostics_.back().severity = text::Severity::warning;
  }
  std::string written(UpperName(name.in(cursor_.whole())).view());
  if (std::ranges::find(macros_, written, &Macro::name) != macros_.end()) {
    report(DiagnosticId::name_defined_twice, name, {written});
    if (!faulty_) diagnostics_.back().alarm = "12270";
  }
  macros_.push_back({std::move(written), {first, cursor_.index()}});
  lower_.keep_as_native("DEFINE", true, to_here(head));
}

// Reads the body of a macro in the place of its name. A macro inside of another is an error of the control (12250) and
// is not expanded.
bool Parser::expand_macro() {
  const bool has_shared = control_.shared != nullptr && !control_.shared->macros.empty();
  if (macros_.empty() && !has_shared) return false;
  text::Span name = cursor_.span();
  TokenCursor after = cursor_.after();
  const bool joined =
      cursor_.kind() == TokenKind::address && after.kind() == TokenKind::number && after.span().begin == name.end;
  if (joined) {
    name.end = after.span().end;
    after.advance();
  }
  const UpperName written(name.in(cursor_.whole()));
  const auto macro = std::ranges::find(macros_, written.view(), &Macro::name);
  if (macro == macros_.end()) return expand_shared_macro(written.view(), name, after);
  if (in_macro_) {
    report(DiagnosticId::syntax_error, name, {"a macro inside of a macro"});
    if (!faulty_) diagnostics_.back().alarm = "12250";
    return false;
  }
  if (after.is_symbol('=') || after.is_symbol('[')) {
    assign_macro(*macro, name, after);
    return true;
  }
  in_macro_ = true;
  cursor_.go_to(macro->body.first);
  while (cursor_.index() < macro->body.last && !cursor_.at_block_end()) {
    const std::uint32_t before = cursor_.index();
    statement();
    if (cursor_.index() == before) stray_symbol();
  }
  in_macro_ = false;
  cursor_.go_to(after.index());
  return true;
}

// NAME=…, of a macro that stands for a variable; with anything else in it, what the block does is not known.
void Parser::assign_macro(const Macro& macro, text::Span name, const TokenCursor& after) {
  const std::uint32_t last = macro.body.last;
  in_macro_ = true;
  cursor_.go_to(macro.body.first);
  const bool names_one =
      cursor_.kind() == TokenKind::variable || (cursor_.kind() == TokenKind::name && !find_keyword(cursor_.text()));
  const auto target = names_one ? std::optional(variable()) : std::nullopt;
  const bool whole = target && after.is_symbol('=') && (cursor_.index() >= last || cursor_.at_block_end());
  in_macro_ = false;
  cursor_.go_to(after.index());
  if (whole) return assignment(*target, name);
  skip_block();
  lower_.keep_as_native(UpperName(name.in(cursor_.whole())).view(), false, to_here(name), true);
}

// The codes of a macro of a definition file; with anything else in it, what the block does is not known.
bool Parser::expand_shared_macro(std::string_view name, text::Span span, const TokenCursor& after) {
  if (control_.shared == nullptr) return false;
  const auto macro = control_.shared->macros.find(name);
  if (macro == control_.shared->macros.end()) return false;
  cursor_.advance();
  cursor_.go_to(after.index());
  const auto codes = codes_of_macro(macro->second);
  if (!codes) {
    skip_block();
    lower_.keep_as_native(name, false, span, true);
    return true;
  }
  for (const MacroCode& code : *codes) {
    if (code.g != nullptr)
      lower_.add_code(*code.g, span);
    else
      lower_.add_m_code(code.m, 0, span);
  }
  return true;
}

// The value of a macro in an expression; nothing, and nothing read, where the name is none.
std::optional<ir::ExpressionId> Parser::macro_value() {
  if (in_macro_ || cursor_.kind() != TokenKind::name) return std::nullopt;
  const UpperName written(cursor_.text());
  const text::Span span = cursor_.span();
  const auto macro = std::ranges::find(macros_, written.view(), &Macro::name);
  if (macro == macros_.end()) {
    if (control_.shared == nullptr) return std::nullopt;
    const auto shared = control_.shared->macros.find(written.view());
    if (shared == control_.shared->macros.end()) return std::nullopt;
    cursor_.advance();
    return shared_macro_value(without_blanks(shared->second), span);
  }
  const std::uint32_t after = cursor_.after().index();
  cursor_.advance();
  in_macro_ = true;
  cursor_.go_to(macro->body.first);
  const ir::ExpressionId value = unary();
  const bool is_value = cursor_.index() >= macro->body.last || cursor_.at_block_end();
  in_macro_ = false;
  cursor_.go_to(after);
  return is_value ? value : shared_macro_value({}, span);
}

// A number; everything else is a value that is not known here.
ir::ExpressionId Parser::shared_macro_value(std::string_view body, text::Span span) {
  if (const auto number = text::parse_number(body)) return program_.add_constant(*number, span, true);
  return unknown_value(span);
}

// (A _DEC2): a name in the place of an operator, which only a macro can be ("MOD 100"); what follows belongs to it.
std::optional<ir::ExpressionId> Parser::macro_operator() {
  if (cursor_.kind() != TokenKind::name || find_keyword(cursor_.text()) != nullptr) return std::nullopt;
  const text::Span name = cursor_.span();
  const UpperName written(cursor_.text());
  const bool is_defined = std::ranges::find(macros_, written.view(), &Macro::name) != macros_.end() ||
                          (control_.shared != nullptr && control_.shared->macros.contains(written.view()));
  if (!is_defined) report(DiagnosticId::unknown_name, name, {std::string(cursor_.text())});
  for (int open = 0; !cursor_.at_block_end() && (open > 0 || !cursor_.is_symbol(')')); cursor_.advance())
    open += cursor_.is_symbol('(') ? 1 : cursor_.is_symbol(')') ? -1 : 0;
  return unknown_value(to_here(name));
}

ir::ExpressionId Parser::unknown_value(text::Span span) {
  ir::Variable value;
  value.bank = ir::Bank::system;
  value.number = find_system_variable("$");
  value.span = span;
  return program_.add_variable(value);
}

}  // namespace dripfeed::sinumerik
