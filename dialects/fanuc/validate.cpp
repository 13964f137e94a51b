// Which checks a Fanuc control needs. Spans are in the text that the program was read from.
#include "dialects/fanuc/fanuc.h"
#include "dialects/macro_b/check.h"

namespace dripfeed::fanuc {

std::vector<text::Diagnostic> validate(const ir::Program& program, const ir::Control& control, ir::Delivery delivery) {
  macro_b::Findings findings(control);
  const std::vector<macro_b::Section> sections = macro_b::sections_of(program);
  macro_b::check_frame(program, control, sections, findings);
  macro_b::check_variables(program, control, findings);
  macro_b::check_words(program, control, findings);
  for (const macro_b::Section& section : sections) {
    macro_b::check_loops(program, control, section, findings);
    macro_b::check_jumps(program, section, findings);
    macro_b::check_modes(program, control, section, findings);
  }
  if (delivery == ir::Delivery::drip) macro_b::check_drip(program, findings);
  macro_b::check_not_interpreted(program, control, findings);
  return findings.take();
}

}  // namespace dripfeed::fanuc
