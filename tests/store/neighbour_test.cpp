// Programs of neighbouring versions on one database: what an older one does when a newer one has changed the tables,
// and when a newer one may change them.
#include <thread>

#include <fmt/format.h>

#include "store/postgresql/connection.h"
#include "store/postgresql/migrations.h"
#include "store/postgresql/open.h"
#include "store/postgresql/verify.h"
#include "tests/store/fixture.h"
#include "tests/store/postgresql_server.h"

namespace dripfeed::store_test {
namespace {

using namespace store;
using namespace std::chrono_literals;
using postgresql::OpenSettings;

const std::uint32_t kOurs = postgresql::migrations().back().version;

class PostgresqlNeighbours : public StoreTest {
 protected:
  PostgresqlNeighbours() {
    EXPECT_EQ(engine(), EngineKind::postgresql);
    store_.reset();
  }
  [[nodiscard]] Result<std::unique_ptr<Store>> open_node(const std::string& name) const {
    return postgresql::open(database_url(database_), {.own = true, .node = name});
  }
  // What the newest program, which has one more migration than this, does at its start.
  [[nodiscard]] Result<void> start_newer(std::uint32_t keeps, const char* change) const {
    std::vector<sql::Migration> known(postgresql::migrations().begin(), postgresql::migrations().end());
    known.push_back({.version = kOurs + 1, .name = "the next", .sql = change, .keeps = keeps});
    const OpenSettings settings;
    const auto connection = must(postgresql::Connection::open(database_url(database_), settings));
    return postgresql::bring_up_to_date(*connection, settings, known);
  }
};

constexpr const char* kAdds = "ALTER TABLE program ADD COLUMN color bytewise NOT NULL DEFAULT 'red'";
constexpr const char* kTakesAway = "ALTER TABLE program DROP COLUMN folder CASCADE";

TEST_F(PostgresqlNeighbours, ANodeGoesOnAndStartsWhereANewerOneAddsAColumn) {
  auto older = must(open_node("hall-1"));
  must(start_newer(kOurs, kAdds));
  add_job(*older, "mill-1");
  must(older->check());
  EXPECT_TRUE(must(postgresql::verify(database_url(database_))).faults.empty());
  older.reset();
  older = must(open_node("hall-1"));
  add_program(*older, "%\nM30\n%\n");
  EXPECT_EQ(sql(fmt::format("DO $$ BEGIN ASSERT (SELECT max(version) FROM migration) = {}; END $$", kOurs + 1)), "")
      << "an older program leaves the newer tables alone";
}

TEST_F(PostgresqlNeighbours, AnOlderProgramDoesNotStartWhereItMustKnowMore) {
  must(start_newer(0, kTakesAway));
  const auto refused = open_node("hall-1");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::newer_schema);
  EXPECT_EQ(refusal(postgresql::verify(database_url(database_))), ErrorCode::newer_schema);
}

TEST_F(PostgresqlNeighbours, NoTableIsTakenFromANodeThatRuns) {
  auto older = must(open_node("hall-1"));
  const auto refused = start_newer(0, kTakesAway);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::migration_failed);
  EXPECT_NE(refused.error().detail.find("node hall-1"), std::string::npos) << refused.error().detail;
  add_program(*older, "%\nM30\n%\n");
  const std::jthread ends([&] {
    std::this_thread::sleep_for(300ms);
    older.reset();
  });
  must(start_newer(0, kTakesAway));
}

TEST_F(PostgresqlNeighbours, ANodeOfTheFirstProgramsKeepsWorking) {
  auto older = must(open_node("hall-1"));
  // As a program before version 8 has it; it knows 7.
  EXPECT_EQ(sql("DELETE FROM migration WHERE version > 7; ALTER TABLE migration DROP COLUMN needs; "
                "ALTER TABLE node DROP COLUMN knows; ALTER TABLE verdict DROP COLUMN rules CASCADE; "
                "ALTER TABLE machine_group DROP COLUMN operator_sign_off; DROP INDEX job_release; "
                "ALTER TABLE job DROP COLUMN hold_by, DROP COLUMN hold_reason, DROP COLUMN retry_of"),
            "");
  const auto newer = must(open_node("hall-2"));
  add_job(*older, "mill-1");
  add_job(*newer, "mill-2");
  EXPECT_EQ(refusal(start_newer(8, kAdds)), ErrorCode::migration_failed) << "hall-1 knows 7";
}

TEST_F(PostgresqlNeighbours, AChangeOfTablesWaitsForItsMomentAndKeepsNoOneWaiting) {
  auto older = must(open_node("hall-1"));
  const auto reader = must(postgresql::Connection::open(database_url(database_), {}));
  must(reader->transact("BEGIN"));
  must(reader->execute("SELECT count(*) FROM program"));
  Result<void> done;
  std::jthread newer([&] { done = start_newer(kOurs, kAdds); });
  const auto until = std::chrono::steady_clock::now() + 2s;
  std::chrono::steady_clock::duration longest{};
  while (std::chrono::steady_clock::now() < until) {
    const auto begun = std::chrono::steady_clock::now();
    must(older->programs().list({}));
    longest = std::max(longest, std::chrono::steady_clock::now() - begun);
  }
  EXPECT_LT(longest, 1s) << "who comes after the change waits for it";
  must(reader->transact("COMMIT"));
  newer.join();
  must(done);
}

}  // namespace
}  // namespace dripfeed::store_test
