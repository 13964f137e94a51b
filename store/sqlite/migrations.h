// The schema's history: an ordered table of versions. What was applied is recorded in the file with the hash of its
// SQL, so a file of another history is refused instead of guessed at.
#pragma once

#include <span>

#include "store/sqlite/connection.h"

namespace dripfeed::sqlite {

struct Migration {
  std::uint32_t version = 0;  // 1, 2, 3, …
  std::string_view name;
  const char* sql = nullptr;
};

// Those of this program. One that was published is never edited; the next one is appended.
std::span<const Migration> migrations();

// Marks a new file, or checks an old one, and applies what it lacks, each in a transaction of its own. Errors:
// not_a_store, newer_schema, migration_failed, disk_full, io_failed, busy.
store::Result<void> migrate(Connection& connection, std::span<const Migration> migrations);

// The newest version that was applied to the file; 0 for an empty one.
store::Result<std::uint32_t> schema_version(Connection& connection);

}  // namespace dripfeed::sqlite
