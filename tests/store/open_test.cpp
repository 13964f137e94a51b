// Opening and owning: what is refused, and that a refusal changes nothing.
#include <fstream>

#include <fmt/format.h>

#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

using namespace store;

class OpenTest : public StoreTest {
 protected:
  static std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  static void write(const std::string& path, std::string_view bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
};

TEST_F(OpenTest, AMissingFileIsMadeOnlyWhenAsked) {
  EXPECT_EQ(refusal(sqlite::open(folder_.file("none.db"), {.create = false})), ErrorCode::cannot_open);
  EXPECT_FALSE(std::filesystem::exists(folder_.file("none.db")));
  EXPECT_EQ(refusal(sqlite::open(folder_.file("no/such/folder.db"))), ErrorCode::cannot_open);
  EXPECT_EQ(refusal(sqlite::open(folder_.file("no/such/folder.db"), {.own = true})), ErrorCode::cannot_open);
  must(sqlite::open(folder_.file("none.db")));
  must(sqlite::open(folder_.file("none.db"), {.create = false}));
}

TEST_F(OpenTest, OtherFilesAreLeftAlone) {
  const std::string text = folder_.file("text.db");
  write(text, "this is not a database, but a long enough text to be read as the header of one, which it is not at all");
  const std::string before = bytes_of(text);
  EXPECT_EQ(refusal(sqlite::open(text)), ErrorCode::not_a_store);
  EXPECT_EQ(bytes_of(text), before);
  store_.reset();
  EXPECT_EQ(sql("PRAGMA journal_mode = DELETE; PRAGMA application_id = 7"), "");
  const std::string foreign = bytes_of(path());
  EXPECT_EQ(refusal(sqlite::open(path())), ErrorCode::not_a_store);
  EXPECT_EQ(bytes_of(path()), foreign) << "another program's database";
  EXPECT_EQ(sql("PRAGMA application_id = 0"), "");
  EXPECT_EQ(refusal(sqlite::open(path())), ErrorCode::not_a_store);
}

TEST_F(OpenTest, TheFileIsInWalMode) {
  must(store_->machines().add("mill-1", "p", by("anna")));
  EXPECT_TRUE(std::filesystem::exists(path() + "-wal"));
}

TEST_F(OpenTest, ANewerSchemaIsRefused) {
  must(store_->machines().add("mill-1", "p", by("anna")));
  store_.reset();
  EXPECT_EQ(sql("INSERT INTO migration VALUES (9999, 'from the future', 'x')"), "");
  const auto refused = open_second();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::newer_schema);
  EXPECT_NE(refused.error().detail.find("9999"), std::string::npos);
  EXPECT_EQ(sql("DELETE FROM migration WHERE version = 9999"), "");
  reopen();
  EXPECT_EQ(must(store_->machines().get("mill-1")).profile, "p");
}

TEST_F(OpenTest, ASchemaOfAnotherHistoryIsRefused) {
  store_.reset();
  EXPECT_EQ(sql("UPDATE migration SET sha256 = 'other' WHERE version = 1"), "");
  EXPECT_EQ(refusal(open_second()), ErrorCode::migration_failed);
}

TEST_F(OpenTest, OneOwner) {
  reopen({.own = true});
  EXPECT_EQ(refusal(open_second({.own = true})), ErrorCode::in_use);
  const auto guest = must(open_second());
  must(guest->tokens().add({.name = "mes", .role = Role::viewer, .hash = "hash"}, by("anna")));
  EXPECT_EQ(must(store_->tokens().find("hash")).name, "mes") << "the owner sees a guest's change";
  store_.reset();
  reopen({.own = true});
}

TEST_F(OpenTest, AnotherProcessHoldsTheLockTooLong) {
  const auto guest = must(open_second({.busy_timeout_ms = 20}));
  must(store_->atomically([&]() -> Result<void> {
    EXPECT_EQ(refusal(store_->machines().get("mill-1")), ErrorCode::not_found);
    EXPECT_EQ(refusal(guest->machines().add("mill-2", "p", by("anna"))), ErrorCode::busy)
        << "what was read stays true until the end, so the lock is held before the first change";
    must(store_->machines().add("mill-1", "p", by("anna")));
    EXPECT_EQ(refusal(guest->machines().get("mill-1")), ErrorCode::not_found) << "reading does not wait";
    return {};
  }));
  must(guest->machines().add("mill-2", "p", by("anna")));
}

TEST_F(OpenTest, ItsFilesAreForTheirOwnerAlone) {
  namespace fs = std::filesystem;
  constexpr fs::perms kOwner = fs::perms::owner_read | fs::perms::owner_write;
  must(store_->machines().add("m", "p", by("anna")));
  for (const char* ending : {"", "-wal", "-shm"})
    EXPECT_EQ(fs::status(path() + ending).permissions(), kOwner) << ending;
  const std::string copy = folder_.file("copy.db");
  must(store_->backup(copy));
  EXPECT_EQ(fs::status(copy).permissions(), kOwner);
  fs::permissions(copy, kOwner | fs::perms::group_read | fs::perms::others_read);
  must(sqlite::open(copy));
  EXPECT_EQ(fs::status(copy).permissions(), kOwner) << "an older version made it readable";
}

// One damaged page of many, which opening does not touch.
TEST_F(OpenTest, DamageIsFound) {
  must(store_->atomically([&]() -> Result<void> {
    for (int i = 0; i < 200; ++i)
      must(store_->machines().add(fmt::format("m{}", i), std::string(500, 'p'), by("anna")));
    return {};
  }));
  must(store_->check());
  const std::string copy = folder_.file("copy.db");
  must(store_->backup(copy));
  std::string bytes = bytes_of(copy);
  const std::size_t page = bytes.find(std::string(200, 'p'));
  ASSERT_NE(page, std::string::npos);
  bytes.replace(page / 4096 * 4096, 200, 200, '\x7f');
  write(copy, bytes);
  EXPECT_EQ(refusal(must(sqlite::open(copy))->check()), ErrorCode::corrupt);
}

}  // namespace
}  // namespace dripfeed::store_test
