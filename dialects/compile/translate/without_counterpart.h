// Which statements make moves that the other control has no word for, but that could be written as plain moves: arcs
// by a point in between or a tangent, drilling cycles of lathes, hole patterns, stock removal.
#pragma once

#include <string>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"

namespace dripfeed::compile {

// Taps are found by tap_statements(). Pecks: a deep hole whose strokes the other control's cycle would make otherwise;
// where they cannot be written as moves, that cycle is the nearest that it has.
enum class WithoutCounterpart : std::uint8_t { no, arc, drilling, pecks, removal, tap, tap_part };

// For each statement, in the order of the text: what is in effect counts from the block that says it to the next one
// that says something else.
std::vector<WithoutCounterpart> without_counterpart(const ir::Program& program, const ir::Control& from,
                                                    const ir::Control& to);

// As messages call it: "CIP", "G71", "CYCLE95".
std::string name_of(WithoutCounterpart kind, const ir::Program& program, const ir::Statement& statement);

}  // namespace dripfeed::compile
