// What a called program has done is not known.
#include "dialects/facts/spindle.h"

namespace dripfeed::facts {

std::optional<ir::Function> stated_spindle(const ir::Program& program, const Facts& facts) {
  const Known<Setting>& spindle = facts[Mode::spindle];
  if (!spindle.agrees()) return std::nullopt;
  const bool is_block = spindle.changer < program.statements.size() &&
                        program.statements[spindle.changer].kind == ir::StatementKind::block;
  if (spindle.changer != kNoStatement && !is_block) return std::nullopt;
  return spindle.value.function;
}

}  // namespace dripfeed::facts
