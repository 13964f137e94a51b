// Looks at a whole store and changes nothing; a server may run meanwhile. The files of the database are the business of
// PostgreSQL, as pg_amcheck.
#pragma once

#include <string>

#include "store/sql/verifier.h"

namespace dripfeed::postgresql {

// Errors: cannot_open, not_a_store, newer_schema, migration_failed (an older schema: a server brings it up to date),
// busy, io_failed.
store::Result<sql::Verification> verify(const std::string& url);

}  // namespace dripfeed::postgresql
