// Every change fails at every n-th write, sync, truncation and removal. What the next start finds is the state before
// the change or the one after it, never one between; and an error is reported as what it was.
#include <functional>
#include <set>

#include <fmt/format.h>
#include <sqlite3.h>

#include "store/hash/sha256.h"
#include "tests/store/failing_vfs.h"
#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

using namespace store;

// A hash over all rows of all tables.
std::string digest(const std::string& path) {
  sqlite3* connection = nullptr;
  sqlite3_open(path.c_str(), &connection);
  hash::Sha256 hash;
  const auto each = [&](const std::string& query, const std::function<void(sqlite3_stmt*)>& row) {
    sqlite3_stmt* statement = nullptr;
    EXPECT_EQ(sqlite3_prepare_v2(connection, query.c_str(), -1, &statement, nullptr), SQLITE_OK) << query;
    while (sqlite3_step(statement) == SQLITE_ROW) row(statement);
    sqlite3_finalize(statement);
  };
  std::vector<std::string> tables;
  each("SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name",
       [&](sqlite3_stmt* row) { tables.emplace_back(reinterpret_cast<const char*>(sqlite3_column_text(row, 0))); });
  for (const std::string& table : tables) {
    hash.add(table);
    each(fmt::format("SELECT * FROM {} ORDER BY 1, 2", table), [&](sqlite3_stmt* row) {
      for (int i = 0; i < sqlite3_column_count(row); ++i) {
        const void* data = sqlite3_column_blob(row, i);
        const auto size = static_cast<std::size_t>(sqlite3_column_bytes(row, i));
        hash.add(fmt::format("{}:", size));
        hash.add(std::string_view(static_cast<const char*>(data), size));
      }
    });
  }
  sqlite3_close(connection);
  return hash.hex();
}

using Change = std::function<Result<void>(Store&)>;

template <class T>
Result<void> no_value(const Result<T>& result) {
  if (!result) return std::unexpected(result.error());
  return {};
}

class FailTest : public ::testing::TestWithParam<Fault> {
 protected:
  static constexpr std::uint64_t kMost = 2000;  // no change here takes as many steps

  FailTest() { register_failing_vfs(); }
  ~FailTest() override { fail_at(0, Fault::once); }

  [[nodiscard]] std::string base() const { return folder_.file("base.db"); }
  [[nodiscard]] std::string path() const { return folder_.file("tried.db"); }

  void copy_base() const {
    for (const char* ending : {"", "-wal", "-shm", ".lock"}) std::filesystem::remove(path() + ending);
    if (std::filesystem::exists(base())) std::filesystem::copy_file(base(), path());
  }
  // The state that the next start of the server finds.
  std::string state_after_restart() const {
    {
      must(must(sqlite::open(path(), {.own = true}))->check());
    }
    return digest(path());
  }
  // Runs the change with the fault at step 1, 2, 3, … (or every stride-th of them) until it meets none.
  void try_everywhere(const Change& change, std::uint64_t stride = 1) {
    copy_base();
    const std::string before = state_after_restart();
    must(change(*must(sqlite::open(path()))));
    const std::string after = state_after_restart();
    ASSERT_NE(before, after);
    std::uint64_t steps = 1;
    std::uint64_t reported = 0;
    bool met = true;
    for (; met && steps < kMost; steps += stride) {
      copy_base();
      Result<void> result;
      {
        const auto store = must(sqlite::open(path(), {.vfs = kFailingVfs}));
        fail_at(steps, GetParam());
        result = change(*store);
        // Closing the store has its own steps: the checkpoint.
      }
      met = failed();
      fail_at(0, GetParam());
      const std::string found = state_after_restart();
      ASSERT_TRUE(found == before || found == after) << "between, at step " << steps;
      if (result) {
        ASSERT_EQ(found, after) << "it was acknowledged, at step " << steps;
      } else {
        ++reported;
        const ErrorCode expected = GetParam() == Fault::full_for_good ? ErrorCode::disk_full : ErrorCode::io_failed;
        ASSERT_EQ(result.error().code, expected) << message_of(result.error());
      }
    }
    ASSERT_LT(steps, kMost);
    EXPECT_GT(reported, 0U) << "no step was one of the change itself";
  }

  TempFolder folder_{TempFolder::Where::memory};
};

