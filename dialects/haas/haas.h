// dialects/haas: reader, checker and writer of Haas NGC controls (mills and lathes). Tables, limits and the few words
// that a Haas reads otherwise than its relatives are its own; the language is macro_b's.
#pragma once

#include <memory>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/plain_batch.h"
#include "dialects/ir/program.h"
#include "dialects/ir/stage.h"
#include "dialects/text/diagnostic.h"
#include "dialects/text/source.h"

namespace dripfeed::haas {

// The usual control of that kind. A Haas lathe has one list of codes, which is G-code system A's; `system` is not
// asked.
ir::Control control(ir::MachineKind kind, ir::GSystem system);

// The control that the text was most likely written for, by macro_b's rules.
ir::Control infer_control(const text::Source& source);

// As macro_b/stages.h.
ir::ReadResult read(const text::Source& source, const ir::Control& control);
std::unique_ptr<ir::PlainScanner> plain_scanner(const ir::Control& control);
std::vector<text::Diagnostic> validate(const ir::Program& program, const ir::Control& control, ir::Delivery delivery);
// Makes a program of the control `from`, or a built one, legal for the control `to`.
ir::RaiseResult raise(const ir::Program& program, const ir::Control& from, const ir::Control& to);
ir::PrintResult print(const ir::Program& program, const ir::Control& control);

}  // namespace dripfeed::haas
