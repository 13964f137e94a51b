// Positions as a control counts them: whole multiples of its least increment in the unit that is in effect. The end
// points are rounded: of a chain of increments each takes over what the one before it left.
#pragma once

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::passes {

// Of constants in words, in the terms of `control`. What the program computes, its control rounds itself.
void round_positions(ir::Program& program, const ir::Control& control);

// One absolute position, in mm or inch or, of a rotary axis, in degrees.
double nearest_position(double value, bool rotary, bool inch, const ir::Control& control);

// What `control` counts in, in mm: of a program that is written in inches the least increment is a tenth of the one in
// mm, in inches (0.001 mm and 0.0001 inch).
double least_increment_mm(const ir::Control& control, bool inch);

}  // namespace dripfeed::passes
