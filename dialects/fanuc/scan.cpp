// The scanner of plain blocks with Fanuc's grammar.
#include "dialects/macro_b/scan.h"

#include "dialects/fanuc/fanuc.h"
#include "dialects/fanuc/tables.h"

namespace dripfeed::fanuc {

std::unique_ptr<ir::PlainScanner> plain_scanner(const ir::Control& control) {
  return macro_b::make_scanner(control, grammar());
}

}  // namespace dripfeed::fanuc
