// dialects/sinumerik: reader, checker and writer of SINUMERIK 840D sl part programs (also 810D and 840D powerline): the
// code, alarm, keyword and system variable tables and the rules that are Siemens' own. ISO mode is another
// language: where it stands is stated (ir::ForeignPart), what it says is not read here. What a program does when it
// runs is the interpreter's; nothing here knows a machine, a file or another dialect.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/plain_batch.h"
#include "dialects/ir/program.h"
#include "dialects/ir/stage.h"
#include "dialects/text/diagnostic.h"
#include "dialects/text/source.h"

namespace dripfeed::sinumerik {

// The usual control of that kind: tables, variable ranges, limits and semantics of the 840D sl.
ir::Control control(ir::MachineKind kind);

// The control that the text was most likely written for: mill or lathe, by the first line that only one of them would
// have (listed in infer.cpp). Control::because_line is that line, 0 for the default, a mill.
ir::Control infer_control(const text::Source& source);

// Lexes, parses and lowers. Never fails: what cannot be understood is a diagnostic and a Native statement. The tokens
// tile the text. Diagnostics are those of the syntax; the rest is validate's.
ir::ReadResult read(const text::Source& source, const ir::Control& control);

// What a definition file (GUD or macros) declares, added to what others did; sizes by macros of those before it count.
// The answer: the definition files that it calls, which a builder's file does for each option of the machine. They
// count where they exist, whatever condition (ISFILE) stands before the call.
std::vector<std::string> add_definitions(const text::Source& file, const ir::Control& control,
                                         ir::SharedDefinitions& into);

// Plain blocks of a text of that control, in batches. `control` must outlive it.
std::unique_ptr<ir::PlainScanner> plain_scanner(const ir::Control& control);

// What the control would alarm on, or what can be seen from the program to be wrong, in the order of the text; those of
// reading are not repeated.
std::vector<text::Diagnostic> validate(const ir::Program& program, const ir::Control& control, ir::Delivery delivery);

// Errors in blocks that no run comes to become warnings, with the reason: the control reads a block when a run comes to
// it. Structures that do not match are the whole program's.
void soften_unreached(const ir::Program& program, std::vector<text::Diagnostic>& diagnostics);

// The alarms of ISO mode, and what only it alarms on, in blocks that were read in its language for the control as it is
// there.
std::span<const ir::AlarmRow> iso_alarms();
std::vector<text::Diagnostic> validate_iso(const ir::Program& program, const ir::Control& control);

// Text of a standard cycle that the control brings along: CYCLE81 to CYCLE89, CYCLE97, HOLES1, HOLES2; empty for
// others. A program of that name that the caller has goes before it.
std::string_view standard_cycle(std::string_view name);

// Makes a program of the control `from`, or a built one, legal for the SINUMERIK control `to`: variables become R
// parameters or DEF names, codes are mapped by what they do, block numbers become labels. What cannot be written is the
// error of passes/refusal.h (cannot_translate, translation_…) with its place.
ir::RaiseResult raise(const ir::Program& program, const ir::Control& from, const ir::Control& to);

// Canonical text of a raised program: no head line (the file name is the program's), one block a line, LF, axis words
// always with a decimal point.
ir::PrintResult print(const ir::Program& program, const ir::Control& control);
// X12.5: the word of an axis with a computed position, as `print` writes it.
void append_position(std::string& out, ir::Address axis, double value, const ir::Control& control);

}  // namespace dripfeed::sinumerik
