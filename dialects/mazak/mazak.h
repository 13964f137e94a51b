// dialects/mazak: reader, checker and writer of Mazak EIA/ISO, the text programs of Matrix and Smooth controls
// (machining centers VCN, VTC, HCN; lathes QT, QTN; Integrex). Only tables and limits are its own; the language is
// macro_b's, since the control is of the Mitsubishi family. MAZATROL programs are binary and unknown here.
#pragma once

#include <memory>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/plain_batch.h"
#include "dialects/ir/program.h"
#include "dialects/ir/stage.h"
#include "dialects/text/diagnostic.h"
#include "dialects/text/source.h"

namespace dripfeed::mazak {

// The usual control of that kind. `system` is the G-code series of lathes (T series A, B, C); an Integrex has one of
// its own.
ir::Control control(ir::MachineKind kind, ir::GSystem system);

// The control that the text was most likely written for, by macro_b's rules; an Integrex by G290 to G294, G270 to G276
// or G122.1.
ir::Control infer_control(const text::Source& source);

// As macro_b/stages.h.
ir::ReadResult read(const text::Source& source, const ir::Control& control);
std::unique_ptr<ir::PlainScanner> plain_scanner(const ir::Control& control);
std::vector<text::Diagnostic> validate(const ir::Program& program, const ir::Control& control, ir::Delivery delivery);
// Makes a program of the control `from`, or a built one, legal for the control `to`.
ir::RaiseResult raise(const ir::Program& program, const ir::Control& from, const ir::Control& to);
ir::PrintResult print(const ir::Program& program, const ir::Control& control);

}  // namespace dripfeed::mazak
