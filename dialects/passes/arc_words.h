// Arcs whose words controls take differently: without any centre or radius, or with both.
#pragma once

#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::passes {

// From any control to another one. Neither centre nor radius: a control goes straight or stops, as a parameter says
// (Fanuc 3403#5), or always stops: an error at the block. Both, on controls of '#' variables: the radius counts
// (B-64604EN, circular interpolation), so the centre's words go. A centre's word that is left out is 0 everywhere and
// stays so. Those controls' blocks are followed in the order of the text, SINUMERIK's on all paths.
std::vector<text::Diagnostic> translate_arcs(ir::Program& program, const ir::Control& from, const ir::Control& to);

}  // namespace dripfeed::passes
