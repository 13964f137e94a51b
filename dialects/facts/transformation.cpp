// The radius of a cylinder may be any axis that turns.
#include "dialects/facts/transformation.h"

#include <algorithm>

#include "dialects/ir/transformation_use.h"

namespace dripfeed::facts {

bool ends_transformation(const ir::Program& program, const ir::Block& block, const ir::Code& code) {
  if (code.argument == ir::kTransformationEnds) return true;
  if (code.argument != ir::kCylinderByRotary) return false;
  return std::ranges::all_of(program.words_of(block), [&](const ir::Word& w) {
    if (w.address > ir::Address::c || w.value == ir::ExpressionId::none) return true;
    const ir::Expression& e = program.at(w.value);
    return e.op == ir::Operator::constant && e.value == 0.0;
  });
}

}  // namespace dripfeed::facts
