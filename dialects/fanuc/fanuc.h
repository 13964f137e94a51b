// dialects/fanuc: reader, checker and writer of Fanuc Custom Macro B as on 0i, 16i and 30i: the code and variable
// tables, the alarms, and the rules that are Fanuc's own. What the '#'-variable controls share is macro_b's; what a
// program does when it runs is the interpreter's; nothing here knows a machine, a file or another dialect.
#pragma once

#include <memory>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/plain_batch.h"
#include "dialects/ir/program.h"
#include "dialects/ir/stage.h"
#include "dialects/text/diagnostic.h"
#include "dialects/text/source.h"

namespace dripfeed::fanuc {

// The usual control of that kind: tables, variable ranges, limits and semantics of the 0i-F/30i generation. `system` is
// the G-code system of lathes (parameter 3401) and is ignored for mills.
ir::Control control(ir::MachineKind kind, ir::GSystem system);

// The control that the text was most likely written for: mill or lathe and its G-code system, by the first line that
// only one of them would have (listed in infer.cpp). Control::because_line is that line, 0 for the default, a mill.
ir::Control infer_control(const text::Source& source);

// Lexes, parses and lowers. Never fails: what cannot be understood is a diagnostic and a Native statement. The tokens
// tile the text. Diagnostics are those of the syntax; the rest is validate's.
ir::ReadResult read(const text::Source& source, const ir::Control& control);

// Plain blocks of a text of that control, in batches. `control` must outlive it.
std::unique_ptr<ir::PlainScanner> plain_scanner(const ir::Control& control);

// What the control would alarm on, or what can be seen from the program to be wrong, in the order of the text.
std::vector<text::Diagnostic> validate(const ir::Program& program, const ir::Control& control, ir::Delivery delivery);

// Makes a program of the control `from`, or a built one, legal for the Fanuc control `to`: variables numbered,
// structures that Fanuc lacks turned into jumps, codes mapped by what they do. What cannot be said is the error
// cannot_translate with its place.
ir::RaiseResult raise(const ir::Program& program, const ir::Control& from, const ir::Control& to);

// Canonical text of a raised program: '%', O number, one block a line, LF, axis words always with a decimal point.
ir::PrintResult print(const ir::Program& program, const ir::Control& control);

}  // namespace dripfeed::fanuc
