// The list of migrations, and what marks a database as a store of ours.
#include "store/postgresql/migrations.h"

#include <array>
#include <chrono>
#include <thread>

#include <fmt/format.h>

#include "store/postgresql/lingering.h"
#include "store/postgresql/schema_v1.h"
#include "store/postgresql/schema_v10.h"
#include "store/postgresql/schema_v2.h"
#include "store/postgresql/schema_v3.h"
#include "store/postgresql/schema_v4.h"
#include "store/postgresql/schema_v5.h"
#include "store/postgresql/schema_v6.h"
#include "store/postgresql/schema_v7.h"
#include "store/postgresql/schema_v8.h"
#include "store/postgresql/schema_v9.h"
#include "store/sql/session.h"

namespace dripfeed::postgresql {
namespace {

using sql::Query;
using sql::Session;
using store::Error;
using store::ErrorCode;
using store::Result;

constexpr const char* kMark =
    "CREATE TABLE migration (version BIGINT PRIMARY KEY, name TEXT NOT NULL, sha256 TEXT NOT NULL);"
    "COMMENT ON TABLE migration IS 'dripfeed'";
constexpr std::string_view kOurs =
    "SELECT count(*) FROM pg_class WHERE relnamespace = CAST(current_schema() AS regnamespace) AND relname = "
    "'migration' "
    "AND obj_description(oid, 'pg_class') = 'dripfeed'";
constexpr std::string_view kTables =
    "SELECT count(*) FROM pg_class WHERE relnamespace = CAST(current_schema() AS regnamespace) AND relkind = 'r'";

std::uint64_t one_number(Session& session, std::string_view sql) {
  Query query(session, sql);
  return query.next() ? query.number() : 0;
}

Result<bool> is_marked(sql::Connection& connection) {
  Session session(connection, "schema");
  const bool ours = one_number(session, kOurs) > 0;
  const bool is_empty = one_number(session, kTables) == 0;
  if (!session.ok()) return std::unexpected(session.error());
  if (!ours && !is_empty) return session.refuse(ErrorCode::not_a_store, "another program's tables are there");
  return ours;
}

// The columns of version 8 may not be there: as JSON, a row has what it has.
constexpr sql::Mark kStore{
    .stands = is_marked,
    .sql = kMark,
    .applied =
        "SELECT version, sha256, coalesce(CAST(to_jsonb(m) ->> 'needs' AS BIGINT), version) FROM migration m "
        "ORDER BY version",
    .keep = "UPDATE migration SET needs = ? WHERE version = ?"};

// A node that runs has the lock of its name (see server.cpp).
constexpr std::string_view kTooOld =
    "SELECT name, program_version FROM node n WHERE coalesce(CAST(to_jsonb(n) ->> 'knows' AS BIGINT), 7) < ? AND "
    "EXISTS (SELECT 1 FROM pg_locks WHERE locktype = 'advisory' AND granted AND classid = 1146243409 AND "
    "objid = CAST(CAST(hashtext(n.name) AS BIGINT) & 4294967295 AS OID) AND pid <> pg_backend_pid() AND "
    "database = (SELECT oid FROM pg_database WHERE datname = current_database())) ORDER BY name LIMIT 1";

// A program that runs would meet tables that it does not know.
Result<void> refuse_too_old_nodes(Connection& connection, const sql::Migration& migration) {
  Session session(connection, "schema");
  Query query(session, kTooOld, migration.keeps == 0 ? migration.version : migration.keeps);
  if (query.next()) {
    const std::string node = query.text();
    return std::unexpected(Error{
        ErrorCode::migration_failed,
        fmt::format("schema {} ({}) is not for the program {} that node {} runs: update that node first, or stop it",
                    migration.version, migration.name, query.text(), node)});
  }
  if (!session.ok()) return std::unexpected(session.error());
  return {};
}

// A change of a table waits for those who use it, and whoever comes after it waits for it. So it waits for a moment
// only, lets the others pass, and comes again.
constexpr const char* kWaitBriefly = "SET lock_timeout = 300";
constexpr std::uint32_t kFirstWithNodes = 3;
constexpr int kAttempts = 100;
constexpr std::chrono::milliseconds kBetween{200};

Result<void> migrate_among_others(Connection& connection, std::span<const sql::Migration> known,
                                  std::uint32_t busy_timeout_ms) {
  if (auto set = connection.execute(kWaitBriefly); !set) return set;
  Result<void> done;
  for (int attempt = 1; attempt <= kAttempts; ++attempt) {
    done = sql::migrate(connection, known, kStore);
    if (done || done.error().code != ErrorCode::busy) break;
    std::this_thread::sleep_for(kBetween);
  }
  if (!done) return done;
  return connection.execute(fmt::format("SET lock_timeout = {}", busy_timeout_ms).c_str());
}

}  // namespace

std::span<const sql::Migration> migrations() {
  static const std::array kMigrations{sql::Migration{1, "tables", kSchemaV1},
                                      sql::Migration{2, "rules", kSchemaV2},
                                      sql::Migration{3, "nodes", kSchemaV3},
                                      sql::Migration{4, "attachments", kSchemaV4},
                                      sql::Migration{5, "deleted programs", kSchemaV5},
                                      sql::Migration{6, "plans and ends of jobs", kSchemaV6},
                                      sql::Migration{7, "users of a provider", kSchemaV7},
                                      sql::Migration{8, "neighbouring versions", kSchemaV8, 7},
                                      sql::Migration{9, "rules of verdicts", kSchemaV9, 7},
                                      sql::Migration{10, "sign-off of operators", kSchemaV10, 7}};
  return kMigrations;
}

Result<void> bring_up_to_date(Connection& connection, const OpenSettings& settings,
                              std::span<const sql::Migration> known) {
  const auto stands = is_marked(connection);
  if (!stands) return std::unexpected(stands.error());
  if (!*stands && !settings.create)
    return std::unexpected(Error{ErrorCode::cannot_open, "there is no store in the database"});
  const auto wanted = sql::lacking(connection, known, kStore);
  if (!wanted) return std::unexpected(wanted.error());
  if (wanted->empty()) return {};
  if (*stands && schema_version(connection).value_or(0) >= kFirstWithNodes) {
    for (const sql::Migration& migration : *wanted) {
      const auto fits =
          wait_for_the_ended(ErrorCode::migration_failed, [&] { return refuse_too_old_nodes(connection, migration); });
      if (!fits) return fits;
    }
  }
  return migrate_among_others(connection, known, settings.busy_timeout_ms);
}

Result<void> know_schema(Connection& connection) {
  const auto stands = is_marked(connection);
  if (!stands) return std::unexpected(stands.error());
  if (!*stands) return std::unexpected(Error{ErrorCode::cannot_open, "there is no store in the database"});
  const auto wanted = sql::lacking(connection, migrations(), kStore);
  if (!wanted) return std::unexpected(wanted.error());
  if (wanted->empty()) return {};
  return std::unexpected(Error{ErrorCode::migration_failed,
                               fmt::format("its schema is {}, this program's is {}",
                                           schema_version(connection).value_or(0), migrations().back().version)});
}

Result<std::uint32_t> schema_version(Connection& connection) { return sql::schema_version(connection, kStore); }

}  // namespace dripfeed::postgresql
