// Changes of many callers that share a commit: each is whole or refused alone, none returns before it is durable, and
// the ledger waits for none that had not begun.
#include <atomic>
#include <cstring>
#include <fstream>
#include <functional>
#include <semaphore>
#include <stdexcept>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/store/failing_vfs.h"
#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

using namespace store;
using namespace std::chrono_literals;

// Commits in the write-ahead log: a frame with the size of the database in its head ends one.
std::size_t commits_in(const std::string& log) {
  std::ifstream file(log, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(file)), {});
  constexpr std::size_t kHead = 32;
  constexpr std::size_t kFrame = 24 + 4096;
  std::size_t commits = 0;
  for (std::size_t at = kHead; at + kFrame <= bytes.size(); at += kFrame) {
    commits += std::memcmp(bytes.data() + at + 4, "\0\0\0\0", 4) != 0 ? 1U : 0U;
  }
  return commits;
}

class Shared : public StoreTest {
 protected:
  static constexpr int kCallers = 6;

  Shared() { register_failing_vfs(); }
  ~Shared() override { fail_at(0, Fault::once); }

  Result<void> add(int n) const {
    const auto added = store_->machines().add(fmt::format("m-{}", n), "p", by("anna"));
    if (!added) return std::unexpected(added.error());
    return {};
  }
  // The callers come while another has the store, so that they wait together. `change` is each one's work.
  std::vector<Result<void>> together(
      const std::function<Result<void>(int)>& change, const std::function<void()>& before_others = [] {}) const {
    std::vector<Result<void>> results(kCallers);
    std::vector<std::jthread> callers;
    must(store_->atomically([&]() -> Result<void> {
      before_others();
      for (int n = 0; n < kCallers; ++n) {
        callers.emplace_back(
            [&, n] { results[static_cast<std::size_t>(n)] = store_->atomically_shared([&, n] { return change(n); }); });
      }
      std::this_thread::sleep_for(200ms);  // nothing says from outside that they wait
      return {};
    }));
    callers.clear();
    return results;
  }
  [[nodiscard]] std::size_t machines() const { return must(store_->machines().list({})).items.size(); }
};

TEST_F(Shared, ThoseWhoWaitTogetherShareOneCommit) {
  const std::size_t before = commits_in(path() + "-wal");
  for (const auto& result : together([this](int n) { return add(n); })) must(result);
  EXPECT_EQ(commits_in(path() + "-wal"), before + 1);
  EXPECT_EQ(machines(), 6U);
  EXPECT_EQ(must(store_->audit().verify()).rows, 6U);
  EXPECT_EQ(must(store_->audit().verify()).first_broken, std::nullopt);
}

TEST_F(Shared, OneThatIsRefusedIsUndoneAlone) {
  const auto results = together([this](int n) -> Result<void> {
    must(add(n));
    if (n == 2) return std::unexpected(Error{ErrorCode::invalid_value, "not this one"});
    return {};
  });
  for (std::size_t n = 0; n < results.size(); ++n) EXPECT_EQ(results[n].has_value(), n != 2);
  EXPECT_EQ(refusal(results[2]), ErrorCode::invalid_value);
  EXPECT_EQ(machines(), 5U);
  EXPECT_EQ(refusal(store_->machines().get("m-2")), ErrorCode::not_found);
}

TEST_F(Shared, WhatOneThrowsComesToItsOwnCaller) {
  std::atomic<int> thrown = 0;
  std::vector<std::jthread> callers;
  must(store_->atomically([&]() -> Result<void> {
    for (int n = 0; n < kCallers; ++n) {
      callers.emplace_back([&, n] {
        try {
          must(store_->atomically_shared([&, n]() -> Result<void> {
            must(add(n));
            if (n % 2 == 1) throw std::runtime_error(fmt::format("{}", n));
            return {};
          }));
          EXPECT_EQ(n % 2, 0);
        } catch (const std::runtime_error& error) {
          EXPECT_EQ(error.what(), fmt::format("{}", n));
          ++thrown;
        }
      });
    }
    std::this_thread::sleep_for(200ms);
    return {};
  }));
  callers.clear();
  EXPECT_EQ(thrown, 3);
  EXPECT_EQ(machines(), 3U);
}

