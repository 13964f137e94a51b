// Bringing a schema up to date: an engine has an ordered table of versions. What was applied is recorded in the store
// with the hash of its SQL, so a store of another history is refused instead of guessed at.
#pragma once

#include <span>

#include "store/sql/connection.h"

namespace dripfeed::sql {

struct Migration {
  std::uint32_t version = 0;  // 1, 2, 3, …
  std::string_view name;
  const char* sql = nullptr;
};

// How an engine distinguishes a store from another program's tables.
struct Mark {
  // Whether the mark stands there; false where there is nothing at all. Errors: not_a_store.
  store::Result<bool> (*stands)(Connection& connection);
  // Makes it, with the empty table migration (version, name, sha256).
  const char* sql;
};

// Marks a new store, or checks an old one, and applies what it lacks, each in a transaction of its own. Errors:
// not_a_store, newer_schema, migration_failed, disk_full, io_failed, busy.
store::Result<void> migrate(Connection& connection, std::span<const Migration> migrations, const Mark& mark);

// The newest version that was applied; 0 for an empty store.
store::Result<std::uint32_t> schema_version(Connection& connection, const Mark& mark);

}  // namespace dripfeed::sql
