// A rule for one code; a block follows the strictest of its codes.
#include "dialects/facts/axis_words.h"

#include <algorithm>

namespace dripfeed::facts {

using ir::Function;
using ir::ModalGroup;

bool has_own_words(const ir::Code& code) {
  if (code.function == Function::exact_stop_once) return false;
  if (code.number != ir::ExpressionId::none) return code.letter == 'G';
  return code.group == ModalGroup::non_modal || code.group == ModalGroup::frame ||
         code.function == Function::not_modelled || code.function == Function::machine_coordinates;
}

bool has_own_words(const ir::Program& program, const ir::Block& block) {
  return std::ranges::any_of(program.codes_of(block), [](const ir::Code& code) { return has_own_words(code); });
}

}  // namespace dripfeed::facts
