// The ledger: rows and their rule, pages over marks, many lines in one commit.
#include <algorithm>
#include <array>
#include <chrono>
#include <iostream>

#include <fmt/format.h>

#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

using namespace store;

class LedgerTest : public StoreTest {
 protected:
  LedgerTest() : StoreTest(TempFolder::Where::disk) {}
  std::vector<LedgerFault> append(Id job, LedgerCounts counts, std::string note = {}, std::int64_t at_ms = 1) {
    const std::array rows{NewLedgerRow{job, counts, std::move(note)}};
    return must(store_->ledger().append(rows, at_ms));
  }
};

TEST_F(LedgerTest, SaysWhatIsKnown) {
  const Job job = add_job(*store_, "mill-1");
  LedgerInterval known = must(store_->ledger().interval(job.id));
  EXPECT_EQ(known.seq, 0U);
  EXPECT_EQ(known.high, 0U);
  EXPECT_TRUE(append(job.id, {0, 0, 0, 100}, "armed", 10).empty());
  EXPECT_TRUE(append(job.id, {60, 50, 40, 160}, "", 20).empty());
  EXPECT_TRUE(append(job.id, {160, 150, 40, 200}, "held by DC3", 30).empty());
  reopen();
  known = must(store_->ledger().interval(job.id));
  EXPECT_EQ(known.low, 150U);
  EXPECT_EQ(known.high, 200U);
  EXPECT_EQ(known.seq, 3U);
  EXPECT_EQ(known.at_ms, 30);
  EXPECT_EQ(known.last.handed, 160U);
  EXPECT_EQ(known.last.confirmed, 40U);
  const auto page = must(store_->ledger().rows(job.id, {}));
  ASSERT_EQ(page.items.size(), 3U);
  EXPECT_EQ(page.items[0].note, "armed");
  EXPECT_EQ(page.items[1].counts, (LedgerCounts{60, 50, 40, 160}));
  EXPECT_EQ(page.items[2].seq, 3U);
  EXPECT_EQ(page.items[2].at_ms, 30);
  EXPECT_EQ(page.next, "");
  EXPECT_EQ(must(store_->ledger().verify(job.id)), 3U);
}

TEST_F(LedgerTest, WrongRowsAreReportedAndDoNotStopTheOthers) {
  const Job first = add_job(*store_, "mill-1");
  const Job second = add_job(*store_, "mill-2");
  append(first.id, {0, 0, 0, 100});
  append(first.id, {50, 40, 30, 100});
  const std::array<LedgerCounts, 6> wrong{{{50, 40, 30, 49},     // less reserved than handed
                                           {50, 51, 30, 100},    // more clocked than handed
                                           {50, 40, 41, 100},    // more confirmed than clocked
                                           {49, 40, 30, 100},    // handed falls
                                           {50, 39, 30, 100},    // clocked falls
                                           {50, 40, 29, 100}}};  // confirmed falls
  std::uint64_t handed = 0;
  append(second.id, {0, 0, 0, 1000});
  for (const LedgerCounts& counts : wrong) {
    const std::array rows{NewLedgerRow{first.id, counts, ""}, NewLedgerRow{99, {}, ""},
                          NewLedgerRow{second.id, {++handed, 0, 0, 1000}, ""}};
    const auto faults = must(store_->ledger().append(rows, 3));
    ASSERT_EQ(faults.size(), 2U);
    EXPECT_EQ(faults[0].job, first.id);
    EXPECT_FALSE(faults[0].written);
    EXPECT_EQ(faults[1].job, 99U);
  }
  EXPECT_EQ(must(store_->ledger().interval(first.id)).seq, 2U);
  EXPECT_EQ(must(store_->ledger().interval(second.id)).last.handed, wrong.size());
}

TEST_F(LedgerTest, MoreThanReservedIsWrittenAndReported) {
  const Job job = add_job(*store_, "mill-1");
  append(job.id, {0, 0, 0, 100});
  const auto faults = append(job.id, {101, 90, 0, 200});
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_TRUE(faults[0].written);
  EXPECT_EQ(must(store_->ledger().interval(job.id)).last.handed, 101U);
  EXPECT_EQ(refusal(store_->ledger().verify(job.id)), ErrorCode::corrupt);
}

TEST_F(LedgerTest, UnknownJob) {
  EXPECT_EQ(refusal(store_->ledger().rows(1, {})), ErrorCode::not_found);
  EXPECT_EQ(refusal(store_->ledger().interval(1)), ErrorCode::not_found);
  EXPECT_EQ(refusal(store_->ledger().verify(1)), ErrorCode::not_found);
}

