// A server that is killed: what was acknowledged is there afterwards, and the ledger's interval holds the truth.
#include <array>
#include <chrono>
#include <cstdlib>
#include <thread>

#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "store/sqlite/verify.h"
#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

using namespace store;

class CrashTest : public StoreTest {
 protected:
  CrashTest() : StoreTest(TempFolder::Where::disk) {}
};

// What the child says through its pipe after each commit: how much is handed and acknowledged.
struct Word {
  std::uint64_t handed = 0;
};

// Feeds in the child until it is killed: each commit states what was handed and reserves the next window.
[[noreturn]] void feed_until_killed(const std::string& path, const std::vector<Id>& jobs, int pipe) {
  auto store = sqlite::open(path, {.own = true});
  if (!store) std::_Exit(1);
  std::vector<NewLedgerRow> rows;
  for (const Id job : jobs) {
    const auto known = (*store)->ledger().interval(job);
    rows.push_back({job, known ? known->last : LedgerCounts{}, ""});
  }
  while (true) {
    for (NewLedgerRow& row : rows) {
      row.counts.handed = row.counts.clocked = row.counts.reserve;
      row.counts.reserve += 96;
    }
    const auto faults = (*store)->ledger().append(rows, 1);
    if (!faults || !faults->empty()) std::_Exit(2);
    const Word word{rows[0].counts.handed};
    if (::write(pipe, &word, sizeof word) != sizeof word) std::_Exit(3);
  }
}

TEST_F(CrashTest, KilledWhileItCommitsTheLedger) {
  std::vector<Id> jobs;
  for (int i = 0; i < 8; ++i) {
    jobs.push_back(add_job(*store_, fmt::format("mill-{}", i)).id);
    bring(*store_, jobs.back(), JobState::feeding);
  }
  store_.reset();
  std::uint64_t commits = 0;
  for (int round = 0; round < 6; ++round) {
    std::array<int, 2> pipe{};
    ASSERT_EQ(::pipe(pipe.data()), 0);
    const pid_t child = ::fork();
    if (child == 0) feed_until_killed(path(), jobs, pipe[1]);
    ::close(pipe[1]);
    Word last;
    ASSERT_EQ(::read(pipe[0], &last, sizeof last), static_cast<ssize_t>(sizeof last)) << "the child feeds";
    std::this_thread::sleep_for(std::chrono::milliseconds(30 + 17 * round));
    ASSERT_EQ(::kill(child, SIGKILL), 0);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "it ended by itself with " << WEXITSTATUS(status);
    Word word;
    while (::read(pipe[0], &word, sizeof word) == static_cast<ssize_t>(sizeof word)) last = word;
    ::close(pipe[0]);

    reopen({.own = true});  // the dead one's lock is gone with it
    must(store_->check());
    EXPECT_TRUE(must(sqlite::verify(path())).faults.empty());
    for (const Id job : jobs) {
      const LedgerInterval known = must(store_->ledger().interval(job));
      EXPECT_GE(known.last.handed, last.handed) << "acknowledged, but lost";
      EXPECT_LE(known.last.handed, last.handed + 96) << "one commit at most was in transit";
      EXPECT_EQ(known.low, known.last.clocked);
      EXPECT_EQ(known.high, known.last.handed + 96);
      EXPECT_EQ(must(store_->ledger().verify(job)), known.seq);
      EXPECT_EQ(known.seq, must(store_->ledger().interval(jobs[0])).seq) << "a commit is for all lines or for none";
      commits = known.seq;
    }
    store_.reset();
  }
  EXPECT_GT(commits, 20U);
  reopen({.own = true});
  const auto interrupted = must(store_->jobs().interrupt_unfinished(by("server")));
  EXPECT_EQ(interrupted.size(), jobs.size());
  for (const Job& job : interrupted) EXPECT_TRUE(job.needs_confirmation());
}

TEST_F(CrashTest, KilledWhileItUploads) {
  store_.reset();
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe(pipe.data()), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    auto store = sqlite::open(path());
    auto writer = store ? (*store)->contents().begin() : std::unexpected(store.error());
    while (writer && (*writer)->append(std::string(1'000'000, 'x'))) {
      if (::write(pipe[1], "x", 1) != 1) break;
    }
    std::_Exit(1);
  }
  ::close(pipe[1]);
  char byte = 0;
  for (int i = 0; i < 5; ++i) ASSERT_EQ(::read(pipe[0], &byte, 1), 1);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  ::close(pipe[0]);
  EXPECT_NE(sql("CREATE TEMP TABLE t (x CHECK (x = 0)); INSERT INTO t SELECT count(*) FROM content_chunk"), "")
      << "something was left";
  reopen({.own = true});
  EXPECT_EQ(sql("CREATE TEMP TABLE t (x CHECK (x = 0)); INSERT INTO t SELECT count(*) FROM content_chunk"), "");
  EXPECT_EQ(sql("CREATE TEMP TABLE t (x CHECK (x = 0)); INSERT INTO t SELECT count(*) FROM content"), "");
}

}  // namespace
}  // namespace dripfeed::store_test
