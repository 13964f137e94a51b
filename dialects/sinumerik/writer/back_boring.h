// Back boring (G87) has no cycle here: a hole as its blocks.
#pragma once

#include "dialects/ir/program.h"
#include "dialects/passes/rewrite.h"

namespace dripfeed::sinumerik {

struct BackBoring {
  ir::ExpressionId initial = ir::ExpressionId::none;  // levels of the drilling axis
  ir::ExpressionId level = ir::ExpressionId::none;
  ir::ExpressionId depth = ir::ExpressionId::none;
  ir::ExpressionId shift_x = ir::ExpressionId::none;  // none: not in this axis
  ir::ExpressionId shift_y = ir::ExpressionId::none;
  ir::ExpressionId dwell_s = ir::ExpressionId::none;
  ir::Function spindle = ir::Function::spindle_cw;
};

// The tool stands over the hole, at the initial level, before and after.
void emit_back_boring(const BackBoring& hole, ir::Program& program, passes::Rewrite& out);

}  // namespace dripfeed::sinumerik
