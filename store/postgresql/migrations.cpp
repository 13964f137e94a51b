// The list of migrations, and what marks a database as a store of ours.
#include "store/postgresql/migrations.h"

#include <array>

#include "store/postgresql/schema_v1.h"
#include "store/postgresql/schema_v2.h"
#include "store/postgresql/schema_v3.h"
#include "store/postgresql/schema_v4.h"
#include "store/postgresql/schema_v5.h"
#include "store/postgresql/schema_v6.h"
#include "store/postgresql/schema_v7.h"
#include "store/sql/session.h"

namespace dripfeed::postgresql {
namespace {

using sql::Query;
using sql::Session;
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

constexpr sql::Mark kStore{.stands = is_marked, .sql = kMark};

}  // namespace

std::span<const sql::Migration> migrations() {
  static const std::array kMigrations{sql::Migration{1, "tables", kSchemaV1},
                                      sql::Migration{2, "rules", kSchemaV2},
                                      sql::Migration{3, "nodes", kSchemaV3},
                                      sql::Migration{4, "attachments", kSchemaV4},
                                      sql::Migration{5, "deleted programs", kSchemaV5},
                                      sql::Migration{6, "plans and ends of jobs", kSchemaV6},
                                      sql::Migration{7, "users of a provider", kSchemaV7}};
  return kMigrations;
}

Result<void> bring_up_to_date(Connection& connection, bool create) {
  if (!create) {
    const auto ours = is_marked(connection);
    if (!ours) return std::unexpected(ours.error());
    if (!*ours) return std::unexpected(store::Error{ErrorCode::cannot_open, "there is no store in the database"});
  }
  return sql::migrate(connection, migrations(), kStore);
}

Result<std::uint32_t> schema_version(Connection& connection) { return sql::schema_version(connection, kStore); }

}  // namespace dripfeed::postgresql
