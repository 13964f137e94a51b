// A whole store has no fault, and each kind of damage is found by name: the file is changed by SQL that passes the
// triggers' back, as a person with an editor would.
#include "store/sqlite/verify.h"

#include <filesystem>

#include <gmock/gmock.h>

#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

using namespace store;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class VerifyTest : public StoreTest {
 protected:
  VerifyTest() {
    job_ = add_job(*store_, "mill-1").id;
    bring(*store_, job_, JobState::feeding);
    for (std::uint64_t i = 0; i < 600; ++i) {
      const NewLedgerRow row{job_, {.handed = i * 10, .clocked = i * 10, .confirmed = 0, .reserve = i * 10 + 96}, ""};
      must(store_->ledger().append(std::span(&row, 1), 1000));
    }
  }
  [[nodiscard]] sqlite::Verification found() const { return must(sqlite::verify(path())); }
  // Damages the store as its own triggers would never let it.
  void damage(const std::string& change) {
    store_.reset();
    std::string drop;
    for (const char* const trigger : {"ledger_update", "ledger_delete", "audit_update", "audit_delete", "job_update",
                                      "content_chunk_update", "content_chunk_delete"}) {
      drop += std::string("DROP TRIGGER IF EXISTS ") + trigger + ";";
    }
    ASSERT_EQ(sql(drop + change), "");
  }
  void expect_fault(const std::string& subject, const std::string& what) const {
    for (const sqlite::VerifyFault& fault : found().faults) {
      if (fault.subject == subject && fault.what.find(what) != std::string::npos) return;
    }
    ADD_FAILURE() << subject << ": " << what << " is not among " << found().faults.size() << " faults";
  }

  Id job_ = 0;
};

TEST_F(VerifyTest, AWholeStoreWhileItsServerRuns) {
  reopen({.own = true});
  const sqlite::Verification whole = found();
  for (const sqlite::VerifyFault& fault : whole.faults) ADD_FAILURE() << fault.subject << ": " << fault.what;
  EXPECT_EQ(whole.jobs, 1U);
  EXPECT_EQ(whole.ledger_rows, 600U);
  EXPECT_GT(whole.audit_rows, 3U);
  EXPECT_EQ(whole.audit_head, must(store_->audit().verify()).head);
  EXPECT_GE(whole.contents, 1U);
  EXPECT_EQ(whole.torn_machines, 0U);
}

TEST_F(VerifyTest, WritesNothing) {
  store_.reset();
  const auto before = std::filesystem::last_write_time(path());
  EXPECT_THAT(found().faults, IsEmpty());
  EXPECT_EQ(std::filesystem::last_write_time(path()), before);
  EXPECT_EQ(refusal(sqlite::verify(folder_.file("none.db"))), ErrorCode::cannot_open);
  EXPECT_FALSE(std::filesystem::exists(folder_.file("none.db")));
}

TEST_F(VerifyTest, ATornMachineIsNoFault) {
  must(store_->jobs().move(job_, {.to = JobState::failed, .reason = "cut", .torn = true}, by("server")));
  EXPECT_EQ(found().torn_machines, 1U);
  EXPECT_THAT(found().faults, IsEmpty());
}

TEST_F(VerifyTest, AnAlteredAuditRow) {
  damage("UPDATE audit SET actor = 'nobody' WHERE seq = 3");
  expect_fault("audit/3", "the chain breaks here");
}

TEST_F(VerifyTest, AnAuditRowThatWasTakenOut) {
  damage("DELETE FROM audit WHERE seq = 2");
  expect_fault("audit/3", "the chain breaks here");
}

TEST_F(VerifyTest, ALedgerRowThatWasTakenOut) {
  damage("DELETE FROM ledger WHERE seq = 300");
  expect_fault("job/1", "the ledger breaks at row 301 of job 1");
  expect_fault("job/1", "ends with row 600, but has 599 rows");
}

TEST_F(VerifyTest, ALedgerCountThatFell) {
  damage("UPDATE ledger SET handed = 10, clocked = 10 WHERE seq = 500");
  expect_fault("job/1", "row 500 of job 1");
}

TEST_F(VerifyTest, MoreHandedThanReserved) {
  damage("UPDATE ledger SET reserve = handed WHERE seq = 400");
  expect_fault("job/1", "row 401 of job 1");
}

TEST_F(VerifyTest, ARowThatNoListReaches) {
  damage(
      "INSERT INTO ledger SELECT 9999, job, seq, at_ms, handed, clocked, confirmed, reserve, note, previous FROM "
      "ledger WHERE seq = 600");
  expect_fault("job/1", "ends with row 600, but has 601 rows");
}

TEST_F(VerifyTest, AContentOfAnotherHash) {
  damage("UPDATE content_chunk SET data = CAST(replace(CAST(data AS TEXT), 'M30', 'M99') AS BLOB)");
  const std::string sha256 = [&] {
    reopen();
    return must(store_->jobs().get(job_)).text_sha256;
  }();
  expect_fault("content/" + sha256, "do not have this hash");
}

TEST_F(VerifyTest, MarksThatCannotBe) {
  damage("UPDATE job SET torn = 1");
  expect_fault("job/1", "marked torn, but it did not break off");
  expect_fault("machine/mill-1", "a job has its line, although a torn block waits");
}

TEST_F(VerifyTest, ADamagedFile) {
  store_.reset();
  const auto bytes = std::filesystem::file_size(path());
  std::FILE* const file = std::fopen(path().c_str(), "r+b");
  ASSERT_NE(file, nullptr);
  for (std::uintmax_t at = 8192; at + 4096 < bytes; at += 8192) {
    std::fseek(file, static_cast<long>(at), SEEK_SET);
    std::fputs("damaged", file);
  }
  std::fclose(file);
  const auto seen = sqlite::verify(path());
  if (seen) {
    EXPECT_GE(seen->faults.size(), 1U);
  } else {
    EXPECT_EQ(seen.error().code, ErrorCode::corrupt);
  }
}

}  // namespace
}  // namespace dripfeed::store_test
