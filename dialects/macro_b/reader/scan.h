// scan: the short path of plain blocks, from bytes to words without tokens. It takes what the reader would take without
// a word of complaint and leaves every other block to it.
#pragma once

#include <memory>

#include "dialects/ir/control.h"
#include "dialects/ir/plain_batch.h"
#include "dialects/macro_b/tables/grammar.h"

namespace dripfeed::macro_b {

// `control` and `grammar` must outlive it.
std::unique_ptr<ir::PlainScanner> make_scanner(const ir::Control& control, const Grammar& grammar);

}  // namespace dripfeed::macro_b
