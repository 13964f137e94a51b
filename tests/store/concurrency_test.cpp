// Many threads at once: readers see one state, changes wait for each other, a backup runs while the ledger is written.
#include <array>
#include <atomic>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

using namespace store;

class Concurrency : public StoreTest {};

TEST_F(Concurrency, ReadersSeeWholeTransactions) {
  must(store_->machines().add("a", "0", by("anna")));
  must(store_->machines().add("b", "0", by("anna")));
  std::atomic<bool> stop = false;
  std::atomic<std::uint64_t> reads = 0;
  std::vector<std::jthread> readers;
  for (int i = 0; i < 4; ++i) {
    readers.emplace_back([&] {
      std::uint64_t seen = 0;
      while (!stop) {
        const auto page = store_->machines().list({});
        ASSERT_TRUE(page) << message_of(page.error());
        ASSERT_EQ(page->items.size(), 2U);
        ASSERT_EQ(page->items[0].profile, page->items[1].profile) << "half a transaction";
        ASSERT_GE(page->items[0].revision, seen) << "time went back";
        seen = page->items[0].revision;
        ++reads;
      }
    });
  }
  for (Revision revision = 1; revision <= 100; ++revision) {
    must(store_->atomically([&]() -> Result<void> {
      const std::string profile = fmt::format("{}", revision);
      for (const char* name : {"a", "b"}) {
        const auto changed = store_->machines().change(name, revision, profile, by("anna"));
        if (!changed) return std::unexpected(changed.error());
      }
      return {};
    }));
  }
  while (reads < 100) std::this_thread::yield();
  stop = true;
}

TEST_F(Concurrency, OfManyChangesOfOneRevisionOneWins) {
  must(store_->machines().add("a", "0", by("anna")));
  std::atomic<int> won = 0;
  std::atomic<int> stale = 0;
  {
    std::vector<std::jthread> writers;
    for (int i = 0; i < 6; ++i) {
      writers.emplace_back([&] {
        const auto changed = store_->machines().change("a", 1, "mine", by("anna"));
        if (changed) ++won;
        if (!changed && changed.error().code == ErrorCode::stale_revision) ++stale;
      });
    }
  }
  EXPECT_EQ(won, 1);
  EXPECT_EQ(stale, 5);
  EXPECT_EQ(must(store_->audit().verify()).first_broken, std::nullopt);
}

// Two processes on one file, as a server and a command: what one changes the other waits for.
TEST_F(Concurrency, TwoStoresOnOneFileWaitForEachOther) {
  const auto guest = must(open_second());
  must(store_->machines().add("a", "0", by("anna")));
  must(store_->machines().add("b", "0", by("anna")));
  const auto change = [](Store& store, const char* name) {
    for (Revision revision = 1; revision <= 40; ++revision) must(store.machines().change(name, revision, "p", by("x")));
  };
  {
    const std::jthread one([&] { change(*store_, "a"); });
    const std::jthread other([&] { change(*guest, "b"); });
  }
  EXPECT_EQ(must(store_->audit().verify()).rows, 82U);
  EXPECT_EQ(must(store_->audit().verify()).first_broken, std::nullopt);
}

TEST_F(Concurrency, OneLineIsArmedOnce) {
  const Job first = add_job(*store_, "mill-1");
  std::vector<Id> jobs{first.id};
  for (int i = 0; i < 5; ++i) jobs.push_back(must(store_->jobs().add({first.release, "link", 1}, by("anna"))).id);
  std::atomic<int> armed = 0;
  {
    std::vector<std::jthread> people;
    for (const Id job : jobs) {
      people.emplace_back([&, job] {
        if (store_->jobs().move(job, {JobState::armed, "", false}, by("olga"))) ++armed;
      });
    }
  }
  EXPECT_EQ(armed, 1);
}

TEST_F(Concurrency, ABackupIsOneStateWhileTheLedgerIsWritten) {
  const Job first = add_job(*store_, "mill-1");
  const Job second = must(store_->jobs().add({first.release, "link", 1}, by("anna")));
  must(store_->contents().put(std::string(3'000'000, 'x')));
  std::atomic<bool> stop = false;
  std::jthread writer([&] {
    for (std::uint64_t i = 0; !stop; ++i) {
      const std::array rows{NewLedgerRow{first.id, {i, i, 0, i + 1}, ""},
                            NewLedgerRow{second.id, {i, i, 0, i + 1}, ""}};
      const auto faults = store_->ledger().append(rows, 1);
      ASSERT_TRUE(faults && faults->empty());
    }
  });
  for (int i = 0; i < 5; ++i) {
    const std::string copy = folder_.file(fmt::format("copy-{}.db", i));
    must(store_->backup(copy));
    const auto restored = must(sqlite::open(copy));
    must(restored->check());
    const LedgerInterval known = must(restored->ledger().interval(first.id));
    EXPECT_EQ(known.seq, must(restored->ledger().interval(second.id)).seq);
    EXPECT_EQ(must(restored->ledger().verify(first.id)), known.seq);
  }
  stop = true;
}

class StoreVersion : public StoreTest {};

TEST_F(StoreVersion, IsAnotherAfterEveryChangeByThisStoreOrAnotherProcess) {
  const Token token = must(store_->tokens().add({.name = "mes", .role = Role::viewer, .hash = "hash"}, by("anna")));
  std::uint64_t before = must(store_->version());
  const auto is_another = [&] {
    const std::uint64_t now = must(store_->version());
    return std::exchange(before, now) != now;
  };
  EXPECT_FALSE(is_another());
  must(store_->tokens().find("hash"));
  must(store_->machines().list({}));
  EXPECT_FALSE(is_another()) << "reading changes nothing";
  must(store_->machines().add("a", "0", by("anna")));
  EXPECT_TRUE(is_another());
  EXPECT_EQ(refusal(store_->machines().add("a", "0", by("anna"))), ErrorCode::exists);
  must(store_->tokens().revoke(token.id, by("anna")));
  EXPECT_TRUE(is_another());
  // Another connection, as `dripfeed token revoke` has one.
  must(store_->tokens().add({.name = "wall", .role = Role::viewer, .hash = "other"}, by("anna")));
  EXPECT_TRUE(is_another());
  EXPECT_EQ(sql("UPDATE token SET revoked_at_ms = 9 WHERE name = 'wall'"), "");
  EXPECT_TRUE(is_another());
  const auto second = must(open_second());
  must(second->machines().add("b", "0", by("bert")));
  EXPECT_TRUE(is_another());
  EXPECT_FALSE(is_another());
}

TEST_F(StoreVersion, WhatWasReadAfterItHoldsAsLongAsItIsTheSame) {
  must(store_->machines().add("a", "0", by("anna")));
  std::atomic<bool> stop = false;
  std::atomic<int> held = 0;
  std::jthread writer([&] {
    for (Revision revision = 1; revision <= 300; ++revision) {
      must(store_->machines().change("a", revision, "p", by("anna")));
      while (revision == 150 && held == 0) std::this_thread::yield();
    }
    stop = true;
  });
  while (!stop) {
    const std::uint64_t version = must(store_->version());
    const Revision seen = must(store_->machines().get("a")).revision;
    const Revision again = must(store_->machines().get("a")).revision;
    if (must(store_->version()) != version) continue;
    EXPECT_EQ(again, seen);
    ++held;
  }
  EXPECT_EQ(must(store_->machines().get("a")).revision, 301U);
}

}  // namespace
}  // namespace dripfeed::store_test
