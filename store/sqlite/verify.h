// Looks at a whole store and changes nothing: whether the file is sound, the audit's chain unbroken, each job's ledger
// complete and in order, each content the one of its hash, and the torn marks possible. A server may run meanwhile.
#pragma once

#include <string>

#include "store/sql/verifier.h"
#include "store/sqlite/open.h"

namespace dripfeed::sqlite {

using sql::Verification;
using sql::VerifyFault;

// Errors: cannot_open, not_a_store, newer_schema, migration_failed (an older schema: a server brings it up to date),
// busy, io_failed; and corrupt where the file is so broken that nothing can be read.
store::Result<Verification> verify(const std::string& path);

}  // namespace dripfeed::sqlite
