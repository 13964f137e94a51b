// Fanuc's grammar has no IF blocks and three loops; all else is in the control's tables.
#include "dialects/macro_b/raise.h"

#include "dialects/fanuc/fanuc.h"
#include "dialects/fanuc/tables.h"

namespace dripfeed::fanuc {

ir::RaiseResult raise(const ir::Program& program, const ir::Control& from, const ir::Control& to) {
  return macro_b::raise(program, from, to, grammar());
}

}  // namespace dripfeed::fanuc
