// Variables of a statement, by the two walks of the header.
#include "dialects/passes/walk.h"

namespace dripfeed::passes {

std::vector<VariableUseAt> variables_of(const ir::Program& program, const ir::Statement& statement) {
  std::vector<VariableUseAt> uses;
  const auto node = [&](ir::ExpressionId id) {
    const ir::Expression& e = program.at(id);
    if (e.op == ir::Operator::variable) uses.push_back({e.variable, false});
  };
  for_each_root(
      program, statement, [&](ir::ExpressionId root) { for_each_node(program, root, node); },
      [&](ir::VariableId target) {
        for_each_node(program, program.at(target).index, node);
        for_each_node(program, program.at(target).index2, node);
        for_each_node(program, program.at(target).index3, node);
        uses.push_back({target, true});
      });
  return uses;
}

}  // namespace dripfeed::passes
