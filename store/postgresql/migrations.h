// The schema's history on PostgreSQL. It began with the tables of SQLite's version 14; its numbers are its own.
#pragma once

#include <span>

#include "store/postgresql/connection.h"
#include "store/sql/migrations.h"

namespace dripfeed::postgresql {

// Those of this program. One that was published is never edited; the next one is appended.
std::span<const sql::Migration> migrations();

// Makes the tables where there are none (`settings.create`), and applies what the schema lacks, also while other nodes
// work with it: those whose program does not know what a migration needs it to know must have stopped. Errors:
// not_a_store, newer_schema, migration_failed, disk_full, io_failed, busy.
store::Result<void> bring_up_to_date(Connection& connection, const OpenSettings& settings,
                                     std::span<const sql::Migration> known = migrations());

// The store has all that this program needs, and nothing that it must know and does not. Errors: cannot_open (there is
// no store), newer_schema, migration_failed (an older one).
store::Result<void> know_schema(Connection& connection);

// The newest version that was applied; 0 where there is no store.
store::Result<std::uint32_t> schema_version(Connection& connection);

}  // namespace dripfeed::postgresql
