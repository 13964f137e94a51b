// To the place where the line begins, from where the retract has left the tool, and then the modes that the line finds.
//
//   mill    G0 X Y A B C             with the tool axis still clear
//           G0 G43 H Z               down to the level where the program itself was last at rapid
//           G1 Z F                   and from there by feed, if the program came there by feed
//
//   lathe   in front of the part     G0 X, then G0 Z
//           outside of it            G0 Z, then G0 X to a clear diameter, then G1 X
//           inside                   refused: from where a bore is clear, the moves do not show
#pragma once

#include "dialects/compile/restart/restart_preamble.h"

namespace dripfeed::compile {

std::optional<RestartRefusal> write_approach(RestartDraft& draft);

}  // namespace dripfeed::compile
