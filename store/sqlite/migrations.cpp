// The list of migrations and how they are applied.
#include "store/sqlite/migrations.h"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

#include "store/hash/sha256.h"
#include "store/sql/session.h"
#include "store/sqlite/schema_v1.h"
#include "store/sqlite/schema_v10.h"
#include "store/sqlite/schema_v11.h"
#include "store/sqlite/schema_v12.h"
#include "store/sqlite/schema_v13.h"
#include "store/sqlite/schema_v14.h"
#include "store/sqlite/schema_v3.h"
#include "store/sqlite/schema_v4.h"
#include "store/sqlite/schema_v5.h"
#include "store/sqlite/schema_v6.h"
#include "store/sqlite/schema_v7.h"
#include "store/sqlite/schema_v8.h"
#include "store/sqlite/schema_v9.h"

namespace dripfeed::sqlite {
namespace {

using sql::Query;
using sql::Session;
using store::Error;
using store::ErrorCode;
using store::Result;

// "DRIP": stands in the file's header and tells a store from any other SQLite file.
constexpr std::uint64_t kApplicationId = 0x44524950;
constexpr const char* kMark =
    "PRAGMA application_id = 0x44524950;"
    "CREATE TABLE migration (version INTEGER PRIMARY KEY, name TEXT NOT NULL, sha256 TEXT NOT NULL) STRICT;";

// Version 2: until when an arming lasts.
constexpr const char* kSchemaV2 =
    "ALTER TABLE job ADD COLUMN expires_at_ms INTEGER NOT NULL DEFAULT 0 CHECK (expires_at_ms >= 0);";

enum class FileKind : std::uint8_t { empty, store, other };

std::uint64_t one_number(Session& session, std::string_view sql) {
  Query query(session, sql);
  return query.next() ? query.number() : 0;
}

FileKind kind_of(Session& session) {
  const std::uint64_t id = one_number(session, "PRAGMA application_id");
  const std::uint64_t tables = one_number(session, "SELECT count(*) FROM sqlite_master");
  if (id == kApplicationId) return FileKind::store;
  return id == 0 && tables == 0 ? FileKind::empty : FileKind::other;
}

// Version and hash of every migration in the file, by version. None in an empty file.
struct Applied {
  std::uint32_t version = 0;
  std::string sha256;
};

Result<std::vector<Applied>> applied_to(Connection& connection) {
  Session session(connection, "schema");
  std::vector<Applied> found;
  const FileKind kind = kind_of(session);
  if (session.ok() && kind == FileKind::other) return session.refuse(ErrorCode::not_a_store, "another program's file");
  if (session.ok() && kind == FileKind::store) {
    Query query(session, "SELECT version, sha256 FROM migration ORDER BY version");
    while (query.next()) found.push_back({static_cast<std::uint32_t>(query.number()), query.text()});
  }
  if (!session.ok()) return std::unexpected(session.error());
  return found;
}

// What the file says against this program's history.
Result<void> compare(std::span<const Applied> applied, std::span<const Migration> known) {
  for (const Applied& old : applied) {
    const auto same = std::ranges::find(known, old.version, &Migration::version);
    if (same == known.end()) {
      const std::uint32_t newest = known.empty() ? 0 : known.back().version;
      return std::unexpected(
          Error{ErrorCode::newer_schema, fmt::format("its schema is {}, this program knows {}", old.version, newest)});
    }
    if (hash::sha256_hex(same->sql) != old.sha256) {
      return std::unexpected(Error{ErrorCode::migration_failed,
                                   fmt::format("schema {} of the file is not the one of this program", old.version)});
    }
  }
  return {};
}

Result<void> apply(Connection& connection, const Migration& migration, bool first) {
  if (first) {
    if (auto marked = connection.execute(kMark); !marked) return marked;
  }
  if (auto done = connection.execute(migration.sql); !done) return done;
  Session session(connection, "schema");
  if (session.run("INSERT INTO migration (version, name, sha256) VALUES (?, ?, ?)", migration.version, migration.name,
                  hash::sha256_hex(migration.sql))) {
    return {};
  }
  return std::unexpected(session.error());
}

// The engine's own words for a fault of the disk stay; all else is a migration that does not fit.
Error as_migration(const Error& error, const Migration& migration) {
  const bool disk = error.code == ErrorCode::disk_full || error.code == ErrorCode::io_failed ||
                    error.code == ErrorCode::busy || error.code == ErrorCode::corrupt;
  return {disk ? error.code : ErrorCode::migration_failed,
          fmt::format("schema {} ({}): {}", migration.version, migration.name, error.detail)};
}

// Looks again under the write lock: another process may have been faster.
Result<void> apply_in_transaction(Connection& connection, std::span<const Migration> known,
                                  const Migration& migration) {
  if (auto begun = connection.execute("BEGIN IMMEDIATE"); !begun) return begun;
  auto applied = applied_to(connection);
  Result<void> done = applied ? compare(*applied, known) : std::unexpected(applied.error());
  if (done && std::ranges::find(*applied, migration.version, &Applied::version) == applied->end()) {
    done = apply(connection, migration, applied->empty());
    if (!done) done = std::unexpected(as_migration(done.error(), migration));
  }
  if (done) done = connection.execute("COMMIT");
  if (!done && connection.in_transaction()) static_cast<void>(connection.execute("ROLLBACK"));
  return done;
}

}  // namespace

std::span<const Migration> migrations() {
  static const std::array kMigrations{Migration{1, "first", kSchemaV1},
                                      Migration{2, "arming expires", kSchemaV2},
                                      Migration{3, "receipts", kSchemaV3},
                                      Migration{4, "torn jobs by index", kSchemaV4},
                                      Migration{5, "answers are booked", kSchemaV5},
                                      Migration{6, "alarms", kSchemaV6},
                                      Migration{7, "browser sessions", kSchemaV7},
                                      Migration{8, "queue order", kSchemaV8},
                                      Migration{9, "labels of programs", kSchemaV9},
                                      Migration{10, "users", kSchemaV10},
                                      Migration{11, "webhooks and orders", kSchemaV11},
                                      Migration{12, "called programs of verdicts", kSchemaV12},
                                      Migration{13, "restarts", kSchemaV13},
                                      Migration{14, "waivers of points", kSchemaV14}};
  return kMigrations;
}

Result<void> migrate(Connection& connection, std::span<const Migration> known) {
  auto applied = applied_to(connection);
  if (!applied) return std::unexpected(applied.error());
  if (auto fits = compare(*applied, known); !fits) return fits;
  for (const Migration& migration : known) {
    if (std::ranges::find(*applied, migration.version, &Applied::version) != applied->end()) continue;
    if (auto done = apply_in_transaction(connection, known, migration); !done) return done;
  }
  return {};
}

Result<std::uint32_t> schema_version(Connection& connection) {
  const auto applied = applied_to(connection);
  if (!applied) return std::unexpected(applied.error());
  return applied->empty() ? 0 : applied->back().version;
}

}  // namespace dripfeed::sqlite
