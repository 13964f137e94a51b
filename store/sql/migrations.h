// Bringing a schema up to date: an engine has an ordered table of versions. What was applied is recorded in the store
// with the hash of its SQL, so a store of another history is refused instead of guessed at.
#pragma once

#include <span>
#include <vector>

#include "store/sql/connection.h"

namespace dripfeed::sql {

struct Migration {
  std::uint32_t version = 0;  // 1, 2, 3, …
  std::string_view name;
  const char* sql = nullptr;
  // The oldest schema whose programs go on with a store that has this one: where it only adds what they need not know.
  // 0: none but those that know this one.
  std::uint32_t keeps = 0;
};

// How an engine distinguishes a store from another program's tables.
struct Mark {
  // Whether the mark stands there; false where there is nothing at all. Errors: not_a_store.
  store::Result<bool> (*stands)(Connection& connection);
  // Makes it, with the empty table migration (version, name, sha256).
  const char* sql;
  // Version, hash, and the oldest schema whose programs work with it, of each migration that was applied, by version.
  std::string_view applied = "SELECT version, sha256, version FROM migration ORDER BY version";
  // Notes the third of these for a migration with `keeps`: its number, the version. Empty where a store has one
  // program.
  std::string_view keep = {};
};

// Marks a new store, or checks an old one, and applies what it lacks, each in a transaction of its own. Errors:
// not_a_store, newer_schema, migration_failed, disk_full, io_failed, busy.
store::Result<void> migrate(Connection& connection, std::span<const Migration> migrations, const Mark& mark);

// The newest version that was applied; 0 for an empty store.
store::Result<std::uint32_t> schema_version(Connection& connection, const Mark& mark);

// The versions that `migrations` have and the store has not. Errors: as above, newer_schema where the store has one
// that this program does not know and that keeps no program as old as this.
store::Result<std::vector<Migration>> lacking(Connection& connection, std::span<const Migration> migrations,
                                              const Mark& mark);

}  // namespace dripfeed::sql
