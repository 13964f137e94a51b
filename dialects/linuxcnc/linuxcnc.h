// dialects/linuxcnc: reader of LinuxCNC's language (rs274ngc with o-words and named parameters), as far as running a
// program needs it. Codes and variables are tables; words become IR as macro_b's do. There is no writer: programs are
// neither translated to this language nor from it.
#pragma once

#include <memory>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/plain_batch.h"
#include "dialects/ir/program.h"
#include "dialects/ir/stage.h"
#include "dialects/text/diagnostic.h"
#include "dialects/text/source.h"

namespace dripfeed::linuxcnc {

// A mill of all nine axes in millimetres, as the stand-alone interpreter is; lathes have the same list of codes.
ir::Control control(ir::MachineKind kind, ir::GSystem system);
ir::Control infer_control(const text::Source& source);

// Never fails; tokens tile the text. Subprograms of the text become sections after the main program, wherever they
// stand.
ir::ReadResult read(const text::Source& source, const ir::Control& control);
// Leaves every block to the reader.
std::unique_ptr<ir::PlainScanner> plain_scanner(const ir::Control& control);
std::vector<text::Diagnostic> validate(const ir::Program& program, const ir::Control& control, ir::Delivery delivery);

}  // namespace dripfeed::linuxcnc
