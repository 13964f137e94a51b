// One walk over the tokens of the declaration.
#include "dialects/sinumerik/reader/declared_programs.h"

#include <string_view>
#include <utility>

#include "dialects/sinumerik/tables/name_index.h"

namespace dripfeed::sinumerik {

using ir::TokenKind;

std::optional<DeclaredProgram> declared_program(const ir::Program& program, const ir::Statement& s) {
  DeclaredProgram declared;
  bool open = false;
  DeclaredParameter parameter;
  bool any = false;
  bool bracket = false;  // [10,5] of an array, or the length of a STRING
  for (std::uint32_t t = s.tokens.first; t < s.tokens.last; ++t) {
    const ir::Token& token = program.tokens[t];
    const std::string_view text = token.span.in(program.source.text());
    if (token.kind == TokenKind::comment || token.kind == TokenKind::eob) break;
    if (token.kind == TokenKind::symbol && text == "(") open = true;
    if (text == "[" || text == "]") bracket = text == "[";
    if (text == "[" || (bracket && text == ",")) ++parameter.dimensions;
    if (bracket) continue;
    if (token.kind == TokenKind::symbol && open && (text == "," || text == ")")) {
      if (any) declared.parameters.push_back(parameter);
      parameter = {};
      any = false;
      if (text == ")") return declared;
    }
    if (token.kind != TokenKind::name) continue;
    if (!open && !same_name(text, "EXTERN")) declared.name = UpperName(text).view();
    if (!open) continue;
    any = true;
    parameter.by_reference = parameter.by_reference || same_name(text, "VAR");
    parameter.is_string = parameter.is_string || same_name(text, "STRING");
    parameter.is_axis = parameter.is_axis || same_name(text, "AXIS");
  }
  return std::nullopt;
}

}  // namespace dripfeed::sinumerik
