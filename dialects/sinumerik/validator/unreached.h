// Blocks that no run comes to. The control reads a block when a run comes to it, and alarms on no fault of the others.
#pragma once

#include <cstdint>
#include <vector>

#include "dialects/facts/flow_graph.h"
#include "dialects/ir/program.h"

namespace dripfeed::sinumerik {

// A cycle runs the blocks of its contour and comes back, whatever stands after them.
enum class Contours : std::uint8_t { reached, left_out };

// Marks those statements and what comes after them; nothing comes after `last`. `reached` has one more than the program
// has statements: the end of the text.
void flood(const ir::Program& program, facts::FlowGraph& graph, std::vector<std::uint32_t> work, std::uint32_t last,
           std::vector<bool>& reached, Contours contours = Contours::reached);

// Statements that only a cycle runs: from a label that it is given in a text, as in CYCLE95("START:END",…), to the next
// block that is reached.
std::vector<bool> contours_of_cycles(const ir::Program& program, const std::vector<bool>& reached);

}  // namespace dripfeed::sinumerik
