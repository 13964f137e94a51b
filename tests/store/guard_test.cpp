// What the schema itself refuses, whoever asks: changes of what is append-only, references into nothing; and what
// atomically() undoes.
#include <array>

#include <fmt/format.h>

#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

using namespace store;

class Guard : public StoreTest {
 protected:
  Guard() {
    job_ = add_job(*store_, "mill-1");
    const Verdict verdict = must(store_->verdicts().list({})).items.at(0);
    must(store_->verdicts().waive(verdict.id, {.reason = "known"}, by("anna")));
    const std::array rows{NewLedgerRow{job_.id, {0, 0, 0, 10}, ""}};
    must(store_->ledger().append(rows, 1));
    must(store_->tokens().revoke(
        must(store_->tokens().add({.name = "mes", .role = Role::viewer, .hash = "hash"}, by("anna"))).id, by("anna")));
    must(store_->attachments().add(
        {.to = {.program = job_.program}, .name = "a", .media_type = "image/png", .sha256 = job_.text_sha256},
        by("anna")));
  }
  Job job_;
};

TEST_F(Guard, WhatIsAppendOnlyStays) {
  const std::array tables{"machine_revision", "family_revision", "part_revision", "program_revision",
                          "waiver",           "release_step",    "ledger",        "audit",
                          "verdict",          "text_release",    "job",           "token",
                          "content_chunk",    "attachment"};
  for (const std::string table : tables) {
    EXPECT_NE(
        sql(fmt::format("CREATE TEMP TABLE t (x INTEGER CHECK (x = 0)); INSERT INTO t SELECT count(*) FROM {}", table)),
        "")
        << table << " is empty: the test would pass for nothing";
    EXPECT_EQ(sql(fmt::format("DELETE FROM {}", table)), "append-only") << table;
    if (engine() == EngineKind::postgresql) {
      EXPECT_EQ(sql(fmt::format("TRUNCATE {} CASCADE", table)), "append-only") << table;
    } else {
      EXPECT_EQ(sql(fmt::format("UPDATE {} SET rowid = rowid + 100", table)), "append-only") << table;
      EXPECT_EQ(sql(fmt::format("REPLACE INTO {0} SELECT * FROM {0}", table)), "append-only") << table;
    }
  }
}

TEST_F(Guard, WhatMayChangeIsNarrow) {
  EXPECT_EQ(sql("UPDATE machine_revision SET profile = 'x'"), "append-only");
  EXPECT_EQ(sql("UPDATE verdict SET outcome = 'pass'"), "") << "no change is no change";
  EXPECT_EQ(sql("UPDATE verdict SET outcome = 'fail'"), "append-only");
  EXPECT_EQ(sql("UPDATE verdict SET stale = 1"), "");
  EXPECT_EQ(sql("UPDATE verdict SET stale = 0"), "append-only");
  EXPECT_EQ(sql("UPDATE text_release SET sha256 = sha256 || 'x'"), "append-only");
  EXPECT_EQ(sql("UPDATE text_release SET machine = 'mill-2'"), "append-only");
  EXPECT_EQ(sql("UPDATE job SET link = 'elsewhere'"), "append-only");
  EXPECT_EQ(sql("UPDATE job SET reason = 'x'"), "");
  EXPECT_EQ(sql("UPDATE token SET revoked_at_ms = 0"), "append-only");
  EXPECT_EQ(sql("UPDATE token SET role = 'admin'"), "append-only");
  EXPECT_EQ(sql("UPDATE content SET bytes = 1"), "append-only");
  EXPECT_EQ(sql("INSERT INTO content_chunk SELECT content, n + 1, data FROM content_chunk"), "append-only");
}

