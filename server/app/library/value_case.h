// From a receipt to what its numbers are looked for in: the stored program of its name, and the family, values and
// machine that this was rendered with.
#pragma once

#include "server/app/base/documents.h"
#include "server/app/library/value_changes.h"
#include "store/store.h"

namespace dripfeed::app {

struct ValueCase {
  store::ProgramRevision stored;  // with its origin
  ValueOrder order;
};

// Errors: refused: it is in quarantine, no program has its name, or that was not rendered from a family or is too long
// to be compared; those of the store.
Result<ValueCase> load_value_case(store::Store& store, const Documents& documents, const store::Receipt& receipt);

}  // namespace dripfeed::app
