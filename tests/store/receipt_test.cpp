// Receipts: kept as they came, decided once, and their contents stay.
#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

using namespace store;

class ReceiptTest : public StoreTest {
 protected:
  ReceiptTest() { must(store_->machines().add("mill-1", "{}", by("tester"))); }
  Receipt add(const std::string& text, bool quarantined = false, const std::string& machine = "mill-1") {
    const Content content = must(store_->contents().put(text));
    return must(store_->receipts().add({.machine = machine,
                                        .name = "O7",
                                        .style = "number",
                                        .sha256 = content.sha256,
                                        .raw_bytes = text.size(),
                                        .code = "iso",
                                        .ended_by = "percent",
                                        .quarantined = quarantined,
                                        .reason = quarantined ? "its end is missing" : ""},
                                       by("mill-1", 5000)));
  }
};

TEST_F(ReceiptTest, AreKeptAndListedNewestFirst) {
  const Receipt one = add("%\nO7\n%\n");
  const Receipt two = add("%\nO7\nG0", true);
  EXPECT_EQ(one.state, ReceiptState::stored);
  EXPECT_EQ(two.state, ReceiptState::quarantined);
  EXPECT_EQ(two.of.reason, "its end is missing");
  EXPECT_EQ(two.bytes, 7U);
  EXPECT_EQ(two.at_ms, 5000);
  const auto all = must(store_->receipts().list({}, {}));
  ASSERT_EQ(all.items.size(), 2U);
  EXPECT_EQ(all.items[0].id, two.id);
  EXPECT_EQ(must(store_->receipts().list({}, {.machine = "mill-1", .state = ReceiptState::stored})).items.size(), 1U);
  EXPECT_EQ(must(store_->receipts().list({}, {.machine = "other", .state = {}})).items.size(), 0U);
  EXPECT_EQ(must(store_->receipts().list({.limit = 1, .after = {}}, {})).next, std::to_string(two.id));
  EXPECT_EQ(refusal(store_->receipts().get(99)), ErrorCode::not_found);
  EXPECT_EQ(
      refusal(store_->receipts().add({.machine = "mill-1", .name = "X", .sha256 = std::string(64, '0')}, by("mill-1"))),
      ErrorCode::broken_reference);
}

TEST_F(ReceiptTest, TheSamePunchTwiceIsTwoReceipts) {
  const Receipt one = add("%\nO7\n%\n");
  const Receipt two = add("%\nO7\n%\n");
  EXPECT_NE(one.id, two.id);
  EXPECT_EQ(one.of.sha256, two.of.sha256);
}

TEST_F(ReceiptTest, AreDecidedOnce) {
  const Receipt one = add("%\nO7\n%\n");
  const Program program = must(store_->programs().add("O7", "fanuc", {.sha256 = one.of.sha256}, by("anna")));
  const Receipt accepted = must(store_->receipts().accept(one.id, program.id, 1, "", by("anna", 6000)));
  EXPECT_EQ(accepted.state, ReceiptState::accepted);
  EXPECT_EQ(accepted.program, program.id);
  EXPECT_EQ(accepted.decided_by, "anna");
  EXPECT_EQ(refusal(store_->receipts().discard(one.id, "no", by("otto"))), ErrorCode::refused_transition);
  EXPECT_EQ(refusal(store_->receipts().accept(one.id, program.id, 1, "", by("otto"))), ErrorCode::refused_transition);
  const Receipt two = add("%\nO8\n", true);
  EXPECT_EQ(refusal(store_->receipts().discard(two.id, "", by("otto"))), ErrorCode::invalid_value);
  EXPECT_EQ(must(store_->receipts().discard(two.id, "torn", by("otto"))).state, ReceiptState::discarded);
  EXPECT_EQ(sql("UPDATE receipt SET name = 'X'"), "append-only");
  EXPECT_EQ(sql("DELETE FROM receipt"), "append-only");
}

TEST_F(ReceiptTest, OneInQuarantineIsAcceptedWithAReasonThatTheAuditHas) {
  const Receipt torn = add("%\nO8\n", true);
  const Program program = must(store_->programs().add("O8", "fanuc", {.sha256 = torn.of.sha256}, by("anna")));
  EXPECT_EQ(refusal(store_->receipts().accept(torn.id, program.id, 1, "", by("anna"))), ErrorCode::invalid_value);
  const Receipt accepted = must(store_->receipts().accept(torn.id, program.id, 1, "only its % is missing", by("anna")));
  EXPECT_EQ(accepted.state, ReceiptState::accepted);
  EXPECT_TRUE(accepted.of.quarantined);
  EXPECT_EQ(accepted.decided_reason, "only its % is missing");
  const auto rows =
      must(store_->audit().list({.limit = 5, .after = {}}, {.subject = "receipt/" + std::to_string(torn.id)})).items;
  ASSERT_FALSE(rows.empty());
  EXPECT_NE(rows.front().entry.detail.find("out of quarantine: only its % is missing"), std::string::npos)
      << rows.front().entry.detail;
}

TEST_F(ReceiptTest, TheirContentsStayWhenTheStoreIsOpenedAgain) {
  const Receipt one = add("%\nO7\n%\n");
  must(store_->contents().put("nobody refers to this"));
  reopen({.own = true});
  must(store_->contents().verify(one.of.sha256));
  EXPECT_EQ(sql("DELETE FROM content_chunk"), "append-only");
}

TEST_F(ReceiptTest, RequestsAreListedByMachine) {
  must(store_->receipts().add_request({.machine = "mill-1",
                                       .verb = "load",
                                       .argument = "42",
                                       .text = "%",
                                       .outcome = "refused",
                                       .detail = "no such program",
                                       .job = 0},
                                      by("mill-1", 7000)));
  const auto all = must(store_->receipts().requests({}, "mill-1"));
  ASSERT_EQ(all.items.size(), 1U);
  EXPECT_EQ(all.items[0].of.argument, "42");
  EXPECT_EQ(all.items[0].at_ms, 7000);
  EXPECT_EQ(must(store_->receipts().requests({}, "other")).items.size(), 0U);
  EXPECT_EQ(sql("DELETE FROM request"), "append-only");
}

TEST_F(ReceiptTest, AReadBackStandsInItsJob) {
  const Job job = add_job(*store_, "lathe-1");
  EXPECT_EQ(job.read_back, "");
  EXPECT_EQ(must(store_->jobs().set_read_back(job.id, "equal", by("dripfeed"))).read_back, "equal");
  EXPECT_EQ(must(store_->jobs().get(job.id)).read_back, "equal");
  EXPECT_EQ(refusal(store_->jobs().set_read_back(99, "equal", by("dripfeed"))), ErrorCode::not_found);
}

}  // namespace
}  // namespace dripfeed::store_test