// Whichever write or sync of their commit fails: no one is informed that a change was done, and none is there.
TEST_F(Shared, ACommitThatFailsFailsForAll) {
  int changed = 0;
  bool met = true;
  for (std::uint64_t step = 1; met; ++step) {
    ASSERT_LT(step, 500U);
    reopen({.vfs = kFailingVfs});
    const std::size_t before = machines();
    const int base = static_cast<int>(step) * 100;
    const auto results = together([&](int n) { return add(base + n); }, [&] { fail_at(step, Fault::lost_for_good); });
    met = failed();
    fail_at(0, Fault::once);
    const std::size_t found = machines();
    if (found == before) {
      for (const auto& result : results) EXPECT_EQ(refusal(result), ErrorCode::io_failed) << "at step " << step;
      ++changed;
    } else {
      for (const auto& result : results) EXPECT_TRUE(result) << "at step " << step << message_of(result.error());
      EXPECT_EQ(found, before + kCallers) << "at step " << step;
    }
  }
  EXPECT_GT(changed, 2);
}

// A ledger that comes in the midst of a group is written before those of it that had not begun.
TEST_F(Shared, TheLedgerGoesBeforeThoseThatHadNotBegun) {
  const Job job = add_job(*store_, "mill-1");
  std::atomic<int> made = 0;
  std::atomic<int> after_ledger = 0;
  std::jthread ledger;
  const auto results = together([&](int n) -> Result<void> {
    if (++made == 2) {
      ledger = std::jthread([&] {
        const std::array rows{NewLedgerRow{job.id, {0, 0, 0, 2}, ""}};
        EXPECT_TRUE(must(store_->ledger().append(rows, 1)).empty());
      });
      std::this_thread::sleep_for(200ms);
    }
    if (must(store_->ledger().interval(job.id)).seq == 1) ++after_ledger;
    return add(n);
  });
  for (const auto& result : results) must(result);
  EXPECT_EQ(after_ledger, kCallers - 2);
}

TEST_F(Shared, ManyCallersForLong) {
  std::atomic<int> refused = 0;
  {
    std::vector<std::jthread> callers;
    for (int caller = 0; caller < 20; ++caller) {
      callers.emplace_back([&, caller] {
        for (int n = 0; n < 30; ++n) {
          if (n % 5 == 4) {
            must(store_->machines().add(fmt::format("alone-{}-{}", caller, n), "p", by("anna")));
            continue;
          }
          const auto done = store_->atomically_shared([&, n]() -> Result<void> {
            if (n % 5 == 3) return std::unexpected(Error{ErrorCode::invalid_value, "no"});
            return add(caller * 100 + n);
          });
          if (!done) {
            ++refused;
            continue;
          }
          EXPECT_TRUE(store_->machines().get(fmt::format("m-{}", caller * 100 + n))) << "not there yet";
        }
      });
    }
  }
  EXPECT_EQ(refused, 20 * 6);
  EXPECT_EQ(must(store_->audit().verify()).rows, 20U * 24U);
  EXPECT_EQ(must(store_->audit().verify()).first_broken, std::nullopt);
  must(store_->check());
}

class SharedCrash : public StoreTest {
 protected:
  SharedCrash() : StoreTest(TempFolder::Where::disk) {}
};

// Six callers add jobs in a child that is killed: each job whose answer one of them had is there.
TEST_F(SharedCrash, WhatWasAcknowledgedIsThereAfterAKill) {
  const Released released = add_released(*store_, "mill-1");
  store_.reset();
  std::size_t acknowledged = 0;
  for (int round = 0; round < 5; ++round) {
    int pipe[2] = {-1, -1};
    ASSERT_EQ(::pipe(pipe), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      auto store = sqlite::open(path(), {.own = true, .checkpoints_aside = true});
      if (!store) std::_Exit(1);
      std::vector<std::jthread> callers;
      for (int n = 0; n < 6; ++n) {
        callers.emplace_back([&] {
          while (true) {
            const auto job = (*store)->jobs().add({released.release.id, "link", 1}, by("anna"));
            if (!job || ::write(pipe[1], &job->id, sizeof job->id) != sizeof job->id) std::_Exit(2);
          }
        });
      }
      callers.clear();
    }
    ::close(pipe[1]);
    std::vector<Id> changed(1);
    ASSERT_EQ(::read(pipe[0], changed.data(), sizeof(Id)), static_cast<ssize_t>(sizeof(Id)));
    std::this_thread::sleep_for(std::chrono::milliseconds(40 + 23 * round));
    ASSERT_EQ(::kill(child, SIGKILL), 0);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    Id id = 0;
    while (::read(pipe[0], &id, sizeof id) == static_cast<ssize_t>(sizeof id)) changed.push_back(id);
    ::close(pipe[0]);
    reopen({.own = true});
    must(store_->check());
    EXPECT_EQ(must(store_->audit().verify()).first_broken, std::nullopt);
    for (const Id one : changed) EXPECT_TRUE(store_->jobs().get(one)) << "acknowledged, but lost: " << one;
    acknowledged += changed.size();
    store_.reset();
  }
  EXPECT_GT(acknowledged, 30U);
}

}  // namespace
}  // namespace dripfeed::store_test
