// Mirror, scale and rotation about points that they name themselves (G51.1, G51, G68): each is switched on and off for
// itself, besides the local shift (G52), and the three lie inside each other in this order:
//
//   position = shift + mirror(scale(rotation(programmed))),   each of them: p -> center + matrix · (p - center)
//
// Fanuc 0i-F B-64604EN-2, "Coordinate system rotation", "Scaling", "Programmable mirror image": mirror, scale and
// rotation are commanded in this order and cancelled in the reverse one, and a center is itself scaled and mirrored by
// what lies outside it.
#pragma once

#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/ir/function.h"

namespace dripfeed::interpreter {

// What was left to a parameter of the control.
enum class PointFrameGap : std::uint8_t { none, factor_unit, factor, angle };

// `function` is rotate, scale or mirror. A coordinate of the center that is not named is where the tool stands.
PointFrameGap set_point_frame(const PlainBlock& block, const BlockRules& rules, ir::Function function,
                              ModalState& state);
// G69, G50; G50.1 ends the axes that it names, or all. False, and nothing changed, where there is none to be ended.
bool end_point_frame(const PlainBlock& block, const BlockRules& rules, ir::Function function, ModalState& state);
// Shift and matrix of the modes again, from the local shift and the three.
void compose_frames(const BlockRules& rules, Modes& modes);

}  // namespace dripfeed::interpreter