TEST_F(Guard, ReferencesAreKept) {
  const std::string chunk = fmt::format("INSERT INTO content_chunk VALUES (99, 0, {})", zero_byte());
  const std::array bad{
      "INSERT INTO machine_revision VALUES ('mill-9', 1, '', '', 0)",
      "INSERT INTO family_revision VALUES ('ring', 1, '', '', 0)",
      "INSERT INTO part_revision VALUES ('R-9', 1, 'roll', 1, '', '', 0)",
      "INSERT INTO part_revision VALUES ('R-100', 2, 'roll', 9, '', '', 0)",
      chunk.c_str(),
      "INSERT INTO waiver VALUES (99, 1, 'n', 'r', 0, '', 0)",
      "INSERT INTO verdict_point VALUES (99, 1, 'p')",
      "INSERT INTO release_step VALUES (99, 1, '', '', '', '', 0)",
      "INSERT INTO ledger VALUES (99, 99, 1, 0, 0, 0, 0, 0, '', NULL)",
      "DELETE FROM machine",
      "DELETE FROM family",
      "DELETE FROM part",
      "DELETE FROM program",
  };
  const char* const words = engine() == EngineKind::postgresql ? "foreign key constraint" : "FOREIGN KEY constraint";
  for (const char* statement : bad) EXPECT_NE(sql(statement).find(words), std::string::npos) << statement;
}

TEST_F(Guard, ALineFeedsOneJobInTheSchemaToo) {
  must(store_->jobs().add({job_.release, "link", 1}, by("anna")));
  EXPECT_EQ(sql("UPDATE job SET state = 'feeding'"), engine() == EngineKind::postgresql
                                                         ? "duplicate key value violates unique constraint \"job_line\""
                                                         : "UNIQUE constraint failed: job.machine");
}

TEST_F(Guard, AtomicallyIsAllOrNothing) {
  const auto result = store_->atomically([&]() -> Result<void> {
    must(store_->machines().add("mill-2", "p", by("anna")));
    EXPECT_EQ(must(store_->machines().get("mill-2")).profile, "p") << "it sees its own writes";
    must(store_->replies().keep({"mes", "r", "k", "x"}, {200, "", "", 1}));
    return std::unexpected(Error{ErrorCode::invalid_value, "stop"});
  });
  EXPECT_EQ(refusal(result), ErrorCode::invalid_value);
  EXPECT_EQ(refusal(store_->machines().get("mill-2")), ErrorCode::not_found);
  EXPECT_EQ(must(store_->replies().find({"mes", "r", "k", "x"})), std::nullopt);
  EXPECT_EQ(must(store_->audit().verify()).first_broken, std::nullopt);
}

TEST_F(Guard, AFailedCallInsideIsUndoneAlone) {
  must(store_->atomically([&]() -> Result<void> {
    must(store_->machines().add("mill-2", "p", by("anna")));
    EXPECT_EQ(refusal(store_->machines().add("mill-2", "q", by("anna"))), ErrorCode::exists);
    EXPECT_EQ(refusal(store_->atomically([&]() -> Result<void> {
                must(store_->machines().add("mill-3", "p", by("anna")));
                return std::unexpected(Error{ErrorCode::busy, ""});
              })),
              ErrorCode::busy);
    must(store_->machines().add("mill-4", "p", by("anna")));
    return {};
  }));
  EXPECT_TRUE(store_->machines().get("mill-2"));
  EXPECT_EQ(refusal(store_->machines().get("mill-3")), ErrorCode::not_found);
  EXPECT_TRUE(store_->machines().get("mill-4"));
  EXPECT_EQ(must(store_->audit().verify()).first_broken, std::nullopt);
}

TEST_F(Guard, AnExceptionUndoesAndTheStoreGoesOn) {
  EXPECT_THROW(static_cast<void>(store_->atomically([&]() -> Result<void> {
                 must(store_->machines().add("mill-2", "p", by("anna")));
                 throw 1;
               })),
               int);
  EXPECT_EQ(refusal(store_->machines().get("mill-2")), ErrorCode::not_found);
  must(store_->machines().add("mill-2", "p", by("anna")));
}

TEST_F(Guard, NumbersThatTheEngineCannotHoldAreRefused) {
  EXPECT_EQ(refusal(store_->jobs().add({job_.release, "link", ~std::uint64_t{0}}, by("anna"))),
            ErrorCode::invalid_value);
  EXPECT_EQ(refusal(store_->programs().get(~std::uint64_t{0})), ErrorCode::invalid_value);
}

}  // namespace
}  // namespace dripfeed::store_test
