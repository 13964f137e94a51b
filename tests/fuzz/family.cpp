// Reading any bytes as a part family; where they are one, binding its defaults and rendering it for every dialect.
#include "dialects/compile/render/render.h"
#include "dialects/family/lexer.h"
#include "dialects/family/read.h"
#include "tests/fuzz/program_checks.h"

using namespace dripfeed;

namespace {

void require_lexemes(std::string_view text) {
  std::uint32_t end = 0;
  std::uint32_t line = 1;
  const std::vector<family::Lexeme> lexemes = family::lex(text);
  for (const family::Lexeme& lexeme : lexemes) {
    fuzz::require(lexeme.span.begin >= end && lexeme.span.end >= lexeme.span.begin && lexeme.span.end <= text.size(),
                  "lexemes are in order and in the text");
    fuzz::require(lexeme.line >= line, "lexemes are in the order of lines");
    end = lexeme.span.end;
    line = lexeme.line;
  }
  fuzz::require(!lexemes.empty() && lexemes.back().kind == family::LexemeKind::end_of_line,
                "the last lexeme ends a line");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const text::Source source("input", std::string(fuzz::text_of(data, size)));
  require_lexemes(source.text());
  const family::ReadFamilyResult read = family::read_family(source);
  fuzz::require_places(read.diagnostics, source);
  if (text::has_error(read.diagnostics)) return 0;
  const compile::FamilyGeometry bound = compile::family_geometry(source, {});
  fuzz::require_places(bound.diagnostics, source);
  if (text::has_error(bound.diagnostics)) return 0;
  for (const compile::Dialect& dialect : compile::dialects()) {
    const ir::Control control = dialect.control(read.family.machine, ir::GSystem::a);
    compile::RenderRequest request;
    request.family = source;
    request.target = control;
    request.mode = compile::RenderMode::macro;
    const compile::RenderResult rendered = compile::render(request);
    fuzz::require_places(rendered.diagnostics, source);
    if (text::has_error(rendered.diagnostics)) continue;
    if (read.family.native) continue;  // as right or wrong as it was
    const text::Source printed("rendered", rendered.text);
    const ir::ReadResult again = dialect.read(printed, control);
    fuzz::require_whole(again.program, printed);
    fuzz::require(!text::has_error(again.diagnostics), "a rendered family has no fault of syntax");
  }
  return 0;
}
