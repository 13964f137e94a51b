// The ledger's group commits, in virtual time over a real store: what a feed may hand is durable before it is handed,
// whatever a commit does, and the books say after a kill where the truth lies.
#include "server/app/jobs/books.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include "tests/unit/server/app/gate.h"
#include "tests/unit/server/app/whole_shop.h"

namespace dripfeed::app {
namespace {

using namespace std::chrono_literals;
using namespace test;

constexpr std::uint64_t kWindow = 436;  // half a second at 9600 baud, 11 bits a character

class BooksTest : public ShopTest {
 protected:
  // Each byte is looked up in the ledger before it leaves.
  static void check_each_byte(Shop& shop, const std::string& machine, store::Id job) {
    shop.links.cable(url_of(machine)).before_write = [&shop, job](std::size_t total) {
      EXPECT_LE(total, must(shop.store.ledger().interval(job)).last.reserve);
    };
  }
};

TEST_F(BooksTest, HandsNothingThatIsNotReservedInTheLedger) {
  Shop shop(database());
  shop.add_machine(kLathe);
  const std::string text = program(100);
  const store::Job job = shop.add_job(kLathe, text);
  check_each_byte(shop, kLathe, job.id);
  must(shop.jobs.arm(job.id, std::nullopt, "olga"));
  EXPECT_EQ(shop.ledger_of(job.id).front().counts.reserve, 0U) << "nothing is reserved before the control asks";
  shop.links.receive(url_of(kLathe), kDc1);
  shop.run(4s);
  EXPECT_EQ(shop.written(kLathe), text);
  shop.links.receive(url_of(kLathe), kDc3);
  shop.round();
  EXPECT_EQ(shop.state(job.id), store::JobState::done);
  const store::LedgerCounts last = shop.ledger_of(job.id).back().counts;
  EXPECT_EQ(last.handed, text.size());
  EXPECT_EQ(last.clocked, text.size());
  EXPECT_EQ(last.reserve, text.size()) << "what is left of the window is given back";
  EXPECT_EQ(last.confirmed, 0U);
  EXPECT_GE(must(shop.store.ledger().verify(job.id)), 4U);
}

TEST_F(BooksTest, AReserveIsReportedOnlyAfterItsCommit) {
  Gate gate;
  Shop shop(database());
  shop.add_machine(kLathe);
  const std::string text = program(100);
  const store::Job job = shop.start_job(kLathe, text);
  check_each_byte(shop, kLathe, job.id);
  shop.run(300ms);
  const std::uint64_t reserved = shop.ledger_of(job.id).back().counts.reserve;
  ASSERT_LT(shop.written(kLathe).size(), reserved);

  shop.store.watched_ledger().watch([&](auto) {
    gate.pass();
    return std::nullopt;
  });
  shop.links.advance(100ms);
  shop.books.wake();
  gate.await_someone();
  shop.links.advance(10s);
  EXPECT_EQ(shop.written(kLathe).size(), reserved) << "the commit is not done";
  EXPECT_EQ(shop.report(kLathe).stall, "waiting for ledger");
  EXPECT_EQ(shop.report(kLathe).reserve, reserved);

  shop.store.watched_ledger().watch({});
  gate.open();
  shop.run(4s);
  EXPECT_EQ(shop.written(kLathe), text);
}

TEST_F(BooksTest, ACommitThatFailsReservesNothingAndMovesNoJob) {
  Shop shop(database());
  shop.add_machine(kLathe);
  const std::string text = program(100);
  const store::Job job = shop.start_job(kLathe, text);
  shop.run(300ms);
  ASSERT_EQ(shop.state(job.id), store::JobState::feeding);
  shop.store.watched_ledger().watch([](auto) { return store::Error{store::ErrorCode::io_failed, "the disk is gone"}; });
  shop.round();
  const store::LedgerRow last = shop.ledger_of(job.id).back();
  shop.run(2s);
  EXPECT_EQ(shop.written(kLathe).size(), last.counts.reserve);
  shop.links.receive(url_of(kLathe), kSyn);
  shop.run(1s);
  ASSERT_TRUE(shop.report(kLathe).end == JobEnd::failed);
  EXPECT_EQ(shop.state(job.id), store::JobState::feeding) << "no job moves without its row";
  EXPECT_EQ(shop.ledger_of(job.id).back().seq, last.seq);

  const auto alarms = [&] {
    return std::ranges::count(shop.published(),
                              "alarm lathe the ledger cannot be written: the disk could not be read or "
                              "written (the disk is gone)");
  };
  EXPECT_EQ(alarms(), 1) << "told once, not with each round";

  shop.store.watched_ledger().watch({});
  shop.round();
  EXPECT_EQ(shop.state(job.id), store::JobState::failed);
  EXPECT_EQ(shop.ledger_of(job.id).back().counts.handed, last.counts.reserve);
  must(shop.store.ledger().verify(job.id));
}

TEST_F(BooksTest, AFeedGoesOnAfterFailedCommits) {
  std::atomic<int> calls = 0;
  Shop shop(database());
  shop.add_machine(kLathe);
  const std::string text = program(100);
  const store::Job job = shop.start_job(kLathe, text);
  check_each_byte(shop, kLathe, job.id);
  shop.store.watched_ledger().watch([&](auto) -> std::optional<store::Error> {
    if (++calls % 3 != 0) return store::Error{store::ErrorCode::busy, "somebody else writes"};
    return std::nullopt;
  });
  shop.run(8s);
  EXPECT_EQ(shop.written(kLathe), text);
  EXPECT_GT(calls, 10);
}

TEST_F(BooksTest, AllLinesAreInOneCommit) {
  Gate gate;
  std::mutex mutex;
  std::vector<std::vector<store::Id>> commits;
  Shop shop(database());
  const std::vector<std::string> machines = {"mill-1", "mill-2", "mill-3"};
  std::vector<store::Id> jobs;
  for (const std::string& machine : machines) {
    shop.add_machine(machine);
    jobs.push_back(shop.start_job(machine, "%\n(" + machine + ")\n" + program(60).substr(2)).id);
  }
  shop.run(100ms);
  // While one commit is held up, all lines go on; the next one has them all.
  shop.store.watched_ledger().watch([&](std::span<const store::NewLedgerRow> rows) {
    {
      const std::lock_guard lock(mutex);
      commits.emplace_back();
      for (const store::NewLedgerRow& row : rows) commits.back().push_back(row.job);
    }
    gate.pass();
    return std::nullopt;
  });
  shop.links.advance(20ms);
  shop.books.wake();
  gate.await_someone();
  shop.links.advance(50ms);
  gate.open();
  shop.books.wait_until_booked();
  const std::lock_guard lock(mutex);
  ASSERT_GE(commits.size(), 2U);
  std::ranges::sort(commits[1]);
  EXPECT_EQ(commits[1], jobs);
}

// One row that the ledger does not take must not stop the other lines.
TEST_F(BooksTest, ALineThatWaitsDoesNotHoldTheOthers) {
  Shop shop(database());
  shop.add_machine("mill-1");
  shop.add_machine("mill-2");
  const std::string text = program(40);
  const store::Job held = shop.start_job("mill-1", text);
  const store::Job runs = shop.start_job("mill-2", "%\n(2)\n" + text.substr(2));
  shop.run(100ms);
  shop.links.receive(url_of("mill-1"), kDc3);
  shop.run(1s);
  const std::size_t written = shop.ledger_of(held.id).size();
  shop.run(2s);
  EXPECT_EQ(shop.state(held.id), store::JobState::held);
  EXPECT_EQ(shop.job(held.id).reason, "held by DC3");
  EXPECT_EQ(shop.state(runs.id), store::JobState::draining);
  const auto rows = shop.ledger_of(held.id);
  EXPECT_TRUE(std::ranges::any_of(rows, [](const store::LedgerRow& row) { return row.note == "held by DC3"; }));
  EXPECT_EQ(rows.size(), written) << "nothing changes, so nothing is written";
}

TEST_F(BooksTest, AfterAKillTheTruthLiesBetweenClockedAndReserve) {
  for (const auto fed : {0ms, 50ms, 350ms, 400ms, 1000ms, 2000ms}) {
    SCOPED_TRACE(fed.count());
    std::filesystem::remove(database());
    std::filesystem::remove(database() + "-wal");
    std::filesystem::remove(database() + "-shm");
    Gate gate;
    Shop shop(database());
    shop.add_machine(kLathe);
    const store::Job job = shop.start_job(kLathe, program(200));
    shop.run(fed);
    shop.store.watched_ledger().watch([&](auto) {
      gate.pass();
      return std::nullopt;
    });
    shop.links.advance(30ms);  // counters alone are reported every 20 ms
    shop.books.wake();
    gate.await_someone();
    const std::string killed = killed_copy(database());
    const std::uint64_t handed_at_least = shop.written(kLathe).size();
    shop.links.advance(5s);  // the server may live on for a while before it is killed
    const std::uint64_t handed_at_most = shop.written(kLathe).size();
    const std::uint64_t clocked = shop.report(kLathe).clocked;
    shop.store.watched_ledger().watch({});
    gate.open();

    Shop next(killed);
    const auto interrupted = must(next.store.jobs().interrupt_unfinished(by("server")));
    ASSERT_EQ(interrupted.size(), 1U);
    EXPECT_EQ(interrupted.front().state, store::JobState::interrupted);
    EXPECT_TRUE(interrupted.front().torn);
    const store::LedgerInterval known = must(next.store.ledger().interval(job.id));
    EXPECT_LE(known.low, handed_at_least);
    EXPECT_GE(known.high, handed_at_most);
    EXPECT_LE(clocked, known.high);
    EXPECT_LE(known.high - known.low, kWindow + 4 + 64) << "no more than a window and a round is unknown";

    // The machine waits for a person; then it may be armed again, and nothing went out before.
    ASSERT_TRUE(next.catalog.open_lines());
    next.links.run_posted();
    const store::Job again = must(next.jobs.add(job.release, "anna"));
    EXPECT_EQ(refusal(next.jobs.arm(again.id, std::nullopt, "olga")).code, ErrorCode::refused);
    must(next.jobs.confirm_reset(kLathe, "reset at the panel", "olga"));
    must(next.jobs.arm(again.id, std::nullopt, "olga"));
    EXPECT_EQ(next.written(kLathe), "");
    std::filesystem::remove(killed + ".lock");
  }
}

// A short job may begin and end between two rounds; its path through the states is complete all the same.
TEST_F(BooksTest, AJobThatWasQuickerThanARoundTakesEveryStep) {
  Shop shop(database());
  shop.add_machine(kLathe);
  const std::string text = program(3);
  ASSERT_LT(text.size(), kWindow);
  const store::Job job = shop.add_job(kLathe, text);
  must(shop.jobs.arm(job.id, std::nullopt, "olga"));
  // Commits come through until the first window is there; the ledger has no other before the job is over.
  std::atomic<bool> has_window = false;
  shop.store.watched_ledger().watch([&](auto) -> std::optional<store::Error> {
    if (has_window) return store::Error{store::ErrorCode::busy, ""};
    return std::nullopt;
  });
  shop.links.receive(url_of(kLathe), kDc1);
  for (int i = 0; i < 2000 && shop.report(kLathe).reserve == 0; ++i) {
    std::this_thread::sleep_for(1ms);
    shop.links.run_posted();
  }
  has_window = true;
  shop.links.advance(1s);
  shop.links.receive(url_of(kLathe), kDc3);
  EXPECT_EQ(shop.report(kLathe).end, JobEnd::done);
  shop.store.watched_ledger().watch({});
  shop.round();
  const store::Job done = shop.job(job.id);
  EXPECT_EQ(done.state, store::JobState::done);
  EXPECT_NE(done.started_at_ms, 0);
  const std::vector<std::string> steps = {"armed", "feeding", "draining", "done"};
  std::vector<std::string> seen;
  for (const Event& event : shop.events.since(0).events) {
    if (event.kind == EventKind::job && event.job.state != store::JobState::queued)
      seen.emplace_back(store::name_of(event.job.state));
  }
  EXPECT_EQ(seen, steps);
}

// Armed again and disarmed again while the ledger was busy elsewhere: the books must not believe in the first
// disarming.
TEST_F(BooksTest, ASecondDisarmingThatNoOneSawIsBookedToo) {
  Gate gate;
  Shop shop(database());
  shop.add_machine(kLathe);
  shop.add_machine("mill");
  const store::Job job = shop.add_job(kLathe, program(3));
  must(shop.jobs.arm(job.id, std::nullopt, "olga"));
  shop.links.advance(10min);
  shop.round();
  ASSERT_EQ(shop.state(job.id), store::JobState::queued);
  shop.start_job("mill", program(50));
  shop.store.watched_ledger().watch([&](std::span<const store::NewLedgerRow> rows) {
    if (rows.front().note != "armed") gate.pass();
    return std::nullopt;
  });
  shop.links.advance(50ms);
  shop.books.wake();
  gate.await_someone();
  must(shop.jobs.arm(job.id, std::nullopt, "olga"));
  shop.links.lose(url_of(kLathe));
  gate.open();
  shop.round();
  EXPECT_EQ(shop.state(job.id), store::JobState::queued);
  EXPECT_EQ(shop.job(job.id).reason, "disarmed, nothing was sent: link_lost");
  shop.links.advance(1s);
  must(shop.jobs.arm(job.id, std::nullopt, "olga"));
}

TEST_F(BooksTest, ATornBlockIsReportedWithItsPlace) {
  Shop shop(database());
  shop.add_machine(kLathe);
  const store::Job job = shop.start_job(kLathe, program(20));
  shop.run(50ms);
  while (shop.written(kLathe).back() == '\n') shop.links.advance(1ms);
  const std::size_t sent = shop.written(kLathe).size();
  shop.links.lose(url_of(kLathe));
  shop.round();
  const store::Job failed = shop.job(job.id);
  EXPECT_EQ(failed.state, store::JobState::failed);
  EXPECT_TRUE(failed.needs_confirmation());
  EXPECT_NE(failed.reason.find("link_lost: between wire byte "), std::string::npos) << failed.reason;
  EXPECT_NE(failed.reason.find(" and " + std::to_string(sent) + " of "), std::string::npos) << failed.reason;
  EXPECT_NE(failed.reason.find("a block is torn"), std::string::npos) << failed.reason;
  EXPECT_NE(failed.reason.find("the cable is cut"), std::string::npos) << failed.reason;
  EXPECT_EQ(shop.ledger_of(job.id).back().note, failed.reason);
}

TEST_F(BooksTest, ANoteStandsInTheNextRowOfItsJobAlone) {
  Shop shop(database());
  shop.add_machine(kLathe);
  const store::Job first = shop.start_job(kLathe, program(3));
  shop.run(1s);
  shop.books.note(first.id, "olga looked at it");
  shop.round();
  EXPECT_EQ(shop.ledger_of(first.id).back().note, "olga looked at it");
  const std::size_t rows = shop.ledger_of(first.id).size();
  shop.round();
  EXPECT_EQ(shop.ledger_of(first.id).size(), rows) << "a note is written once";
  shop.links.receive(url_of(kLathe), kDc3);
  shop.round();
  ASSERT_EQ(shop.state(first.id), store::JobState::done);
  shop.books.note(first.id, "too late");
  const store::Job second = must(shop.jobs.add(first.release, "anna"));
  must(shop.jobs.arm(second.id, std::nullopt, "olga"));
  shop.run(100ms);
  for (const store::LedgerRow& row : shop.ledger_of(second.id)) EXPECT_EQ(row.note.find("too late"), std::string::npos);
}

}  // namespace
}  // namespace dripfeed::app
