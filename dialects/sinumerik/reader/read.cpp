// lex -> parse -> lower, and the partners of structures.
#include <algorithm>
#include <tuple>

#include "dialects/sinumerik/reader/data_file.h"
#include "dialects/sinumerik/reader/lex.h"
#include "dialects/sinumerik/reader/one_per_name.h"
#include "dialects/sinumerik/reader/parse.h"
#include "dialects/sinumerik/sinumerik.h"

namespace dripfeed::sinumerik {

namespace {

// The arenas of a plain program grow to about these sizes; growing them once is what makes reading fast.
void reserve_arenas(ir::Program& program) {
  const std::size_t lines = program.source.line_count();
  const std::size_t words = program.tokens.size() / 3;
  program.statements.reserve(lines + 16);
  program.blocks.reserve(lines);
  program.words.reserve(words);
  program.expressions.reserve(words);
}

// "path/SHAFT.MPF" -> SHAFT
std::string name_of_file(std::string_view name) {
  if (const std::size_t slash = name.find_last_of("/\\"); slash != std::string_view::npos)
    name.remove_prefix(slash + 1);
  if (const std::size_t dot = name.rfind('.'); dot != std::string_view::npos) name = name.substr(0, dot);
  return std::string(UpperName(name).view());
}

}  // namespace

ir::ReadResult read(const text::Source& source, const ir::Control& control) {
  ir::ReadResult result;
  ir::Program& program = result.program;
  program.source = source;
  program.name = name_of_file(source.name());
  lex(source.text(), program.tokens);
  program.is_data = is_data_file(program);
  reserve_arenas(program);
  Parser(program, control, result.diagnostics).run();
  (void)ir::match_structures(program);  // what has no partner is validate's to report
  keep_one_per_name(program, result.diagnostics);
  std::ranges::sort(result.diagnostics, {},
                    [](const text::Diagnostic& d) { return std::tuple(d.span.begin, d.id, d.span.end); });
  return result;
}

}  // namespace dripfeed::sinumerik
