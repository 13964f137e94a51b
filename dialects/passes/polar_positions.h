// Positions by radius and angle: AP and RP from a pole on SINUMERIK, the plane's two letters between G16 and G15 on the
// others. Neither knows the form of the other; what both know are coordinates.
#pragma once

#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::passes {

// Each polar position becomes its two coordinates, a number where radius, angle and pole are numbers and a calculation
// otherwise; an arc round its pole gets that as its centre. Poles and the codes between which letters are polar go.
// Only for mills. Refused at the block (translation_…, see refusal.h): a pole, a radius or an angle that is not known
// there (paths disagree, or it counts from where the tool stands), a plane or a motion that is not known, G16 over
// jumps and calls.
std::vector<text::Diagnostic> lower_polar_positions(ir::Program& program, const ir::Control& from,
                                                    const ir::Control& to);

}  // namespace dripfeed::passes
