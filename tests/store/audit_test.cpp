// The audit's chain, tokens, idempotency keys.
#include <array>

#include <fmt/format.h>

#include "store/hash/hash.h"
#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

using namespace store;

class AuditTest : public StoreTest {
 protected:
  void fill() {
    for (int i = 1; i <= 10; ++i) {
      must(store_->audit().append({"login", fmt::format("token/{}", i % 2), fmt::format("from {}", i)}, by("anna", i)));
    }
  }
};

TEST_F(AuditTest, IsAChain) {
  EXPECT_EQ(must(store_->audit().verify()).rows, 0U);
  fill();
  reopen();
  const AuditCheck check = must(store_->audit().verify());
  EXPECT_EQ(check.rows, 10U);
  EXPECT_EQ(check.first_broken, std::nullopt);
  const auto page = must(store_->audit().list({.limit = 10, .after = {}}));
  ASSERT_EQ(page.items.size(), 10U);
  EXPECT_EQ(page.items[0].hash, check.head);
  for (std::size_t i = 0; i + 1 < page.items.size(); ++i) {
    EXPECT_EQ(page.items[i].previous_hash, page.items[i + 1].hash);
  }
  EXPECT_EQ(page.items[9].previous_hash, "");
  EXPECT_EQ(page.items[0].entry.detail, "from 10");
  EXPECT_EQ(page.items[0].by.at_ms, 10);
  const auto of_one = must(store_->audit().list({.limit = 3, .after = {}}, {.subject = "token/1"}));
  ASSERT_EQ(of_one.items.size(), 3U);
  EXPECT_EQ(of_one.items[0].seq, 9U);
  EXPECT_EQ(must(store_->audit().list({.limit = 3, .after = of_one.next}, {.subject = "token/1"})).items.size(), 2U);
}

TEST_F(AuditTest, EveryAlteredFieldIsFound) {
  fill();
  drop_trigger("audit_update", "audit");
  drop_trigger("audit_delete", "audit");
  const std::array changes{"at_ms = 5000",        "actor = 'eve'", "action = 'logout'",
                           "subject = 'token/9'", "detail = ''",   "hash = 'f' || substr(hash, 2)",
                           "previous_hash = hash"};
  EXPECT_EQ(sql("CREATE TABLE saved AS SELECT * FROM audit"), "");
  for (const char* change : changes) {
    EXPECT_EQ(sql(fmt::format("UPDATE audit SET {} WHERE seq = 4", change)), "");
    const auto broken = must(store_->audit().verify()).first_broken;
    EXPECT_TRUE(broken == 4U || broken == 5U) << change;
    EXPECT_EQ(sql("DELETE FROM audit; INSERT INTO audit SELECT * FROM saved"), "");
    EXPECT_EQ(must(store_->audit().verify()).first_broken, std::nullopt);
  }
}

TEST_F(AuditTest, AMissingRowIsFound) {
  fill();
  drop_trigger("audit_update", "audit");
  drop_trigger("audit_delete", "audit");
  const AuditCheck whole = must(store_->audit().verify());
  EXPECT_EQ(sql("DELETE FROM audit WHERE seq = 10"), "");
  EXPECT_NE(must(store_->audit().verify()).head, whole.head) << "a cut tail shows in the head only";
  EXPECT_EQ(sql("DELETE FROM audit WHERE seq = 6"), "");
  EXPECT_EQ(must(store_->audit().verify()).first_broken, 7U);
  EXPECT_EQ(sql("UPDATE audit SET seq = seq - 1 WHERE seq > 6"), "");
  EXPECT_EQ(must(store_->audit().verify()).first_broken, 6U);
  EXPECT_EQ(sql("DELETE FROM audit WHERE seq = 1"), "");
  EXPECT_EQ(must(store_->audit().verify()).first_broken, 2U);
}

