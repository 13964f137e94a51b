// The schema's history in SQLite.
#pragma once

#include <span>

#include "store/sql/migrations.h"
#include "store/sqlite/connection.h"

namespace dripfeed::sqlite {

using sql::Migration;

// Those of this program. One that was published is never edited; the next one is appended.
std::span<const Migration> migrations();

// Marks a new file, or checks an old one, and applies what it lacks, each in a transaction of its own. Errors:
// not_a_store, newer_schema, migration_failed, disk_full, io_failed, busy.
store::Result<void> migrate(Connection& connection, std::span<const Migration> migrations);

// The newest version that was applied to the file; 0 for an empty one.
store::Result<std::uint32_t> schema_version(Connection& connection);

}  // namespace dripfeed::sqlite
