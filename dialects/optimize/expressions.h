// Expressions as trees to compare, measure and copy.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "dialects/ir/control.h"
#include "dialects/ir/program.h"
#include "dialects/optimize/places.h"

namespace dripfeed::optimize {

// The place that the node reads, kNoPlace for other nodes.
Place place_at(const ir::Program& program, const Places& places, ir::ExpressionId id);

// Whether computing it can be an alarm for some values: a division by what is not a constant, a square root ...
bool may_fault(const ir::Program& program, ir::ExpressionId id);
// Whether every leaf is a number or a plain place, and every node gives a number.
bool is_pure(const ir::Program& program, const Places& places, ir::ExpressionId id);
// Whether it cannot be vacant: it is computed, or the control knows no vacant variables.
bool is_number(const ir::Program& program, const ir::Control& control, ir::ExpressionId id);
bool mentions_vacant(const ir::Program& program, ir::ExpressionId id);

void add_places(const ir::Program& program, const Places& places, ir::ExpressionId id, std::vector<Place>& out);
std::size_t count_of(const ir::Program& program, const Places& places, ir::ExpressionId id, Place place);

// Levels of brackets and characters that it takes at the most where it stands in a text.
std::uint32_t depth_of(const ir::Program& program, ir::ExpressionId id);
std::uint32_t length_of(const ir::Program& program, ir::ExpressionId id);

// ms, by the figures of the model.
double cost_of(const ir::Program& program, const ir::CostModel& model, ir::ExpressionId id);
double read_cost(const ir::CostModel& model, const PlaceFacts& place);

// The tree with each node replaced by what `replace` gives for it, operands first; `replace` gets a node whose operands
// are new already. The same id where nothing changed.
using Replace = std::function<ir::ExpressionId(ir::ExpressionId)>;
ir::ExpressionId rebuilt(ir::Program& program, ir::ExpressionId id, const Replace& replace);

// A node that reads the place.
ir::ExpressionId read_of(ir::Program& program, const PlaceFacts& place);
ir::VariableId variable_of(ir::Program& program, const PlaceFacts& place);

}  // namespace dripfeed::optimize
