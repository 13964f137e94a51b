// The journal's file at every byte at which a crash can tear it, and what is booked late: in its order, once, and
// without what can never be booked.
#include <atomic>
#include <filesystem>
#include <fstream>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "store/hash/sha256.h"
#include "store/journal/entry_text.h"
#include "store/journal/journaled_answers.h"
#include "store/journal/journaled_ledger.h"
#include "store/journal/local_contents.h"

namespace dripfeed::journal {
namespace {

using namespace std::chrono_literals;
using store::Error;
using store::ErrorCode;
using store::LedgerFault;
using store::NewLedgerRow;
using store::Result;

Entry entry(std::uint64_t serial, std::uint64_t handed, std::string note = {}) {
  Entry made{.serial = serial, .at_ms = static_cast<std::int64_t>(serial) * 100, .rows = {}, .answer = {}};
  made.rows.push_back({.job = 7, .counts = {handed, handed, 0, handed + 64}, .note = std::move(note)});
  return made;
}

bool is_same(const Entry& one, const Entry& other) { return text_of(one) == text_of(other); }

class JournalTest : public ::testing::Test {
 protected:
  JournalTest() {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~JournalTest() override { std::filesystem::remove_all(folder_); }
  [[nodiscard]] JournalFile open() const { return JournalFile::open(path_).value(); }
  [[nodiscard]] std::string bytes() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void write(std::string_view bytes) const {
    std::ofstream(path_, std::ios::binary | std::ios::trunc)
        .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / fmt::format("dripfeed-journal-{}", ::getpid());
  std::string path_ = (folder_ / "ledger.journal").string();
};

TEST_F(JournalTest, AnEntryComesBackWhateverItsTextsHave) {
  std::minstd_rand random(3);
  for (int run = 0; run < 2000; ++run) {
    Entry made = entry(random(), random());
    std::string any(random() % 20, ' ');
    std::ranges::generate(any, [&] { return static_cast<char>(random() % 256); });
    made.rows.front().note = any;
    if (run % 2 == 0)
      made.answer = AnswerStep{
          .machine = any, .to = store::AnswerState::torn, .bytes_total = 5, .reason = any + "\n", .actor = "7:x "};
    const std::string text = text_of(made);
    const auto back = entry_of(text);
    ASSERT_TRUE(back);
    ASSERT_EQ(back->answer, made.answer);
    ASSERT_EQ(back->rows.front().note, any);
    ASSERT_TRUE(is_same(*back, made));
    const std::size_t cut = random() % text.size();
    ASSERT_FALSE(entry_of(text.substr(0, cut))) << "a part of it is none";
  }
}

TEST_F(JournalTest, WhatWasKeptIsThereAfterACrashAtAnyByte) {
  std::vector<std::size_t> whole_at;
  {
    JournalFile file = open();
    for (std::uint64_t serial = 1; serial <= 4; ++serial) {
      ASSERT_TRUE(file.append(entry(serial, serial * 10, "a\nnote")));
      whole_at.push_back(bytes().size());
    }
  }
  const std::string all = bytes();
  const std::string name = open().name();
  const std::size_t title = all.find('\n') + 1;
  for (std::size_t cut = 0; cut <= all.size(); ++cut) {
    write(std::string_view(all).substr(0, cut));
    JournalFile file = open();
    const auto entries = file.take_entries();
    const auto expected =
        static_cast<std::size_t>(std::ranges::count_if(whole_at, [&](std::size_t whole) { return whole <= cut; }));
    ASSERT_EQ(entries.size(), expected) << "cut at byte " << cut;
    ASSERT_EQ(file.name() == name, cut >= title) << "the name is made once";
    ASSERT_TRUE(file.append(entry(99, 5)));
    const auto again = open().take_entries();
    ASSERT_EQ(again.size(), expected + 1) << "what follows a torn entry, cut at byte " << cut;
    ASSERT_TRUE(is_same(again.back(), entry(99, 5)));
  }
}

TEST_F(JournalTest, ADamageBeforeTheEndIsAnError) {
  std::size_t first_ends = 0;
  {
    JournalFile file = open();
    ASSERT_TRUE(file.append(entry(1, 10)));
    first_ends = bytes().size();
    ASSERT_TRUE(file.append(entry(2, 20)));
  }
  std::string damaged = bytes();
  damaged[first_ends - 5] ^= 1;
  write(damaged);
  const auto opened = JournalFile::open(path_);
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().code, ErrorCode::corrupt);
  EXPECT_EQ(bytes(), damaged) << "nothing of it is lost";
  write("another program's file\nwith lines\n");
  EXPECT_EQ(JournalFile::open(path_).error().code, ErrorCode::corrupt);
}

TEST_F(JournalTest, AClearedFileKeepsItsName) {
  const std::string name = open().name();
  JournalFile file = open();
  ASSERT_TRUE(file.append(entry(1, 10)));
  ASSERT_TRUE(file.clear());
  ASSERT_TRUE(file.append(entry(2, 20)));
  JournalFile again = open();
  EXPECT_EQ(again.name(), name);
  EXPECT_EQ(again.take_entries().front().serial, 2U);
}

// A database that answers when the test lets it.
struct Database {
  std::mutex mutex;
  std::vector<Entry> booked;
  std::atomic<bool> answers{true};
  std::vector<std::uint64_t> refused_serials;

