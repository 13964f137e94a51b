// Parameters in and columns out, the fault that sticks, statements inside themselves, and the table of result codes.
#include "store/sql/session.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include "store/sql/paging.h"
#include "store/sqlite/connection.h"
#include "store/sqlite/fault.h"

namespace dripfeed::sqlite {
namespace {

using sql::Bytes;
using sql::newest_first;
using sql::NumberOrNull;
using sql::oldest_first;
using sql::OrNull;
using sql::Query;
using sql::rows_of;
using sql::Session;
using store::ErrorCode;

class SessionTest : public ::testing::Test {
 protected:
  SessionTest() : connection_(std::move(Connection::open(":memory:", {}, Access::create).value())) {
    EXPECT_TRUE(connection_->execute("CREATE TABLE t (a INTEGER, b TEXT, c BLOB)"));
  }
  std::unique_ptr<Connection> connection_;
};

TEST_F(SessionTest, WhatGoesInComesOut) {
  Session session(*connection_, "test");
  const std::string text("a\0b", 3);
  const std::string all_bytes("\x00\x80\xff", 3);
  EXPECT_TRUE(session.run("INSERT INTO t VALUES (?, ?, ?)", std::int64_t{-5}, text, Bytes{all_bytes}));
  EXPECT_TRUE(session.run("INSERT INTO t VALUES (?, ?, ?)", 7U, store::Delivery::memory, Bytes{}));
  EXPECT_TRUE(session.run("INSERT INTO t VALUES (?, ?, ?)", NumberOrNull{0}, OrNull{""}, OrNull{"x"}));
  Query query(session, "SELECT a, b, c FROM t ORDER BY rowid");
  ASSERT_TRUE(query.next());
  EXPECT_EQ(query.signed_number(), -5);
  EXPECT_EQ(query.text(), text);
  EXPECT_EQ(query.text(), all_bytes);
  ASSERT_TRUE(query.next());
  EXPECT_EQ(query.number(), 7U);
  EXPECT_EQ(query.value<store::Delivery>(), store::Delivery::memory);
  EXPECT_TRUE(query.bytes().empty());
  ASSERT_TRUE(query.next());
  EXPECT_EQ(query.number(), 0U);
  EXPECT_EQ(query.text(), "");
  EXPECT_EQ(query.text(), "x");
  EXPECT_FALSE(query.next());
  EXPECT_TRUE(session.ok());
}

TEST_F(SessionTest, EmptyTextIsNotNull) {
  Session session(*connection_, "test");
  EXPECT_TRUE(session.run("INSERT INTO t VALUES (1, ?, ?)", std::string_view(), Bytes{}));
  Query query(session, "SELECT b IS NULL, c IS NULL FROM t");
  ASSERT_TRUE(query.next());
  EXPECT_FALSE(query.flag());
  EXPECT_FALSE(query.flag());
}

TEST_F(SessionTest, TheFirstFaultSticks) {
  Session session(*connection_, "a row");
  EXPECT_FALSE(session.run("INSERT INTO missing VALUES (1)"));
  EXPECT_FALSE(session.run("INSERT INTO t VALUES (1, 'b', NULL)"));
  Query query(session, "SELECT count(*) FROM t");
  EXPECT_FALSE(query.next());
  EXPECT_EQ(query.number(), 0U);
  EXPECT_EQ(query.text(), "");
  EXPECT_EQ(session.error().detail, "a row: no such table: missing");
  Session again(*connection_, "test");
  Query after(again, "SELECT count(*) FROM t");
  ASSERT_TRUE(after.next());
  EXPECT_EQ(after.number(), 0U) << "nothing was done after the fault";
}

TEST_F(SessionTest, AnUnknownNameIsDamage) {
  Session session(*connection_, "test");
  EXPECT_TRUE(session.run("INSERT INTO t VALUES (1, 'pigeon', NULL)"));
  Query query(session, "SELECT b FROM t");
  ASSERT_TRUE(query.next());
  static_cast<void>(query.value<store::Delivery>());
  EXPECT_FALSE(session.ok());
  EXPECT_EQ(session.error().code, ErrorCode::corrupt);
}

TEST_F(SessionTest, EveryConnectionKeepsTheRulesOfTheStore) {
  Session session(*connection_, "test");
  const auto setting = [&](std::string_view sql) {
    Query query(session, sql);
    return query.next() ? query.number() : 99;
  };
  EXPECT_EQ(setting("PRAGMA foreign_keys"), 1U);
  EXPECT_EQ(setting("PRAGMA synchronous"), 2U) << "FULL";
  EXPECT_EQ(setting("PRAGMA recursive_triggers"), 1U);
  EXPECT_EQ(setting("PRAGMA trusted_schema"), 0U);
  EXPECT_EQ(setting("PRAGMA busy_timeout"), OpenSettings{}.busy_timeout_ms);
}

TEST_F(SessionTest, AStatementMayRunInsideItself) {
  Session session(*connection_, "test");
  for (unsigned i = 1; i <= 3; ++i) session.run("INSERT INTO t (a) VALUES (?)", i);
  constexpr std::string_view kAll = "SELECT a FROM t ORDER BY a";
  std::uint64_t sum = 0;
  Query outer(session, kAll);
  while (outer.next()) {
    const std::uint64_t a = outer.number();
    Query inner(session, kAll);
    while (inner.next()) sum += a * inner.number();
  }
  EXPECT_EQ(sum, 36U);
}

TEST(FaultTable, NamesTheCodesThatMatter) {
  EXPECT_EQ(code_of(SQLITE_FULL), ErrorCode::disk_full);
  EXPECT_EQ(code_of(SQLITE_IOERR_WRITE), ErrorCode::io_failed);
  EXPECT_EQ(code_of(SQLITE_IOERR_FSYNC), ErrorCode::io_failed);
  EXPECT_EQ(code_of(SQLITE_BUSY_SNAPSHOT), ErrorCode::busy);
  EXPECT_EQ(code_of(SQLITE_CORRUPT_INDEX), ErrorCode::corrupt);
  EXPECT_EQ(code_of(SQLITE_NOTADB), ErrorCode::not_a_store);
  EXPECT_EQ(code_of(SQLITE_CANTOPEN_ISDIR), ErrorCode::cannot_open);
  EXPECT_EQ(code_of(SQLITE_CONSTRAINT_UNIQUE), ErrorCode::exists);
  EXPECT_EQ(code_of(SQLITE_CONSTRAINT_FOREIGNKEY), ErrorCode::broken_reference);
  EXPECT_EQ(code_of(SQLITE_CONSTRAINT_TRIGGER), ErrorCode::append_only);
  EXPECT_EQ(code_of(SQLITE_CONSTRAINT_CHECK), ErrorCode::invalid_value);
  EXPECT_EQ(code_of(SQLITE_MISUSE), ErrorCode::internal);
}

TEST(Paging, LimitsAndCursors) {
  EXPECT_EQ(rows_of({.limit = 1, .after = {}}).value(), 2U);
  EXPECT_FALSE(rows_of({.limit = 0, .after = {}}));
  EXPECT_FALSE(rows_of({.limit = store::kPageLimitMax + 1, .after = {}}));
  EXPECT_EQ(oldest_first({.limit = 1, .after = "17"}).value().after, 17U);
  EXPECT_GT(newest_first({.limit = 1, .after = {}}).value().after, std::uint64_t{1} << 62U);
  EXPECT_FALSE(newest_first({.limit = 1, .after = "17 "}));
}

}  // namespace
}  // namespace dripfeed::sqlite
