// Sessions of browsers: as many as may be, ended by their token, and forgotten when they are old.
#include "tests/store/fixture.h"

namespace dripfeed::store_test {
namespace {

using namespace store;

class BrowserSessionTest : public StoreTest {
 protected:
  void SetUp() override {
    StoreTest::SetUp();
    olga_ = must(store_->tokens().add({.name = "olga", .role = Role::operator_, .hash = "olga's"}, by("tester"))).id;
    must(store_->tokens().add({.name = "anna", .role = Role::admin, .hash = "anna's"}, by("tester")));
  }
  bool is_there(std::string_view session) { return store_->browser_sessions().find(session).has_value(); }

  Id olga_ = 0;
};

TEST_F(BrowserSessionTest, StandsForItsToken) {
  must(store_->browser_sessions().open("s", {.token_hash = "olga's"}, 8, 50));
  reopen({.own = true});
  const BrowserSession found = must(store_->browser_sessions().find("s"));
  EXPECT_EQ(found.token.value().name, "olga");
  EXPECT_EQ(found.token.value().role, Role::operator_);
  EXPECT_EQ(found.token_hash, "olga's");
  EXPECT_EQ(found.opened_at_ms, 50);
  EXPECT_EQ(found.used_at_ms, 50);
  EXPECT_EQ(store_->browser_sessions().find("t").error().code, ErrorCode::not_found);
  EXPECT_EQ(store_->browser_sessions().open("t", {.token_hash = "nobody's"}, 8, 50).error().code, ErrorCode::not_found);
  EXPECT_EQ(store_->browser_sessions().open("s", {.token_hash = "olga's"}, 8, 50).error().code, ErrorCode::exists);
  EXPECT_EQ(store_->browser_sessions().open("", {.token_hash = "olga's"}, 8, 50).error().code,
            ErrorCode::invalid_value);
}

TEST_F(BrowserSessionTest, EndsWithItsToken) {
  must(store_->browser_sessions().open("s", {.token_hash = "olga's"}, 8, 50));
  must(store_->browser_sessions().open("a", {.token_hash = "anna's"}, 8, 50));
  must(store_->tokens().revoke(olga_, by("tester", 60)));
  EXPECT_FALSE(is_there("s"));
  EXPECT_TRUE(is_there("a"));
  EXPECT_EQ(store_->browser_sessions().open("t", {.token_hash = "olga's"}, 8, 70).error().code, ErrorCode::not_found);
}

TEST_F(BrowserSessionTest, OfTooManyTheOneThatWasUsedLongestAgoEnds) {
  must(store_->browser_sessions().open("a", {.token_hash = "anna's"}, 3, 1));
  for (const auto& [name, at_ms] : {std::pair{"s1", 10}, {"s2", 20}, {"s3", 30}})
    must(store_->browser_sessions().open(name, {.token_hash = "olga's"}, 3, at_ms));
  must(store_->browser_sessions().note_use("s1", 35));
  must(store_->browser_sessions().note_use("s1", 34));
  must(store_->browser_sessions().open("s4", {.token_hash = "olga's"}, 3, 40));
  EXPECT_TRUE(is_there("s1")) << "it was used";
  EXPECT_EQ(must(store_->browser_sessions().find("s1")).used_at_ms, 35) << "a use never goes back";
  EXPECT_FALSE(is_there("s2"));
  EXPECT_TRUE(is_there("s3"));
  EXPECT_TRUE(is_there("s4"));
  EXPECT_TRUE(is_there("a")) << "another one's";
}

TEST_F(BrowserSessionTest, ClosesAndForgets) {
  for (const auto& [name, at_ms] : {std::pair{"s1", 10}, {"s2", 20}, {"s3", 30}})
    must(store_->browser_sessions().open(name, {.token_hash = "olga's"}, 8, at_ms));
  must(store_->browser_sessions().close("s2"));
  must(store_->browser_sessions().close("s2"));
  EXPECT_FALSE(is_there("s2"));
  must(store_->browser_sessions().note_use("s2", 60));
  EXPECT_FALSE(is_there("s2")) << "what has ended stays so";
  must(store_->browser_sessions().forget(15, 15));
  EXPECT_FALSE(is_there("s1"));
  EXPECT_TRUE(is_there("s3"));
}

}  // namespace
}  // namespace dripfeed::store_test
