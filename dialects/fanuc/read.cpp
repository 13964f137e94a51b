// lex, parse and lower with Fanuc's grammar. The eob behind the last token saves the parser its bounds checks; it goes
// when all is read, so that the tokens tile the text.
#include "dialects/fanuc/fanuc.h"
#include "dialects/fanuc/tables.h"
#include "dialects/macro_b/lex.h"
#include "dialects/macro_b/parse.h"

namespace dripfeed::fanuc {

ir::ReadResult read(const text::Source& source, const ir::Control& control) {
  ir::ReadResult result;
  ir::Program& program = result.program;
  program.source = source;
  macro_b::lex(source.text(), grammar(), program.tokens);
  const auto end = static_cast<std::uint32_t>(source.text().size());
  program.tokens.push_back({ir::TokenKind::eob, {end, end}});
  macro_b::Parser(program, control, grammar(), result.diagnostics).run();
  program.tokens.pop_back();
  return result;
}

}  // namespace dripfeed::fanuc
