// Structures that a control lacks, said with those that it has. Each pass leaves a program that does the same.
#pragma once

#include <cstdint>
#include <vector>

#include "dialects/ir/program.h"
#include "dialects/passes/labels.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::passes {

struct StructureReport {
  std::uint32_t changed = 0;  // structures rewritten
  std::vector<text::Diagnostic> diagnostics;
};

// FOR becomes an assignment and WHILE; REPEAT ... UNTIL becomes an endless loop left by a jump.
StructureReport lower_counted_loops(ir::Program& program, FreeNumbers& numbers);

// IF ... ELSE ... ENDIF becomes jumps over its parts. An IF without ELSE around one assignment or alarm stays (IF …
// THEN), as does everything when `single_only` is false and only ELSE is lacking.
StructureReport lower_conditions(ir::Program& program, FreeNumbers& numbers);

// AND, OR, NOT between comparisons in the conditions of WHILE and jumps become several jumps.
StructureReport lower_logic(ir::Program& program, FreeNumbers& numbers);

// Loops nested deeper than `limit` become jumps, the outermost first: they repeat least often.
StructureReport limit_loop_nesting(ir::Program& program, FreeNumbers& numbers, std::uint32_t limit);

// The opposite of a condition: comparisons are turned round, AND and OR by De Morgan.
ir::ExpressionId negated(ir::Program& program, ir::ExpressionId condition);

}  // namespace dripfeed::passes
