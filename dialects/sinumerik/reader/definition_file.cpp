// A definition file is read as a program; of it are taken the variables that it declares, and the macros, by the tokens
// of their blocks.
#include <memory>
#include <utility>

#include "dialects/sinumerik/sinumerik.h"
#include "dialects/sinumerik/tables/name_index.h"

namespace dripfeed::sinumerik {

namespace {

// DEFINE NAME AS text
void add_macro(const ir::Program& program, const ir::Statement& s, ir::SharedDefinitions& into) {
  const std::string_view text = program.source.text();
  std::string name;
  bool named = false;
  text::Span body;
  for (std::uint32_t t = s.tokens.first; t < s.tokens.last; ++t) {
    const ir::Token& token = program.tokens[t];
    if (token.kind == ir::TokenKind::comment || token.kind == ir::TokenKind::eob) break;
    if (token.kind == ir::TokenKind::white) continue;
    const std::string_view word = token.span.in(text);
    if (named) {
      body = body.empty() ? token.span : join(body, token.span);
    } else if (same_name(word, "AS")) {
      named = true;
    } else if (same_name(word, "DEFINE")) {
      name.clear();  // after a block number
    } else {
      name += UpperName(word).view();
    }
  }
  if (named && !name.empty()) into.macros.emplace(std::move(name), std::string(body.in(text)));
}

}  // namespace

std::vector<std::string> add_definitions(const text::Source& file, const ir::Control& control,
                                         ir::SharedDefinitions& into) {
  ir::Control with_others = control;
  with_others.shared = std::make_shared<const ir::SharedDefinitions>(into);
  const ir::Program program = read(file, with_others).program;
  for (const ir::Symbol& symbol : program.symbols) {
    if (symbol.span.empty() || symbol.is_parameter) continue;
    into.variables.emplace(std::string(program.strings.at(symbol.name)),
                           ir::SharedVariable{symbol.type, {symbol.dimension1, symbol.dimension2, symbol.dimension3}});
  }
  for (const ir::Statement& s : program.statements)
    if (s.kind == ir::StatementKind::native && program.strings.at(program.natives[s.payload].name) == "DEFINE")
      add_macro(program, s, into);
  std::vector<std::string> called;
  for (const ir::Statement& s : program.statements) {
    if (s.kind != ir::StatementKind::call) continue;
    const ir::Call& call = program.calls[s.payload];
    if (call.name != ir::StringId::none) called.emplace_back(program.strings.at(call.name));
  }
  return called;
}

}  // namespace dripfeed::sinumerik
