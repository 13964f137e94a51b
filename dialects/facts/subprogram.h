// Whether a program of a text is one that others call: it begins in what its caller has set.
#pragma once

#include "dialects/facts/flow_graph.h"
#include "dialects/ir/program.h"

namespace dripfeed::facts {

// It returns (M99, M17, RET) or has a head (PROC), and has no end of its own (M30, M2).
bool is_subprogram(const ir::Program& program, const StatementRange& range);
bool is_subprogram(const ir::Program& program);
// It has an end of its own.
bool has_end(const ir::Program& program, const StatementRange& range);

}  // namespace dripfeed::facts
