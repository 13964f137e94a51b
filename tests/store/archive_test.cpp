// Backups as files of their own, and stores made from them: whole or not at all, and never over something else.
#include "store/sqlite/archive.h"

#include <algorithm>
#include <atomic>
#include <fstream>
#include <sstream>
#include <thread>

#include <fmt/format.h>

#include "store/sqlite/migrations.h"
#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

namespace fs = std::filesystem;
using namespace store;
using sqlite::back_up;
using sqlite::Holding;
using sqlite::restore;

constexpr bool kReplace = true;
constexpr bool kNothingThere = false;

class ArchiveTest : public StoreTest {
 protected:
  ArchiveTest() : job_(add_job(*store_, "mill-1").id), copy_(folder_.file("copy.backup")) {}

  static std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  static void write(const std::string& path, std::string_view bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
  static void expect_whole(const Holding& holding) {
    for (const sqlite::VerifyFault& fault : holding.found.faults) ADD_FAILURE() << fault.subject << ": " << fault.what;
  }
  // All names in the folder but those of the store itself.
  [[nodiscard]] std::vector<std::string> others() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(fs::path(path()).parent_path())) {
      const std::string name = entry.path().filename().string();
      if (name != "dripfeed.db" && name != "dripfeed.db-wal" && name != "dripfeed.db-shm" && name != "dripfeed.db.lock")
        names.push_back(name);
    }
    std::ranges::sort(names);
    return names;
  }
  using Names = std::vector<std::string>;

  Id job_;
  std::string copy_;
};