// Whoever alters a row and gives it the right hash again breaks the row after it.
TEST_F(AuditTest, AHashMadeAgainIsFound) {
  fill();
  drop_trigger("audit_update", "audit");
  const auto page = must(store_->audit().list({.limit = 10, .after = {}}));
  AuditRow row = page.items.at(6);
  ASSERT_EQ(row.seq, 4U);
  const auto hash_with = [&](const std::string& detail) {
    std::string all;
    for (const std::string& field : {row.previous_hash, std::string("4"), fmt::format("{}", row.by.at_ms), row.by.actor,
                                     row.entry.action, row.entry.subject, detail}) {
      all += fmt::format("{}:{}", field.size(), field);
    }
    return hash::sha256_hex(all);
  };
  ASSERT_EQ(row.hash, hash_with(row.entry.detail)) << "the formula that an outside check would use";
  EXPECT_EQ(sql(fmt::format("UPDATE audit SET detail = 'evil', hash = '{}' WHERE seq = 4", hash_with("evil"))), "");
  EXPECT_EQ(must(store_->audit().verify()).first_broken, 5U);
}

// Fields are hashed with their lengths: moving a letter from one to the next is another row.
TEST_F(AuditTest, FieldsDoNotFlowTogether) {
  must(store_->audit().append({"ab", "c", "d"}, by("anna", 1)));
  drop_trigger("audit_update", "audit");
  EXPECT_EQ(sql("UPDATE audit SET action = 'a', subject = 'bc'"), "");
  EXPECT_EQ(must(store_->audit().verify()).first_broken, 1U);
}

TEST_F(AuditTest, EveryChangeLeavesARow) {
  const Job job = add_job(*store_, "mill-1");
  bring(*store_, job.id, JobState::held);
  must(store_->jobs().move(job.id, {JobState::failed, "SYN", true}, by("line")));
  must(store_->jobs().confirm_reset("mill-1", "reset", by("olga")));
  must(store_->machines().change("mill-1", 1, "p2", by("anna")));
  must(store_->families().change("roll", 1, "f2", by("anna")));
  must(store_->parts().change("R-100", 1, {"roll", 2, "{}"}, by("anna")));
  const Verdict verdict = add_verdict(*store_, must(store_->programs().get(job.program)), "mill-1");
  must(store_->verdicts().waive(verdict.id, {.reason = "known"}, by("anna")));
  const Token token = must(store_->tokens().add({.name = "mes", .role = Role::viewer, .hash = "hash"}, by("anna")));
  must(store_->tokens().revoke(token.id, by("anna")));
  std::vector<std::string> seen;
  const auto page = must(store_->audit().list({.limit = 100, .after = {}}));
  for (auto row = page.items.rbegin(); row != page.items.rend(); ++row) seen.push_back(row->entry.action);
  EXPECT_EQ(seen,
            (std::vector<std::string>{
                "machine.add",  "family.add",   "part.add",      "program.add",       "verdict.add",    "release.add",
                "release.move", "release.move", "group.put",     "release.move",      "group.remove",   "job.add",
                "job.move",     "job.move",     "job.move",      "job.confirm_reset", "machine.change", "family.change",
                "part.change",  "verdict.add",  "verdict.waive", "token.add",         "token.revoke"}))
      << "armed, feeding, failed; a hold is not told";
  EXPECT_EQ(must(store_->audit().verify()).first_broken, std::nullopt);
}

TEST_F(AuditTest, ARefusedChangeLeavesNone) {
  must(store_->machines().add("mill-1", "p", by("anna")));
  EXPECT_EQ(refusal(store_->machines().add("mill-1", "p", by("anna"))), ErrorCode::exists);
  EXPECT_EQ(refusal(store_->machines().change("mill-1", 7, "p", by("anna"))), ErrorCode::stale_revision);
  EXPECT_EQ(must(store_->audit().verify()).rows, 1U);
}

class TokenTest : public StoreTest {};

