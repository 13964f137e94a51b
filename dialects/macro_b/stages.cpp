// The eob after the last token saves the parser its bounds checks; it goes when all is read, so that the tokens tile
// the text.
#include "dialects/macro_b/stages.h"

#include "dialects/macro_b/reader/lex.h"
#include "dialects/macro_b/reader/parse.h"
#include "dialects/macro_b/validator/unread.h"
#include "dialects/macro_b/validator/validate.h"
#include "dialects/macro_b/writer/print.h"

namespace dripfeed::macro_b {

ir::ReadResult read(const text::Source& source, const ir::Control& control, const Grammar& grammar) {
  ir::ReadResult result;
  ir::Program& program = result.program;
  program.source = source;
  lex(source.text(), grammar, program.tokens);
  const auto end = static_cast<std::uint32_t>(source.text().size());
  program.tokens.push_back({ir::TokenKind::eob, {end, end}});
  Parser(program, control, grammar, result.diagnostics).run();
  program.tokens.pop_back();
  soften_unread(program, result.diagnostics);
  return result;
}

namespace {

void check_in_effect(const ir::Program& program, const ir::Control& control, const facts::Resolved& facts,
                     const Section& section, Findings& findings) {
  StatementCheck checks[] = {modes_check(program, control, facts, section, findings),
                             axes_check(program, control, facts, findings),
                             order_check(program, control, facts, section, findings),
                             measuring_check(program, control, facts, section, findings),
                             cycles_check(program, control, facts, section, findings)};
  for (std::uint32_t i = section.first; i < section.last; ++i)
    for (StatementCheck& each : checks) each(i);
}

}  // namespace

std::vector<text::Diagnostic> validate(const ir::Program& program, const ir::Control& control, ir::Delivery delivery,
                                       const Grammar& grammar) {
  Findings findings(control);
  const std::vector<Section> sections = sections_of(program);
  check_frame(program, control, sections, findings);
  check_variables(program, control, findings);
  check_words(program, control, findings);
  check_values(program, control, findings);
  const facts::Resolved facts(program, control);
  for (const Section& section : sections) {
    check_loops(program, control, section, findings);
    check_jumps(program, section, findings);
    check_in_effect(program, control, facts, section, findings);
  }
  if (!grammar.condition_blocks) check_condition_blocks(program, findings);
  if (delivery == ir::Delivery::drip) check_drip(program, control, grammar, findings);
  check_not_interpreted(program, control, findings);
  std::vector<text::Diagnostic> found = findings.take();
  soften_unread(program, found);
  return found;
}

ir::PrintResult print(const ir::Program& program, const ir::Control& control, const Grammar& grammar) {
  ProgramPrinter printer(program, control, grammar);
  printer.frame_line("%");
  printer.frame_line(program_head(program));
  printer.statements();
  printer.frame_line("%");
  return printer.take();
}

}  // namespace dripfeed::macro_b