// Rows of two jobs between each other, over several marks; every page size and place gives the same rows.
TEST_F(LedgerTest, PagesTileTheRows) {
  const Job job = add_job(*store_, "mill-1");
  const Job other = add_job(*store_, "mill-2");
  constexpr std::uint64_t kRows = 1100;
  must(store_->atomically([&]() -> Result<void> {
    for (std::uint64_t i = 1; i <= kRows; ++i) {
      const std::array rows{NewLedgerRow{job.id, {i - 1, i - 1, 0, i}, fmt::format("row {}", i)},
                            NewLedgerRow{other.id, {0, 0, 0, i}, "other"}};
      const auto faults = store_->ledger().append(rows, static_cast<std::int64_t>(i));
      if (!faults) return std::unexpected(faults.error());
      EXPECT_TRUE(faults->empty());
    }
    return {};
  }));
  EXPECT_EQ(must(store_->ledger().verify(job.id)), kRows);
  for (const std::uint32_t limit : {1U, 7U, 255U, 256U, 257U, 1000U}) {
    std::uint64_t seen = 0;
    PageRequest request{.limit = limit, .after = {}};
    do {
      const auto page = must(store_->ledger().rows(job.id, request));
      for (const LedgerRow& row : page.items) {
        ASSERT_EQ(row.seq, ++seen);
        ASSERT_EQ(row.note, fmt::format("row {}", seen));
      }
      request.after = page.next;
    } while (!request.after.empty());
    EXPECT_EQ(seen, kRows) << limit;
  }
  EXPECT_TRUE(must(store_->ledger().rows(job.id, {.limit = 10, .after = "1100"})).items.empty());
  EXPECT_TRUE(must(store_->ledger().rows(job.id, {.limit = 10, .after = "99999"})).items.empty());
}

TEST_F(LedgerTest, AMissingOrAlteredRowIsFound) {
  const Job job = add_job(*store_, "mill-1");
  for (std::uint64_t i = 0; i < 600; ++i) append(job.id, {i, i, 0, i + 1});
  EXPECT_EQ(must(store_->ledger().verify(job.id)), 600U);
  drop_trigger("ledger_update", "ledger");
  EXPECT_EQ(sql("UPDATE ledger SET handed = 3, clocked = 3 WHERE seq = 300"), "");
  EXPECT_EQ(refusal(store_->ledger().verify(job.id)), ErrorCode::corrupt);
  EXPECT_EQ(sql("UPDATE ledger SET handed = 299, clocked = 299 WHERE seq = 300"), "");
  EXPECT_EQ(must(store_->ledger().verify(job.id)), 600U);
  drop_trigger("ledger_delete", "ledger");
  EXPECT_EQ(sql("DELETE FROM ledger WHERE seq = 300"), "");
  EXPECT_EQ(refusal(store_->ledger().verify(job.id)), ErrorCode::corrupt);
}

// The time is printed, not asserted: it belongs to the machine that runs it.
TEST_F(LedgerTest, ManyLinesInOneCommit) {
  const Job first = add_job(*store_, "mill-0");
  std::vector<NewLedgerRow> rows{NewLedgerRow{first.id, {}, ""}};
  must(store_->atomically([&]() -> Result<void> {
    for (int i = 1; i < 512; ++i) {
      const auto job = store_->jobs().add({first.release, "link", 1'000'000}, by("anna"));
      if (!job) return std::unexpected(job.error());
      rows.push_back({job->id, {}, ""});
    }
    return {};
  }));
  const std::size_t commits = engine() == EngineKind::postgresql ? 20 : 200;  // a row is three round trips there
  std::vector<double> spent_ms;
  for (std::size_t i = 0; i < commits; ++i) {
    for (NewLedgerRow& row : rows) {
      row.counts.clocked = row.counts.handed = row.counts.reserve;
      row.counts.reserve += 96;
    }
    const auto start = std::chrono::steady_clock::now();
    const auto faults = must(store_->ledger().append(rows, static_cast<std::int64_t>(i)));
    spent_ms.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    ASSERT_TRUE(faults.empty());
  }
  std::ranges::sort(spent_ms);
  std::cout << "512 lines, one commit: median " << spent_ms[commits / 2] << " ms, 99 % " << spent_ms[commits * 99 / 100]
            << " ms, most " << spent_ms.back() << " ms\n";
  EXPECT_EQ(must(store_->ledger().interval(rows.back().job)).seq, commits);
}

}  // namespace
}  // namespace dripfeed::store_test