  BookEntry book() {
    return [this](const Entry& next) -> Result<std::vector<LedgerFault>> {
      if (!answers) return std::unexpected(Error{ErrorCode::io_failed, "no database"});
      const std::lock_guard lock(mutex);
      if (std::ranges::find(refused_serials, next.serial) != refused_serials.end())
        return std::unexpected(Error{ErrorCode::broken_reference, "no such machine"});
      booked.push_back(next);
      return std::vector<LedgerFault>{};
    };
  }
  std::vector<std::uint64_t> serials() {
    const std::lock_guard lock(mutex);
    std::vector<std::uint64_t> found;
    for (const Entry& one : booked) found.push_back(one.serial);
    return found;
  }
};

TEST_F(JournalTest, WhatWaitsIsBookedInItsOrderAfterAnOutage) {
  Database database;
  auto journal = LedgerJournal::open(open(), 0, database.book()).value();
  ASSERT_TRUE(journal->keep(entry(0, 10)));
  ASSERT_TRUE(journal->wait_until_booked(5s));
  EXPECT_EQ(journal->late().commits, 0U);
  database.answers = false;
  for (std::uint64_t n = 2; n <= 20; ++n) ASSERT_TRUE(journal->keep(entry(0, n * 10)));
  EXPECT_FALSE(journal->wait_until_booked(100ms));
  EXPECT_EQ(journal->late().commits, 19U);
  EXPECT_NE(journal->late().why, "");
  database.answers = true;
  ASSERT_TRUE(journal->wait_until_booked(5s));
  EXPECT_EQ(journal->late().why, "");
  const auto serials = database.serials();
  ASSERT_EQ(serials.size(), 20U);
  for (std::size_t i = 0; i < serials.size(); ++i) EXPECT_EQ(serials[i], i + 1);
}

TEST_F(JournalTest, TheNextStartBooksWhatWasLeftAndNothingTwice) {
  Database database;
  {
    auto journal = LedgerJournal::open(open(), 0, database.book()).value();
    ASSERT_TRUE(journal->keep(entry(0, 10)));
    ASSERT_TRUE(journal->wait_until_booked(5s));
    database.answers = false;
    ASSERT_TRUE(journal->keep(entry(0, 20)));
    ASSERT_TRUE(journal->keep(entry(0, 30)));
  }
  EXPECT_FALSE(LedgerJournal::open(open(), 1, database.book())) << "it does not begin before they are booked";
  database.answers = true;
  auto journal = LedgerJournal::open(open(), 1, database.book()).value();
  EXPECT_EQ(database.serials(), (std::vector<std::uint64_t>{1, 2, 3}));
  EXPECT_EQ(journal->keep(entry(0, 40)).value(), 4U);
}

TEST_F(JournalTest, ADatabaseThatKnowsMoreGivesNoSerialAgain) {
  Database database;
  auto journal = LedgerJournal::open(open(), 41, database.book()).value();
  EXPECT_EQ(journal->keep(entry(0, 10)).value(), 42U);
}

TEST_F(JournalTest, WhatCanNeverBeBookedHoldsNothingUp) {
  Database database;
  database.refused_serials = {2};
  auto journal = LedgerJournal::open(open(), 0, database.book()).value();
  for (std::uint64_t n = 1; n <= 3; ++n) ASSERT_TRUE(journal->keep(entry(0, n * 10)));
  ASSERT_TRUE(journal->wait_until_booked(5s));
  EXPECT_EQ(database.serials(), (std::vector<std::uint64_t>{1, 3}));
  EXPECT_EQ(journal->late().faults, 1U);
  EXPECT_NE(journal->late().last_fault.find("no such machine"), std::string::npos) << journal->late().last_fault;
}

// The ledger of that database, with the rows that were booked.
class Booked final : public store::Ledger {
 public:
  explicit Booked(Database& database) : database_(database) {}
  Result<std::vector<LedgerFault>> append(std::span<const NewLedgerRow> /*rows*/, std::int64_t /*at_ms*/) override {
    return std::unexpected(Error{ErrorCode::internal, "rows go to the journal"});
  }
  Result<store::Page<store::LedgerRow>> rows(store::Id /*job*/, const store::PageRequest& /*page*/) override {
    return store::Page<store::LedgerRow>{};
  }
  Result<store::LedgerInterval> interval(store::Id job) override {
    const std::lock_guard lock(database_.mutex);
    store::LedgerInterval known;
    for (const Entry& one : database_.booked) {
      for (const NewLedgerRow& row : one.rows) {
        if (row.job == job) known = {row.counts.clocked, row.counts.reserve, known.seq + 1, one.at_ms, row.counts};
      }
    }
    return known;
  }
  Result<std::uint64_t> verify(store::Id /*job*/) override { return 0; }

