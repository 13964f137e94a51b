// A database of every old schema of PostgreSQL, with a shop in it, is brought up to date and read. The rows are those
// that SQLite's schema of the same time had: the tables of the two engines have the same columns.
#include <fmt/format.h>

#include "store/postgresql/filling.h"
#include "store/postgresql/migrations.h"
#include "store/postgresql/open.h"
#include "store/postgresql/verify.h"
#include "store/sqlite/connection.h"
#include "tests/store/fixture.h"
#include "tests/store/old_shop.h"
#include "tests/store/postgresql_server.h"

namespace dripfeed::store_test {
namespace {

using namespace store;

class PostgresqlUpgrade : public StoreTest {};

// By version of the database, from 1: the schema of SQLite with the same tables.
constexpr std::array<std::uint32_t, 10> kSameTables{14, 14, 14, 15, 16, 17, 18, 18, 19, 20};

TEST_F(PostgresqlUpgrade, AShopOfEveryOldSchemaIsReadByThisProgram) {
  const auto all = postgresql::migrations();
  ASSERT_EQ(all.size(), kSameTables.size()) << "a new schema has a row in the table above";
  for (std::size_t n = 1; n <= all.size(); ++n) {
    const std::uint32_t of_file = kSameTables.at(n - 1);
    SCOPED_TRACE(fmt::format("schema {}, with the rows of SQLite's {}", n, of_file));
    const std::string name = fmt::format("upgrade_{}", n);
    make_database(name);
    const std::string url = database_url(name);
    const TempFolder folder(TempFolder::Where::memory);
    {
      const auto old = must(sqlite::Connection::open(folder.file("old.db"), {}, sqlite::Access::create));
      must(old->execute(old_shop(of_file).c_str()));
      must(postgresql::fill(url, *old, all.first(n)));
    }
    const auto store = must(postgresql::open(url, {.own = true}));
    EXPECT_TRUE(must(postgresql::verify(url)).faults.empty());
    expect_old_shop(*store, of_file);
    EXPECT_EQ(run_sql(name, "DELETE FROM audit"), "append-only");
  }
}

}  // namespace
}  // namespace dripfeed::store_test
