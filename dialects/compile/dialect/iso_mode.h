// SINUMERIK's other language, ISO mode (Function Manual ISO Dialects): the blocks between G291 and G290 and the
// programs that ISOCALL, M98 and G65 call there. They are read as Fanuc's, whose language it is but for Custom Macro B.
#pragma once

#include <string_view>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/ir/stage.h"
#include "dialects/text/diagnostic.h"
#include "dialects/text/source.h"

namespace dripfeed::compile {

bool has_iso_mode(const ir::Control& control);
// The control as it is in ISO mode: its codes are Fanuc's (of a mill, or a lathe by its G-code system), its axes and
// alarms its own.
ir::Control iso_control(const ir::Control& sinumerik);
// The ISO parts of `host`: statements and faults lie where they lie in its text. What is Custom Macro B is kept as
// written, since most versions do not execute it.
ir::ReadResult read_iso_parts(const ir::Program& host, const ir::Control& iso);
// A program that is called in ISO mode is in Siemens mode nevertheless when its first block is PROC (Function Manual
// ISO Dialects, "Macro programs").
bool begins_with_procedure(std::string_view text);

// SINUMERIK's reading and validating, ISO parts included.
ir::ReadResult read_sinumerik(const text::Source& source, const ir::Control& control);
std::vector<text::Diagnostic> validate_sinumerik(const ir::Program& program, const ir::Control& control,
                                                 ir::Delivery delivery);

}  // namespace dripfeed::compile
