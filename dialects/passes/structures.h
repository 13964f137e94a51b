// Structures that a control lacks, said with those that it has. Each pass leaves a program that does the same. They are
// to run in the order of this file; jumps are to be numbered before all but the first two (number_labels).
#pragma once

#include <cstdint>
#include <vector>

#include "dialects/ir/program.h"
#include "dialects/passes/labels.h"
#include "dialects/text/diagnostic.h"

namespace dripfeed::passes {

struct StructureReport {
  std::uint32_t changed = 0;                  // structures rewritten
  std::vector<text::Diagnostic> diagnostics;  // refusals; missing_end and end_without_begin are the reader's
};

// REPEAT of a part of the program becomes jumps and a counter. To run before labels are numbered. A part that lies in
// another loop than its REPEAT, or that would run itself, stays: a control without REPEAT refuses it.
StructureReport lower_repeated_parts(ir::Program& program, FreeNumbers& numbers);

// GOTO#1 becomes comparisons with the block numbers of the program, and an alarm when none is it. Programs of more than
// 200 numbers keep it.
StructureReport lower_computed_jumps(ir::Program& program);

// FOR becomes an assignment and WHILE; REPEAT ... UNTIL becomes an endless loop left by a jump.
StructureReport lower_counted_loops(ir::Program& program, FreeNumbers& numbers);

// IF ... ELSE ... ENDIF becomes jumps over its parts. An IF without ELSE around one assignment or alarm stays, when its
// condition is one comparison: controls have IF … THEN for it.
StructureReport lower_conditions(ir::Program& program, FreeNumbers& numbers);

// Conditions of jumps and WHILE become single comparisons: AND, OR and NOT become several jumps, a value by itself is
// compared with 0, a constant is decided here. XOR between conditions is refused.
StructureReport lower_logic(ir::Program& program, FreeNumbers& numbers);

// Loops nested deeper than `limit` become jumps, the outermost first: they repeat least often. The others get their
// depth as loop number.
StructureReport limit_loop_nesting(ir::Program& program, FreeNumbers& numbers, std::uint32_t limit);

// The opposite of a condition: comparisons are turned round, AND and OR by De Morgan, a value is compared with 0.
ir::ExpressionId negated(ir::Program& program, ir::ExpressionId condition);

}  // namespace dripfeed::passes
