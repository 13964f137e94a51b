// The list of migrations and how they are applied.
#include "store/sqlite/migrations.h"

#include <array>

#include "store/sql/session.h"
#include "store/sqlite/schema_v1.h"
#include "store/sqlite/schema_v10.h"
#include "store/sqlite/schema_v11.h"
#include "store/sqlite/schema_v12.h"
#include "store/sqlite/schema_v13.h"
#include "store/sqlite/schema_v14.h"
#include "store/sqlite/schema_v15.h"
#include "store/sqlite/schema_v16.h"
#include "store/sqlite/schema_v17.h"
#include "store/sqlite/schema_v18.h"
#include "store/sqlite/schema_v19.h"
#include "store/sqlite/schema_v20.h"
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
using store::ErrorCode;
using store::Result;

// "DRIP": stands in the file's header and distinguishes a store from any other SQLite file.
constexpr std::uint64_t kApplicationId = 0x44524950;
constexpr const char* kMark =
    "PRAGMA application_id = 0x44524950;"
    "CREATE TABLE migration (version INTEGER PRIMARY KEY, name TEXT NOT NULL, sha256 TEXT NOT NULL) STRICT;";

// Version 2: until when an arming lasts.
constexpr const char* kSchemaV2 =
    "ALTER TABLE job ADD COLUMN expires_at_ms INTEGER NOT NULL DEFAULT 0 CHECK (expires_at_ms >= 0);";

std::uint64_t one_number(Session& session, std::string_view sql) {
  Query query(session, sql);
  return query.next() ? query.number() : 0;
}

Result<bool> is_marked(sql::Connection& connection) {
  Session session(connection, "schema");
  const std::uint64_t id = one_number(session, "PRAGMA application_id");
  const std::uint64_t tables = one_number(session, "SELECT count(*) FROM sqlite_master");
  if (!session.ok()) return std::unexpected(session.error());
  if (id != kApplicationId && (id != 0 || tables != 0))
    return session.refuse(ErrorCode::not_a_store, "another program's file");
  return id == kApplicationId;
}

constexpr sql::Mark kStore{.stands = is_marked, .sql = kMark};

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
                                      Migration{14, "waivers of points", kSchemaV14},
                                      Migration{15, "attachments", kSchemaV15},
                                      Migration{16, "deleted programs", kSchemaV16},
                                      Migration{17, "plans and ends of jobs", kSchemaV17},
                                      Migration{18, "users of a provider", kSchemaV18},
                                      Migration{19, "rules of verdicts", kSchemaV19},
                                      Migration{20, "sign-off of operators", kSchemaV20}};
  return kMigrations;
}

Result<void> migrate(Connection& connection, std::span<const Migration> known) {
  return sql::migrate(connection, known, kStore);
}

Result<std::uint32_t> schema_version(Connection& connection) { return sql::schema_version(connection, kStore); }

}  // namespace dripfeed::sqlite
