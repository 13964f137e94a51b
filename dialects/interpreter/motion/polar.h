// Polar positions: a pole, an angle and a radius in the plane instead of two coordinates.
#pragma once

#include "dialects/interpreter/state/block_rules.h"
#include "dialects/interpreter/state/modal_state.h"
#include "dialects/interpreter/state/plain_block.h"
#include "dialects/ir/function.h"

namespace dripfeed::interpreter {

// Whether the block names an angle or a radius.
bool has_polar_words(const PlainBlock& block);
// The same block with the plane's two coordinates in place of AP and RP. Angle and radius stay for the blocks to come.
PlainBlock with_coordinates(const PlainBlock& block, const BlockRules& rules, ModalState& state);
// The same arc around the pole, when it names neither centre nor radius nor opening angle.
PlainBlock with_center_at_pole(const PlainBlock& block, const BlockRules& rules, const ModalState& state);
// Under G16: the same block with coordinates in place of a radius and an angle in the plane's two letters. A radius by
// an increment counts from where the tool stands, an angle by an increment from the last one.
PlainBlock with_coordinates_of_letters(const PlainBlock& block, const BlockRules& rules, ModalState& state);
// The block then names an absolute coordinate of X, Y or Z (`axis` 0 to 2): programmed, radius value, mm.
void put_coordinate(PlainBlock& made, const BlockRules& rules, const ModalState& state, std::size_t axis,
                    double coordinate_mm);
// … the centre of an arc in it.
void put_center(PlainBlock& made, const BlockRules& rules, const ModalState& state, std::size_t axis,
                double coordinate_mm);
// G110, G111, G112: the pole, from the last position, the zero point or the last pole.
void set_pole(const PlainBlock& block, const BlockRules& rules, ir::Function function, ModalState& state);
// The state's position in programmed coordinates X Y Z: radius values, mm.
Vector programmed_position(const BlockRules& rules, const ModalState& state);

}  // namespace dripfeed::interpreter