TEST_P(FailTest, MachineChangeWithStaleVerdicts) {
  {
    const auto store = must(sqlite::open(base()));
    add_job(*store, "mill-1");
  }
  try_everywhere([](Store& store) {
    return no_value(store.machines().change("mill-1", 1, std::string(10'000, 'p'), by("anna", 5)));
  });
}

TEST_P(FailTest, UploadOfALargeProgram) {
  try_everywhere(
      [](Store& store) -> Result<void> {
        const auto content = store.contents().put(std::string(1'100'000, 'x'));  // two transactions
        if (!content) return no_value(content);
        NewProgramText text;
        text.sha256 = content->sha256;
        return no_value(store.programs().add("O1", "fanuc", text, by("anna", 5)));
      },
      23);  // a page is a step
}

TEST_P(FailTest, JobAndReleaseTogether) {
  Id release = 0;
  {
    const auto store = must(sqlite::open(base()));
    must(store->machines().add("mill-1", "p", by("anna")));
    const Program program = add_program(*store, "text");
    add_verdict(*store, program, "mill-1");
    release = must(store->releases().add({program.id, 1, "mill-1", Delivery::drip}, by("anna"))).id;
    must(store->releases().move(release, {ReleaseState::in_review, "", 0}, by("anna")));
  }
  try_everywhere([release](Store& store) {
    return store.atomically([&]() -> Result<void> {
      const auto moved = store.releases().move(release, {ReleaseState::proving, "", 3}, by("anna", 6));
      if (!moved) return no_value(moved);
      const auto job = store.jobs().add({release, "link", 10}, by("anna", 7));
      if (!job) return no_value(job);
      const auto armed = store.jobs().move(job->id, {JobState::armed, "", false}, by("olga", 8));
      if (!armed) return no_value(armed);
      return store.replies().keep({"mes", "r", "k", "x"}, {201, "", "body", 9});
    });
  });
}

TEST_P(FailTest, LedgerCommitOfManyLines) {
  std::vector<NewLedgerRow> rows;
  {
    const auto store = must(sqlite::open(base()));
    const Job first = add_job(*store, "mill-1");
    for (int i = 0; i < 60; ++i) {
      const Job job = must(store->jobs().add({first.release, "link", 10}, by("anna")));
      rows.push_back({job.id, {0, 0, 0, 100}, std::string(200, 'n')});
    }
  }
  try_everywhere([&rows](Store& store) { return no_value(store.ledger().append(rows, 5)); });
}

TEST_P(FailTest, InterruptingAtTheStart) {
  {
    const auto store = must(sqlite::open(base()));
    for (int i = 0; i < 4; ++i) bring(*store, add_job(*store, fmt::format("mill-{}", i)).id, JobState::feeding);
  }
  try_everywhere([](Store& store) { return no_value(store.jobs().interrupt_unfinished(by("server", 9))); });
}

// Making a new store: whatever step fails, the next start makes it or finds it whole.
// A new store takes some hundred steps, and each is tried by one of the three kinds of fault.
TEST_P(FailTest, ANewStore) {
  constexpr std::uint64_t kKinds = 3;
  bool met = true;
  std::uint64_t steps = 1 + static_cast<std::uint64_t>(GetParam());
  for (; met && steps < kMost; steps += kKinds) {
    copy_base();
    fail_at(steps, GetParam());
    {
      const auto store = sqlite::open(path(), {.own = true, .vfs = kFailingVfs});
      EXPECT_TRUE(!store || (*store)->machines().list({}));
    }
    met = failed();
    fail_at(0, GetParam());
    const auto store = sqlite::open(path(), {.own = true});
    ASSERT_TRUE(store) << "step " << steps << ": " << message_of(store.error());
    must((*store)->machines().add("mill-1", "p", by("anna")));
    must((*store)->check());
  }
  ASSERT_GT(steps, 5U);
  ASSERT_LT(steps, kMost);
}

// A full disk stops changes, not the store: with room again it goes on.
TEST_P(FailTest, TheStoreGoesOnAfterwards) {
  const auto store = must(sqlite::open(path(), {.vfs = kFailingVfs}));
  must(store->machines().add("mill-1", "p1", by("anna")));
  fail_at(1, GetParam());
  EXPECT_FALSE(store->machines().change("mill-1", 1, "p2", by("anna")));
  EXPECT_EQ(must(store->machines().get("mill-1")).profile, "p1") << "reading goes on";
  // Inside a transaction, what follows the fault must not stand alone.
  fail_at(1, GetParam());
  const auto grouped = store->atomically([&]() -> Result<void> {
    const auto large = store->families().add("large", std::string(20'000'000, 'x'), by("anna"));
    EXPECT_FALSE(large) << "more than the cache holds is written before the commit";
    fail_at(0, GetParam());
    static_cast<void>(store->machines().add("mill-2", "p", by("anna")));
    return {};
  });
  const bool alone = store->machines().get("mill-2").has_value();
  EXPECT_EQ(grouped.has_value(), alone);
  fail_at(0, GetParam());
  must(store->machines().change("mill-1", 1, "p2", by("anna")));
  must(store->check());
  EXPECT_EQ(must(store->audit().verify()).first_broken, std::nullopt);
}

INSTANTIATE_TEST_SUITE_P(Faults, FailTest, ::testing::Values(Fault::full_for_good, Fault::lost_for_good, Fault::once),
                         [](const ::testing::TestParamInfo<Fault>& fault) -> std::string {
                           switch (fault.param) {
                             case Fault::full_for_good: return "Full";
                             case Fault::lost_for_good: return "Lost";
                             case Fault::once: return "Once";
                           }
                           return "";
                         });

}  // namespace
}  // namespace dripfeed::store_test
