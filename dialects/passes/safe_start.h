// What a program leaves to the state that its control has at power-on: controls have different ones, so a translation
// says it.
#pragma once

#include <span>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::passes {

struct UnstatedMode {
  ir::ModalGroup group;
  ir::Function function;  // what the program's own control has at power-on
};

struct UnstatedModes {
  std::vector<UnstatedMode> modes;  // motion, plane, unit, distance, feed, diameter
  std::vector<text::Diagnostic>
      diagnostics;  // those of them that no profile has confirmed: warnings; of the unit: an error
};

// Modes that the program relies on and does not say before it first moves, in the order of the text. None for a
// subprogram or where a called program may say them. `diameter`: whether the translation has that mode at all.
UnstatedModes unstated_modes(const ir::Program& program, const ir::Control& from, bool diameter);

// A block of these codes in front of everything else. Nothing without codes.
void insert_first(ir::Program& program, std::span<const ir::Code> codes);

}  // namespace dripfeed::passes
