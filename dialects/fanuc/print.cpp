// The frame of a Fanuc program: % and O number before it, % behind it.
#include "dialects/macro_b/print.h"

#include "dialects/fanuc/fanuc.h"
#include "dialects/fanuc/tables.h"

namespace dripfeed::fanuc {

ir::PrintResult print(const ir::Program& program, const ir::Control& control) {
  macro_b::ProgramPrinter printer(program, control, grammar());
  printer.frame_line("%");
  printer.frame_line(macro_b::program_head(program.name));
  printer.statements();
  printer.frame_line("%");
  return printer.take();
}

}  // namespace dripfeed::fanuc
