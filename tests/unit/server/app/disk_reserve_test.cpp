// A full disk: what runs is booked to its end in the room that was kept for it, nothing new begins, and with room again
// all is as before. The disk is full here as long as the reserve lies on it.
#include "server/app/base/disk_reserve.h"

#include <chrono>

#include <sys/stat.h>

#include "tests/unit/server/app/whole_shop.h"

namespace dripfeed::app {
namespace {

using namespace std::chrono_literals;
using namespace test;
using store::JobState;

constexpr std::uint64_t kSmall = std::uint64_t{1} << 20U;

class DiskReserveTest : public ShopTest {
 protected:
  [[nodiscard]] std::string path() const { return folder_.file("disk-reserve"); }
  [[nodiscard]] bool is_there() const { return std::filesystem::exists(path()); }
};

TEST_F(DiskReserveTest, HoldsItsRoomAndGivesItOnce) {
  DiskReserve disk_reserve(path(), kSmall);
  ASSERT_TRUE(disk_reserve.is_whole());
  struct stat file{};
  ASSERT_EQ(::stat(path().c_str(), &file), 0);
  EXPECT_GE(static_cast<std::uint64_t>(file.st_blocks) * 512, kSmall) << "blocks of its own, not only a length";
  EXPECT_TRUE(refuse_on_full_disk(&disk_reserve));
  EXPECT_TRUE(refuse_on_full_disk(nullptr));
  EXPECT_TRUE(disk_reserve.give_up());
  EXPECT_FALSE(is_there());
  EXPECT_FALSE(disk_reserve.is_whole());
  EXPECT_FALSE(disk_reserve.give_up()) << "there is nothing left to give";
  EXPECT_EQ(refusal(refuse_on_full_disk(&disk_reserve)).code, ErrorCode::unavailable);
  disk_reserve.restore();
  EXPECT_TRUE(disk_reserve.is_whole());
  EXPECT_TRUE(is_there());
}

TEST_F(DiskReserveTest, ADiskWithoutRoomHasNone) {
  const DiskReserve disk_reserve(path(), std::uint64_t{1} << 50U);
  EXPECT_FALSE(disk_reserve.is_whole());
  EXPECT_FALSE(is_there()) << "no half one is left";
  const DiskReserve nowhere(folder_.file("no/such/folder"), kSmall);
  EXPECT_FALSE(nowhere.is_whole());
}

TEST_F(DiskReserveTest, IsTakenBackOnlyWhereThereIsRoomNextToIt) {
  std::uint64_t room = 2 * kSmall - 1;
  DiskReserve disk_reserve(path(), kSmall, [&](const std::filesystem::path& folder) {
    EXPECT_EQ(folder, folder_.path());
    return room;
  });
  ASSERT_TRUE(disk_reserve.give_up());
  disk_reserve.restore();
  EXPECT_FALSE(disk_reserve.is_whole());
  EXPECT_FALSE(is_there());
  room = 2 * kSmall;
  disk_reserve.restore();
  EXPECT_TRUE(disk_reserve.is_whole());
  EXPECT_TRUE(is_there());
}

TEST_F(DiskReserveTest, KnowsTheRoomOfItsDisk) {
  EXPECT_GT(DiskReserve::room_of_disk(folder_.path()), 0U);
  EXPECT_EQ(DiskReserve::room_of_disk(folder_.file("no/such/folder")), 0U);
}

TEST_F(DiskReserveTest, WhatRunsIsFinishedAndNothingNewBegins) {
  DiskReserve disk_reserve(path(), kSmall);
  Shop shop(database(), nullptr, &disk_reserve);
  Programs programs(shop.store, shop.links.clock(), shop.documents, &disk_reserve);
  shop.add_machine(kLathe);
  shop.add_machine("mill");
  const std::string text = program(100);
  const store::Job waits = shop.add_job("mill", "%\n(MILL)\nM30\n%\n");
  const store::Release released = release_text(shop.store, "mill", "%\n(NEXT)\nM30\n%\n");
  const store::Job runs = shop.start_job(kLathe, text);
  shop.run(200ms);
  shop.store.watched_ledger().watch([this](auto) -> std::optional<store::Error> {
    if (is_there()) return store::Error{store::ErrorCode::disk_full, "no room"};
    return std::nullopt;
  });
  shop.run(500ms);
  EXPECT_FALSE(is_there());
  EXPECT_NE(shop.report(kLathe).stall, "waiting for ledger");
  EXPECT_EQ(refusal(shop.jobs.arm(waits.id, std::nullopt, "olga")).code, ErrorCode::unavailable);
  EXPECT_EQ(shop.state(waits.id), JobState::queued);
  EXPECT_EQ(refusal(shop.jobs.add(released.id, "anna")).code, ErrorCode::unavailable);
  EXPECT_EQ(refusal(programs.upload("O1", "fanuc", "%\nM30\n%\n", "anna")).code, ErrorCode::unavailable);
  shop.run(3s);
  EXPECT_EQ(shop.written(kLathe), text);
  shop.links.receive(url_of(kLathe), kDc3);
  shop.round();
  EXPECT_EQ(shop.state(runs.id), JobState::done);
  must(shop.store.ledger().verify(runs.id));

  shop.store.watched_ledger().watch({});
  shop.run(11s);
  EXPECT_TRUE(is_there()) << "the disk has room again";
  must(shop.jobs.arm(waits.id, std::nullopt, "olga"));
}

// The second time the disk is full there is nothing left: the feed stops at what is booked, and the ledger stays true.
TEST_F(DiskReserveTest, WithNothingLeftAFeedStopsAtItsReserve) {
  DiskReserve disk_reserve(path(), kSmall);
  Shop shop(database(), nullptr, &disk_reserve);
  shop.add_machine(kLathe);
  const store::Job job = shop.start_job(kLathe, program(200));
  shop.run(200ms);
  shop.store.watched_ledger().watch([](auto) { return store::Error{store::ErrorCode::disk_full, "no room"}; });
  shop.run(3s);
  EXPECT_EQ(shop.report(kLathe).stall, "waiting for ledger");
  EXPECT_EQ(shop.written(kLathe).size(), shop.ledger_of(job.id).back().counts.reserve);
}

}  // namespace
}  // namespace dripfeed::app