 private:
  Database& database_;
};

TEST_F(JournalTest, TheIntervalHasTheRowsThatWait) {
  Database database;
  auto journal = LedgerJournal::open(open(), 0, database.book()).value();
  Booked booked(database);
  JournaledLedger ledger(booked, *journal);
  const auto append = [&](std::uint64_t handed, std::uint64_t reserve, std::int64_t at_ms) {
    const NewLedgerRow row{.job = 7, .counts = {handed, handed, 0, reserve}};
    return ledger.append(std::span(&row, 1), at_ms).value();
  };
  EXPECT_TRUE(append(0, 64, 100).empty());
  ASSERT_TRUE(journal->wait_until_booked(5s));
  database.answers = false;
  EXPECT_TRUE(append(50, 120, 200).empty());
  EXPECT_TRUE(append(110, 180, 300).empty());
  store::LedgerInterval known = ledger.interval(7).value();
  EXPECT_EQ(known.low, 110U);
  EXPECT_EQ(known.high, 180U);
  EXPECT_EQ(known.seq, 3U);
  database.answers = true;
  ASSERT_TRUE(journal->wait_until_booked(5s));
  known = ledger.interval(7).value();
  EXPECT_EQ(known.high, 180U);
  EXPECT_EQ(known.seq, 3U);
}

TEST_F(JournalTest, ARowThatBreaksTheRuleIsRefusedAtOnce) {
  Database database;
  auto journal = LedgerJournal::open(open(), 0, database.book()).value();
  Booked booked(database);
  JournaledLedger ledger(booked, *journal);
  const std::vector<NewLedgerRow> rows{{.job = 7, .counts = {0, 0, 0, 64}}, {.job = 8, .counts = {9, 10, 0, 64}}};
  const auto faults = ledger.append(rows, 100).value();
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults.front().job, 8U);
  EXPECT_FALSE(faults.front().written);
  const NewLedgerRow too_far{.job = 7, .counts = {70, 70, 0, 100}};
  EXPECT_TRUE(ledger.append(std::span(&too_far, 1), 200).value().front().written);
  const NewLedgerRow back{.job = 7, .counts = {60, 60, 0, 100}};
  EXPECT_FALSE(ledger.append(std::span(&back, 1), 300).value().front().written);
  ASSERT_TRUE(journal->wait_until_booked(5s));
  EXPECT_EQ(database.serials().size(), 2U);
}

class Contents final : public store::Contents {
 public:
  std::string text;
  Result<std::unique_ptr<store::ContentWriter>> begin() override { return std::unexpected(Error{}); }
  Result<store::Content> put(std::string_view /*bytes*/) override { return std::unexpected(Error{}); }
  Result<store::Content> find(std::string_view /*sha256*/) override { return std::unexpected(Error{}); }
  Result<std::size_t> read(std::string_view /*sha256*/, std::uint64_t offset, std::span<char> into) override {
    return text.copy(into.data(), into.size(), offset);
  }
  Result<void> verify(std::string_view /*sha256*/) override { return {}; }
  Result<std::uint64_t> total_bytes() override { return text.size(); }
};

TEST_F(JournalTest, AFedTextIsReadFromACopyThatLeavesNoFile) {
  Contents there;
  there.text = std::string(3'000'000, 'x') + "end";
  const std::string sha256 = hash::sha256_hex(there.text);
  LocalContents contents(there, folder_.string());
  const auto reader = contents.reader(sha256).value();
  there.text = "the database is gone";
  std::string tail(10, ' ');
  EXPECT_EQ(reader->read(3'000'000, tail).value(), 3U);
  EXPECT_EQ(tail.substr(0, 3), "end");
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
  EXPECT_EQ(contents.reader(sha256).error().code, ErrorCode::corrupt) << "other bytes than its hash says";
}

}  // namespace
}  // namespace dripfeed::journal
