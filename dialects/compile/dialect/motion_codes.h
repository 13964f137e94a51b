// What a motion is called in a block: its code, the letters of its axes and its centre.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "dialects/ir/control.h"
#include "dialects/ir/function.h"
#include "dialects/ir/motion.h"
#include "dialects/ir/statement.h"

namespace dripfeed::compile {

// In the order of Motion::end and Motion::center.
inline constexpr std::array kAxisAddresses = {ir::Address::x, ir::Address::y, ir::Address::z,
                                              ir::Address::a, ir::Address::b, ir::Address::c,
                                              ir::Address::u, ir::Address::v, ir::Address::w};
static_assert(kAxisAddresses.size() == ir::kAxisCount);
inline constexpr std::array kCenterAddresses = {ir::Address::i, ir::Address::j, ir::Address::k};

// Of a curve each chord is a straight cut. Nothing for what has no plain code: a thread, an event.
std::optional<ir::Function> plain_function_of(ir::MotionKind kind);
ir::Function function_of(ir::CompSide side);
ir::Function function_of(ir::Plane plane);
// A code by what it does, without a number or name of its own.
ir::Code code_of(ir::Function function, ir::ModalGroup group);
// Whether the control has a G code that does this.
bool has_row(const ir::Control& control, ir::Function function, std::int16_t argument);
bool is_arc(ir::MotionKind kind);
// A dwell that waits, or a move that goes anywhere; one whose place is not known may.
bool leads_somewhere(const ir::Motion& motion);
// Bit per Axis: what a block of the move has to name, the axes of its words and every other one that it moves.
std::uint16_t axes_to_name(const ir::Motion& motion);
// Whether X, Y or Z (0 to 2) lies in the plane.
bool is_in_plane(ir::Plane plane, std::size_t axis);

}  // namespace dripfeed::compile
