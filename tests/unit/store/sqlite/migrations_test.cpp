// The machinery of migrations with histories of its own: in order, once, whole or not at all.
#include "store/sqlite/migrations.h"

#include <array>
#include <vector>

#include <gtest/gtest.h>
#include <sqlite3.h>

#include "store/hash/sha256.h"
#include "store/sql/session.h"

namespace dripfeed::sqlite {
namespace {

using sql::Query;
using sql::Session;
using store::ErrorCode;

class Migrations : public ::testing::Test {
 protected:
  Migrations() {
    auto opened = Connection::open(":memory:", {}, Access::create);
    connection_ = std::move(opened.value());
  }
  std::uint64_t number(std::string_view sql) {
    Session session(*connection_, "test");
    Query query(session, sql);
    return query.next() ? query.number() : ~std::uint64_t{0};
  }
  std::uint32_t version() { return schema_version(*connection_).value(); }

  std::unique_ptr<Connection> connection_;
};

constexpr Migration kOne{1, "one", "CREATE TABLE a (x INTEGER); INSERT INTO a VALUES (1);"};
constexpr Migration kTwo{2, "two", "ALTER TABLE a ADD COLUMN y INTEGER NOT NULL DEFAULT 7; UPDATE a SET x = x + 1;"};
constexpr Migration kThree{3, "three", "CREATE TABLE b AS SELECT x + y AS z FROM a; DROP TABLE a;"};
constexpr Migration kBroken{2, "broken", "UPDATE a SET x = 99; CREATE TABLE a (x INTEGER);"};

TEST_F(Migrations, EachOldVersionIsBroughtUpWithItsRows) {
  const std::array all{kOne, kTwo, kThree};
  for (std::size_t old = 0; old <= all.size(); ++old) {
    connection_ = std::move(Connection::open(":memory:", {}, Access::create).value());
    ASSERT_TRUE(old == 0 || migrate(*connection_, std::span(all).first(old)));
    EXPECT_EQ(version(), old);
    ASSERT_TRUE(migrate(*connection_, all)) << "from " << old;
    EXPECT_EQ(version(), 3U);
    EXPECT_EQ(number("SELECT z FROM b"), 9U) << "from " << old;
    ASSERT_TRUE(migrate(*connection_, all)) << "again changes nothing";
    EXPECT_EQ(number("SELECT count(*) FROM migration"), 3U);
  }
}

TEST_F(Migrations, AFailedOneLeavesTheVersionBefore) {
  const std::array first{kOne};
  ASSERT_TRUE(migrate(*connection_, first));
  const std::array broken{kOne, kBroken};
  const auto refused = migrate(*connection_, broken);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::migration_failed);
  EXPECT_NE(refused.error().detail.find("broken"), std::string::npos);
  EXPECT_EQ(version(), 1U);
  EXPECT_EQ(number("SELECT x FROM a"), 1U) << "its first statement is undone";
  EXPECT_FALSE(connection_->in_transaction());
  const std::array good{kOne, kTwo};
  EXPECT_TRUE(migrate(*connection_, good));
}

TEST_F(Migrations, ANewerFileIsRefusedUntouched) {
  const std::array all{kOne, kTwo, kThree};
  ASSERT_TRUE(migrate(*connection_, all));
  const auto refused = migrate(*connection_, std::span(all).first(2));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::newer_schema);
  EXPECT_EQ(version(), 3U);
}

TEST_F(Migrations, AnotherHistoryIsRefused) {
  const std::array first{kOne};
  ASSERT_TRUE(migrate(*connection_, first));
  const std::array other{Migration{1, "one", "CREATE TABLE a (x TEXT)"}};
  const auto refused = migrate(*connection_, other);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::migration_failed);
}

TEST_F(Migrations, AnotherProgramsTablesAreRefused) {
  ASSERT_TRUE(connection_->execute("CREATE TABLE theirs (x)"));
  const std::array first{kOne};
  const auto refused = migrate(*connection_, first);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::not_a_store);
  EXPECT_EQ(number("SELECT count(*) FROM sqlite_master"), 1U);
}

TEST_F(Migrations, OursAreNumberedFromOneWithoutGaps) {
  std::uint32_t expected = 0;
  for (const Migration& migration : migrations()) {
    EXPECT_EQ(migration.version, ++expected);
    EXPECT_FALSE(migration.name.empty());
  }
  EXPECT_GE(expected, 1U);
}

// With 50,000 jobs of a machine, walking them all took 13 ms for each machine of a list.
TEST_F(Migrations, TheTornJobOfAMachineIsFoundByItsIndex) {
  ASSERT_TRUE(migrate(*connection_, migrations()));
  Session session(*connection_, "plan");
  Query query(session,
              "EXPLAIN QUERY PLAN SELECT * FROM job WHERE machine = ? AND torn = 1 AND confirmed_at_ms = 0 ORDER BY id "
              "DESC LIMIT 1",
              "mill");
  ASSERT_TRUE(query.next());
  for (int skipped = 0; skipped < 3; ++skipped) query.number();
  EXPECT_NE(query.text().find("USING INDEX job_torn (machine=? AND torn=? AND confirmed_at_ms=?)"), std::string::npos);
  EXPECT_FALSE(query.next()) << "one step";
}

}  // namespace
}  // namespace dripfeed::sqlite