TEST_F(TokenTest, IsFoundByItsHashUntilItIsRevoked) {
  const std::string secret = hash::random_token();
  const Token made = must(
      store_->tokens().add({.name = "mes", .role = Role::operator_, .hash = hash::token_hash(secret)}, by("anna", 5)));
  reopen();
  const Token found = must(store_->tokens().find(hash::token_hash(secret)));
  EXPECT_EQ(found.id, made.id);
  EXPECT_EQ(found.name, "mes");
  EXPECT_EQ(found.role, Role::operator_);
  EXPECT_EQ(found.created_by, "anna");
  EXPECT_EQ(found.created_at_ms, 5);
  EXPECT_EQ(refusal(store_->tokens().find(secret)), ErrorCode::not_found) << "the secret itself is not kept";
  EXPECT_EQ(refusal(store_->tokens().add({.name = "other", .role = Role::viewer, .hash = hash::token_hash(secret)},
                                         by("anna"))),
            ErrorCode::exists);
  EXPECT_EQ(must(store_->tokens().revoke(made.id, by("bert", 9))).revoked_at_ms, 9);
  EXPECT_EQ(refusal(store_->tokens().find(hash::token_hash(secret))), ErrorCode::not_found);
  EXPECT_EQ(must(store_->tokens().revoke(made.id, by("bert", 10))).revoked_at_ms, 9) << "twice changes nothing";
  EXPECT_EQ(must(store_->tokens().list({})).items.at(0).revoked_at_ms, 9);
  EXPECT_EQ(refusal(store_->tokens().revoke(99, by("bert"))), ErrorCode::not_found);
  EXPECT_EQ(refusal(store_->tokens().add({.name = "", .role = Role::viewer, .hash = "h"}, by("anna"))),
            ErrorCode::invalid_value);
  EXPECT_EQ(refusal(store_->tokens().add({.name = "n", .role = Role::viewer, .hash = ""}, by("anna"))),
            ErrorCode::invalid_value);
}

class ReplyTest : public StoreTest {};

TEST_F(ReplyTest, TheSameRequestGetsTheSameAnswer) {
  const ReplyKey key{"mes", "POST /jobs", "k-1", "aaa"};
  EXPECT_EQ(must(store_->replies().find(key)), std::nullopt);
  must(store_->replies().keep(key, {201, "Location: /jobs/1", "{\"id\":1}", 5}));
  reopen();
  const auto reply = must(store_->replies().find(key));
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->status, 201);
  EXPECT_EQ(reply->headers, "Location: /jobs/1");
  EXPECT_EQ(reply->body, "{\"id\":1}");
  EXPECT_EQ(reply->at_ms, 5);
  EXPECT_EQ(refusal(store_->replies().keep(key, {200, "", "", 6})), ErrorCode::exists);
  ReplyKey other = key;
  other.request_sha256 = "bbb";
  EXPECT_EQ(refusal(store_->replies().find(other)), ErrorCode::key_reused);
  other = key;
  other.route = "POST /parts";
  EXPECT_EQ(must(store_->replies().find(other)), std::nullopt);
  other = key;
  other.actor = "eve";
  EXPECT_EQ(must(store_->replies().find(other)), std::nullopt);
  EXPECT_EQ(refusal(store_->replies().keep({"mes", "r", "", "x"}, {200, "", "", 6})), ErrorCode::invalid_value);
}

TEST_F(ReplyTest, OldOnesAreForgotten) {
  for (int i = 0; i < 5; ++i) must(store_->replies().keep({"mes", "r", fmt::format("k{}", i), "x"}, {200, "", "", i}));
  EXPECT_EQ(must(store_->replies().forget_before(3)), 3U);
  EXPECT_EQ(must(store_->replies().find({"mes", "r", "k2", "x"})), std::nullopt);
  EXPECT_TRUE(must(store_->replies().find({"mes", "r", "k3", "x"})));
}

}  // namespace
}  // namespace dripfeed::store_test