TEST_F(ArchiveTest, ABackupIsOneFileOfWhatTheStoreHolds) {
  reopen({.own = true, .checkpoints_aside = true});
  const Holding holding = must(back_up(path(), copy_));
  expect_whole(holding);
  EXPECT_EQ(holding.schema, sqlite::migrations().back().version);
  EXPECT_EQ(holding.machines, 1U);
  EXPECT_EQ(holding.programs, 1U);
  EXPECT_EQ(holding.releases, 1U);
  EXPECT_EQ(holding.found.jobs, 1U);
  EXPECT_EQ(holding.found.audit_head, must(store_->audit().verify()).head);
  EXPECT_EQ(holding.file_bytes, fs::file_size(copy_));
  EXPECT_EQ(others(), Names{"copy.backup"}) << "nothing is left beside it";
  EXPECT_EQ(fs::status(copy_).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(bytes_of(copy_).substr(18, 2), "\x01\x01") << "not WAL: it can be read where nothing can be written";
  EXPECT_EQ(refusal(back_up(path(), copy_)), ErrorCode::exists);
  EXPECT_EQ(refusal(back_up(path(), folder_.file("no/folder"))), ErrorCode::cannot_open);
  EXPECT_EQ(refusal(back_up(folder_.file("none.db"), folder_.file("x"))), ErrorCode::cannot_open);
  EXPECT_EQ(others(), Names{"copy.backup"});
}

// The copy takes many steps, and commits come between them: it is the state of its beginning all the same.
TEST_F(ArchiveTest, ABackupIsOfOneStateWhileMuchIsWritten) {
  const std::string text(std::size_t{3} << 20U, 'x');
  for (int i = 0; i < 8; ++i) must(store_->contents().put(fmt::format("{}{}", i, text)));
  reopen({.own = true, .checkpoints_aside = true});
  std::atomic<bool> over = false;
  std::atomic<int> written = 0;
  std::thread writer([&] {
    while (!over) {
      must(store_->machines().add(fmt::format("m{}", written.load()), "p", by("anna")));
      must(store_->contents().put(fmt::format("{} {}", written.load(), text.substr(0, 100'000))));
      ++written;
    }
  });
  std::uint64_t before = 0;
  for (int i = 0; i < 5; ++i) {
    const std::string copy = folder_.file(fmt::format("copy-{}", i));
    const int at_least = written;
    const Holding holding = must(back_up(path(), copy));
    expect_whole(holding);
    EXPECT_GE(holding.machines, static_cast<std::uint64_t>(at_least) + 1);
    EXPECT_GE(holding.machines, before);
    before = holding.machines;
  }
  over = true;
  writer.join();
  EXPECT_GT(written, 5);
}

TEST_F(ArchiveTest, AFaultIsNamedAndNoFileIsMade) {
  store_.reset();
  ASSERT_EQ(sql("DROP TRIGGER audit_update; UPDATE audit SET detail = 'another' WHERE seq = 2"), "");
  const Holding holding = must(back_up(path(), copy_));
  ASSERT_EQ(holding.found.faults.size(), 1U);
  EXPECT_EQ(holding.found.faults[0].subject, "audit/2");
  EXPECT_EQ(others(), Names{});
}

TEST_F(ArchiveTest, RestoredToANewPlaceItIsTheSame) {
  const Holding made = must(back_up(path(), copy_));
  bring(*store_, job_, JobState::feeding);
  fs::permissions(copy_, fs::perms::owner_read);
  const std::string elsewhere = folder_.file("elsewhere.db");
  const Holding holding = must(restore(copy_, elsewhere, kNothingThere));
  expect_whole(holding);
  EXPECT_EQ(holding.found.audit_head, made.found.audit_head);
  EXPECT_EQ(holding.kept, "");
  const auto store = must(sqlite::open(elsewhere, {.own = true}));
  EXPECT_EQ(must(store->jobs().get(job_)).state, JobState::queued);
  must(store->check());
  EXPECT_EQ(refusal(restore(copy_, elsewhere, kReplace)), ErrorCode::in_use) << "a server runs there";
}

TEST_F(ArchiveTest, AStoreIsReplacedOnlyWhenAskedAndIsKept) {
  must(back_up(path(), copy_));
  bring(*store_, job_, JobState::feeding);
  EXPECT_EQ(refusal(restore(copy_, path(), kNothingThere)), ErrorCode::exists);
  store_.reset();
  for (const char* name : {"dripfeed.db.replaced-1", "dripfeed.db.replaced-2"}) {
    const Holding holding = must(restore(copy_, path(), kReplace));
    EXPECT_EQ(holding.kept, folder_.file(name));
  }
  EXPECT_EQ(others(), (Names{"copy.backup", "dripfeed.db.replaced-1", "dripfeed.db.replaced-2"}));
  const auto old = must(sqlite::open(folder_.file("dripfeed.db.replaced-1"), {.create = false}));
  EXPECT_EQ(must(old->jobs().get(job_)).state, JobState::feeding);
  reopen({.own = true});
  EXPECT_EQ(must(store_->jobs().get(job_)).state, JobState::queued);
}

TEST_F(ArchiveTest, ARestoreThatCannotBeLeavesTheOldStore) {
  must(back_up(path(), copy_));
  bring(*store_, job_, JobState::feeding);
  store_.reset();
  EXPECT_EQ(refusal(restore(folder_.file("none"), path(), kReplace)), ErrorCode::cannot_open);
  const std::string text = folder_.file("text");
  write(text, std::string(8192, 'x'));
  EXPECT_EQ(refusal(restore(text, path(), kReplace)), ErrorCode::not_a_store);
  const std::string whole = bytes_of(copy_);
  const std::string half = folder_.file("half");
  write(half, whole.substr(0, whole.size() / 2 / 4096 * 4096));
  EXPECT_FALSE(restore(half, path(), kReplace));
  std::string damaged = whole;
  const std::size_t row = damaged.find("mill-1");
  ASSERT_NE(row, std::string::npos);
  for (std::size_t at = row; at != std::string::npos; at = damaged.find("mill-1", at)) damaged.replace(at, 6, "mill-X");
  const std::string altered = folder_.file("altered");
  write(altered, damaged);
  const auto found = restore(altered, path(), kReplace);
  EXPECT_TRUE(!found || !found->found.faults.empty()) << "the audit's chain and the indexes say another name";
  EXPECT_EQ(others(), (Names{"altered", "copy.backup", "half", "text"}));
  reopen();
  EXPECT_EQ(must(store_->jobs().get(job_)).state, JobState::feeding);
}

TEST_F(ArchiveTest, AnOlderSchemaIsKeptInABackupAndBroughtUpToDateByARestore) {
  store_.reset();
  for (const char* ending : {"", "-wal", "-shm"}) fs::remove(path() + ending);
  std::ifstream file(fmt::format("{}/tests/store/schema/v5.sql", DRIPFEED_SOURCE_DIR), std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  ASSERT_EQ(sql(text.str()), "");
  const Holding made = must(back_up(path(), copy_));
  expect_whole(made);
  EXPECT_EQ(made.schema, 5U);
  EXPECT_EQ(made.found.jobs, 1U);
  EXPECT_EQ(others(), Names{"copy.backup"});
  fs::remove(path());
  const Holding restored = must(restore(copy_, path(), kNothingThere));
  EXPECT_EQ(restored.schema, sqlite::migrations().back().version);
  reopen({.own = true});
  EXPECT_EQ(must(store_->jobs().on_line("mill-1")).value().state, JobState::held);
}

TEST_F(ArchiveTest, ANewerSchemaIsRefused) {
  store_.reset();
  ASSERT_EQ(sql("INSERT INTO migration VALUES (9999, 'from the future', 'x')"), "");
  EXPECT_EQ(refusal(back_up(path(), copy_)), ErrorCode::newer_schema);
  EXPECT_EQ(refusal(restore(path(), folder_.file("elsewhere.db"), kNothingThere)), ErrorCode::newer_schema);
  EXPECT_FALSE(fs::exists(folder_.file("elsewhere.db")));
}

}  // namespace
}  // namespace dripfeed::store_test
