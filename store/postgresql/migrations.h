// The schema's history on PostgreSQL. It began with the tables of SQLite's version 14; its numbers are its own.
#pragma once

#include <span>

#include "store/postgresql/connection.h"
#include "store/sql/migrations.h"

namespace dripfeed::postgresql {

// Those of this program. One that was published is never edited; the next one is appended.
std::span<const sql::Migration> migrations();

// Makes the tables where there are none (`create`), and applies what the schema lacks. Errors: not_a_store,
// newer_schema, migration_failed, disk_full, io_failed, busy.
store::Result<void> bring_up_to_date(Connection& connection, bool create);

// The newest version that was applied; 0 where there is no store.
store::Result<std::uint32_t> schema_version(Connection& connection);

}  // namespace dripfeed::postgresql
