// How migrations are applied.
#include "store/sql/migrations.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "store/hash/sha256.h"
#include "store/sql/session.h"

namespace dripfeed::sql {
namespace {

using store::Error;
using store::ErrorCode;
using store::Result;

// A migration in the store.
struct Applied {
  std::uint32_t version = 0;
  std::string sha256;
  std::uint32_t needs = 0;  // the oldest schema whose programs work with it
};

// By version. None in an empty store.
Result<std::vector<Applied>> applied_to(Connection& connection, const Mark& mark) {
  const auto stands = mark.stands(connection);
  if (!stands) return std::unexpected(stands.error());
  std::vector<Applied> found;
  if (!*stands) return found;
  Session session(connection, "schema");
  {
    Query query(session, mark.applied);
    while (query.next()) {
      Applied& one = found.emplace_back();
      one.version = static_cast<std::uint32_t>(query.number());
      one.sha256 = query.text();
      one.needs = static_cast<std::uint32_t>(query.number());
    }
  }
  if (!session.ok()) return std::unexpected(session.error());
  return found;
}

// What the store says against this program's history.
Result<void> compare(std::span<const Applied> applied, std::span<const Migration> known) {
  const std::uint32_t newest = known.empty() ? 0 : known.back().version;
  for (const Applied& old : applied) {
    const auto same = std::ranges::find(known, old.version, &Migration::version);
    if (same == known.end()) {
      if (old.needs <= newest) continue;
      return std::unexpected(
          Error{ErrorCode::newer_schema, fmt::format("its schema is {}, this program knows {}", old.version, newest)});
    }
    if (hash::sha256_hex(same->sql) != old.sha256) {
      return std::unexpected(Error{ErrorCode::migration_failed,
                                   fmt::format("schema {} of the store is not the one of this program", old.version)});
    }
  }
  return {};
}

Result<void> apply(Connection& connection, const Migration& migration, const Mark& mark, bool is_first) {
  if (is_first) {
    if (auto marked = connection.execute(mark.sql); !marked) return marked;
  }
  if (auto done = connection.execute(migration.sql); !done) return done;
  Session session(connection, "schema");
  session.run("INSERT INTO migration (version, name, sha256) VALUES (?, ?, ?)", migration.version, migration.name,
              hash::sha256_hex(migration.sql));
  if (migration.keeps != 0 && !mark.keep.empty()) session.run(mark.keep, migration.keeps, migration.version);
  if (session.ok()) return {};
  return std::unexpected(session.error());
}

// The engine's own words for a fault of the disk or the connection stay; all else is a migration that does not fit.
Error as_migration(const Error& error, const Migration& migration) {
  const bool disk = error.code == ErrorCode::disk_full || error.code == ErrorCode::io_failed ||
                    error.code == ErrorCode::no_answer || error.code == ErrorCode::busy ||
                    error.code == ErrorCode::corrupt;
  return {disk ? error.code : ErrorCode::migration_failed,
          fmt::format("schema {} ({}): {}", migration.version, migration.name, error.detail)};
}

// Looks again under the write lock: another process may have been faster.
Result<void> apply_in_transaction(Connection& connection, std::span<const Migration> known, const Migration& migration,
                                  const Mark& mark) {
  if (auto begun = connection.transact(connection.words().begin_to_write); !begun) return begun;
  auto applied = applied_to(connection, mark);
  Result<void> done = applied ? compare(*applied, known) : std::unexpected(applied.error());
  if (done && std::ranges::find(*applied, migration.version, &Applied::version) == applied->end()) {
    done = apply(connection, migration, mark, applied->empty());
    if (!done) done = std::unexpected(as_migration(done.error(), migration));
  }
  if (done) done = connection.transact("COMMIT");
  if (!done && connection.in_transaction()) static_cast<void>(connection.transact("ROLLBACK"));
  return done;
}

}  // namespace

Result<void> migrate(Connection& connection, std::span<const Migration> known, const Mark& mark) {
  const auto wanted = lacking(connection, known, mark);
  if (!wanted) return std::unexpected(wanted.error());
  for (const Migration& migration : *wanted) {
    if (auto done = apply_in_transaction(connection, known, migration, mark); !done) return done;
  }
  return {};
}

Result<std::vector<Migration>> lacking(Connection& connection, std::span<const Migration> known, const Mark& mark) {
  const auto applied = applied_to(connection, mark);
  if (!applied) return std::unexpected(applied.error());
  if (auto fits = compare(*applied, known); !fits) return std::unexpected(fits.error());
  std::vector<Migration> wanted(known.begin(), known.end());
  std::erase_if(wanted, [&](const Migration& one) {
    return std::ranges::find(*applied, one.version, &Applied::version) != applied->end();
  });
  return wanted;
}

Result<std::uint32_t> schema_version(Connection& connection, const Mark& mark) {
  const auto applied = applied_to(connection, mark);
  if (!applied) return std::unexpected(applied.error());
  return applied->empty() ? 0 : applied->back().version;
}

}  // namespace dripfeed::sql
