// Who calls: tokens and users, cookies given for them, what ends them, and where a write by cookie may come from. The
// store is the real one.
#include "server/http/sessions.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "store/hash/hash.h"
#include "store/sqlite/open.h"

namespace dripfeed::http {
namespace {

// The store's, with a count of how often it was asked for one.
class CountedTokens final : public store::Tokens {
 public:
  explicit CountedTokens(store::Tokens& tokens) : tokens_(tokens) {}
  int asked = 0;
  bool answers = true;

  store::Result<store::Token> find(std::string_view token_hash) override {
    ++asked;
    if (!answers) return std::unexpected(store::Error{store::ErrorCode::io_failed, "no database"});
    return tokens_.find(token_hash);
  }
  store::Result<store::Token> add(const store::NewToken& token, const store::Stamp& by) override {
    return tokens_.add(token, by);
  }
  store::Result<store::Token> revoke(store::Id token, const store::Stamp& by) override {
    return tokens_.revoke(token, by);
  }
  store::Result<store::Page<store::Token>> list(const store::PageRequest& page) override { return tokens_.list(page); }

 private:
  store::Tokens& tokens_;
};

std::unique_ptr<store::Store> open_store(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  return sqlite::open((folder / "dripfeed.db").string(), {}).value();
}

const store::Stamp kBy{"tester", 5};

constexpr std::int64_t kSecond_ms = 1000;
constexpr std::int64_t kHour_ms = 3600 * kSecond_ms;

class SessionsTest : public ::testing::Test {
 protected:
  SessionsTest() { give("secret", "olga", store::Role::operator_); }
  ~SessionsTest() override {
    store_.reset();
    std::filesystem::remove_all(folder_);
  }
  void give(const std::string& token, std::string name, store::Role role, std::string user = {},
            std::int64_t expires_at_ms = 0) {
    ids_[token] = store_->tokens()
                      .add({.name = std::move(name),
                            .role = role,
                            .hash = hash::token_hash(token),
                            .user = std::move(user),
                            .expires_at_ms = expires_at_ms},
                           kBy)
                      .value()
                      .id;
  }
  void take(const std::string& token) { ASSERT_TRUE(store_->tokens().revoke(ids_[token], kBy)); }
  std::optional<Caller> by_header(std::string header) {
    Request request;
    request.authorization = std::move(header);
    auto caller = sessions_.caller(request);
    return caller ? std::optional(std::move(*caller)) : std::nullopt;
  }
  std::optional<Caller> by_cookie(const std::string& header) {
    Request request;
    request.cookie = header;
    auto caller = sessions_.caller(request);
    return caller ? std::optional(std::move(*caller)) : std::nullopt;
  }
  static std::string cookie(const std::string& value) { return std::string(kSessionCookie) + "=" + value; }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / fmt::format("dripfeed-sessions-{}", ::getpid());
  std::unique_ptr<store::Store> store_ = open_store(folder_);
  CountedTokens tokens_{store_->tokens()};
  std::map<std::string, store::Id> ids_;
  std::int64_t now_ms_ = 1'700'000'000'000;
  Sessions sessions_{tokens_, store_->users(), store_->browser_sessions(), [this] { return now_ms_; }};
};

TEST_F(SessionsTest, ATokenIsItsBearer) {
  for (const char* header : {"Bearer secret", "bearer secret", "BEARER secret"}) {
    const auto caller = by_header(header);
    ASSERT_TRUE(caller) << header;
    EXPECT_EQ(caller->name, "olga");
    EXPECT_EQ(caller->right, Right::operator_);
    EXPECT_FALSE(caller->by_cookie);
  }
  for (const char* header : {"", "secret", "Basic secret", "Bearer", "Bearer ", "Bearer secre", "Bearer  secret",
                             "Bearer secret ", "Bearersecret"}) {
    EXPECT_FALSE(by_header(header)) << header;
  }
}

TEST_F(SessionsTest, EveryRoleHasItsRight) {
  const std::pair<store::Role, Right> rows[] = {{store::Role::viewer, Right::viewer},
                                                {store::Role::operator_, Right::operator_},
                                                {store::Role::programmer, Right::programmer},
                                                {store::Role::approver, Right::approver},
                                                {store::Role::admin, Right::admin}};
  for (const auto& [role, right] : rows) {
    const std::string token = fmt::format("{}'s", store::name_of(role));
    give(token, "x", role);
    EXPECT_EQ(by_header("Bearer " + token)->right, right);
    EXPECT_EQ(name_of(right), store::name_of(role));
  }
}

TEST_F(SessionsTest, ACookieStandsForItsTokenAsLongAsThatIsValid) {
  EXPECT_FALSE(sessions_.open("wrong"));
  const auto value = sessions_.open("secret");
  ASSERT_TRUE(value);
  EXPECT_NE(*value, "secret");
  EXPECT_NE(*value, *sessions_.open("secret")) << "each sign-in has its own";
  const auto caller = by_cookie("a=b; " + cookie(*value) + "; c=d");
  ASSERT_TRUE(caller);
  EXPECT_TRUE(caller->by_cookie);
  EXPECT_EQ(caller->name, "olga");
  EXPECT_FALSE(by_cookie(cookie(*value + "x")));
  EXPECT_FALSE(by_cookie(cookie("")));
  EXPECT_FALSE(by_cookie("x" + cookie(*value)));
  take("secret");
  EXPECT_FALSE(by_cookie(cookie(*value))) << "a revoked token ends its sessions";
}

TEST_F(SessionsTest, SigningOutEndsThatSessionAlone) {
  const std::string first = *sessions_.open("secret");
  const std::string second = *sessions_.open("secret");
  Request request;
  request.cookie = cookie(first);
  ASSERT_TRUE(sessions_.close(request));
  EXPECT_FALSE(by_cookie(cookie(first)));
  EXPECT_TRUE(by_cookie(cookie(second)));
  EXPECT_TRUE(sessions_.close(request));
  EXPECT_TRUE(sessions_.close({}));
  EXPECT_TRUE(by_cookie(cookie(second)));
}

TEST_F(SessionsTest, SigningInOftenEndsOnlyOnesOwnSessions) {
  give("admin", "anna", store::Role::admin);
  const std::string admins = *sessions_.open("admin");
  std::vector<std::string> own;
  for (std::size_t i = 0; i < 30'000 / 100; ++i) {
    now_ms_ += kSecond_ms;
    own.push_back(*sessions_.open("secret"));
  }
  EXPECT_TRUE(by_cookie(cookie(admins))) << "another one's sign-ins";
  EXPECT_TRUE(by_cookie(cookie(own.back())));
  EXPECT_TRUE(by_cookie(cookie(own[own.size() - Sessions::kMostOfOne])));
  EXPECT_FALSE(by_cookie(cookie(own[own.size() - Sessions::kMostOfOne - 1]))) << "the oldest goes";
}

TEST_F(SessionsTest, ASessionEndsWhenNoOneUsesItAndOneDayInAnyCase) {
  const std::string value = *sessions_.open("secret");
  const Credential held = by_cookie(cookie(value))->credential;
  now_ms_ += Sessions::kIdle_ms - kSecond_ms;
  EXPECT_TRUE(by_cookie(cookie(value))) << "a use begins the time anew";
  now_ms_ += Sessions::kIdle_ms - kSecond_ms;
  EXPECT_TRUE(sessions_.is_valid(held)) << "looking is no use";
  now_ms_ += kSecond_ms;
  EXPECT_FALSE(sessions_.is_valid(held));
  EXPECT_FALSE(by_cookie(cookie(value)));
  const std::string busy = *sessions_.open("secret");
  const std::int64_t opened_ms = now_ms_;
  while (now_ms_ - opened_ms < Sessions::kLongest_ms) {
    EXPECT_TRUE(by_cookie(cookie(busy)));
    now_ms_ += 6 * kHour_ms;
  }
  EXPECT_FALSE(by_cookie(cookie(busy)));
}

TEST_F(SessionsTest, ACredentialIsValidAsLongAsItsToken) {
  const Credential by_token = by_header("Bearer secret")->credential;
  const Credential by_session = by_cookie(cookie(*sessions_.open("secret")))->credential;
  EXPECT_TRUE(sessions_.is_valid(by_token));
  EXPECT_TRUE(sessions_.is_valid(by_session));
  take("secret");
  EXPECT_FALSE(sessions_.is_valid(by_token));
  EXPECT_FALSE(sessions_.is_valid(by_session));
}

TEST_F(SessionsTest, AWrongTokenIsNotHelpedByACookie) {
  Request request;
  request.cookie = cookie(*sessions_.open("secret"));
  request.authorization = "Bearer wrong";
  EXPECT_FALSE(sessions_.caller(request));
}

TEST_F(SessionsTest, ASessionOutlivesTheServer) {
  const std::string value = *sessions_.open("secret");
  const Credential held = by_cookie(cookie(value))->credential;
  now_ms_ += Sessions::kIdle_ms / 2;
  ASSERT_TRUE(by_cookie(cookie(value)));
  EXPECT_TRUE(sessions_.is_valid(held)) << "and notes the use";
  EXPECT_EQ(store_->browser_sessions().find(held.session)->used_at_ms, now_ms_);
  Sessions after{tokens_, store_->users(), store_->browser_sessions(), [this] { return now_ms_; }};
  now_ms_ += Sessions::kIdle_ms / 2 + kSecond_ms;
  Request request;
  request.cookie = cookie(value);
  ASSERT_TRUE(after.caller(request)) << "used six hours ago, by another server";
  EXPECT_EQ(after.caller(request)->name, "olga");
}

TEST_F(SessionsTest, AUserHasTheRightsOfTheGroups) {
  ASSERT_TRUE(store_->machines().add("mill-1", "{}", kBy));
  ASSERT_TRUE(store_->users().put_group({.name = "mills", .machines = {"mill-1"}}, kBy));
  ASSERT_TRUE(
      store_->users().add("bert", {.role = store::Role::viewer, .grants = {{"mills", store::Role::approver}}}, kBy));
  const auto caller = by_cookie(cookie(*sessions_.open("bert", store::SecretKind::password)));
  ASSERT_TRUE(caller);
  EXPECT_EQ(caller->name, "bert");
  EXPECT_EQ(caller->right, Right::viewer);
  EXPECT_EQ(caller->on_machines.at("mill-1"), Right::approver);
  EXPECT_EQ(caller->signed_in_by, "password");
  const auto by_pin = by_cookie(cookie(*sessions_.open("bert", store::SecretKind::pin)));
  EXPECT_EQ(by_pin->on_machines.at("mill-1"), Right::operator_) << "a PIN gives no more";
  give("tablet", "a tablet", store::Role::operator_, "bert");
  const auto by_token = by_header("Bearer tablet");
  EXPECT_EQ(by_token->name, "bert") << "who acts is the user";
  EXPECT_EQ(by_token->on_machines.at("mill-1"), Right::operator_) << "up to the token's role";
  EXPECT_EQ(by_token->right, Right::viewer);
}

TEST_F(SessionsTest, ADisabledUserIsOutWithTokenAndCookie) {
  ASSERT_TRUE(store_->users().add("bert", {.role = store::Role::viewer}, kBy));
  give("tablet", "a tablet", store::Role::operator_, "bert");
  const std::string value = *sessions_.open("bert", store::SecretKind::pin);
  const Credential by_session = by_cookie(cookie(value))->credential;
  const Credential by_token = by_header("Bearer tablet")->credential;
  const Credential by_tokens_cookie = by_cookie(cookie(*sessions_.open("tablet")))->credential;
  for (const Credential& one : {by_session, by_token, by_tokens_cookie}) EXPECT_TRUE(sessions_.is_valid(one));
  ASSERT_TRUE(store_->users().change("bert", 1, {.roles = {}, .disabled = true}, kBy));
  EXPECT_FALSE(by_cookie(cookie(value)));
  EXPECT_FALSE(by_header("Bearer tablet"));
  for (const Credential& one : {by_session, by_token, by_tokens_cookie}) EXPECT_FALSE(sessions_.is_valid(one));
  EXPECT_FALSE(sessions_.open("bert", store::SecretKind::pin));
}

TEST_F(SessionsTest, ASessionByPinIsShort) {
  ASSERT_TRUE(store_->users().add("bert", {.role = store::Role::operator_}, kBy));
  const std::string value = *sessions_.open("bert", store::SecretKind::pin);
  now_ms_ += Sessions::kPinIdle_ms - kSecond_ms;
  EXPECT_TRUE(by_cookie(cookie(value)));
  now_ms_ += Sessions::kPinIdle_ms;
  EXPECT_FALSE(by_cookie(cookie(value)));
}

TEST_F(SessionsTest, ATokenEndsAtItsTime) {
  give("guest", "guest", store::Role::viewer, {}, now_ms_ + kHour_ms);
  const std::string value = *sessions_.open("guest");
  const Credential held = by_cookie(cookie(value))->credential;
  now_ms_ += kHour_ms - 1;
  EXPECT_TRUE(by_header("Bearer guest"));
  EXPECT_TRUE(sessions_.is_valid(held));
  now_ms_ += 1;
  EXPECT_FALSE(by_header("Bearer guest"));
  EXPECT_FALSE(by_cookie(cookie(value)));
  EXPECT_FALSE(sessions_.is_valid(held));
  EXPECT_FALSE(sessions_.open("guest"));
}

TEST(Cookies, AreFoundByTheirName) {
  EXPECT_EQ(cookie_value("a=1; b=2", "b"), "2");
  EXPECT_EQ(cookie_value("b=2", "b"), "2");
  EXPECT_EQ(cookie_value("ab=1;b=x=y", "b"), "x=y");
  EXPECT_EQ(cookie_value("b", "b"), "");
  EXPECT_EQ(cookie_value("", "b"), "");
  EXPECT_EQ(cookie_value(";;; ", "b"), "");
}

TEST(SameOrigin, IsOurHostOrTheBrowsersWord) {
  const auto is_same = [](std::string origin, std::string host, std::string site, std::string forwarded = {}) {
    Request request;
    request.forwarded_host = std::move(forwarded);
    request.origin = std::move(origin);
    request.host = std::move(host);
    request.fetch_site = std::move(site);
    return same_origin(request);
  };
  EXPECT_TRUE(is_same("http://shop:8840", "shop:8840", ""));
  EXPECT_TRUE(is_same("", "shop:8840", "same-origin"));
  EXPECT_FALSE(is_same("", "shop:8840", ""));
  EXPECT_FALSE(is_same("", "shop:8840", "cross-site"));
  EXPECT_TRUE(is_same("https://dnc.shop", "127.0.0.1:8840", "same-origin")) << "a proxy calls us by another name";
  EXPECT_FALSE(is_same("http://shop:8840", "shop:8840", "cross-site")) << "the browser's word counts";
  EXPECT_FALSE(is_same("http://shop:8840", "shop:8840", "same-site"));
  EXPECT_TRUE(is_same("http://dnc.shop", "127.0.0.1:8840", "", "dnc.shop")) << "as a trusted proxy says";
  EXPECT_FALSE(is_same("http://evil", "127.0.0.1:8840", "", "dnc.shop"));
  EXPECT_FALSE(is_same("http://shop:8840.evil", "shop:8840", ""));
  EXPECT_FALSE(is_same("http://evil/shop:8840", "shop:8840", ""));
  EXPECT_FALSE(is_same("null", "shop:8840", ""));
  EXPECT_FALSE(is_same("http://", "", ""));
}

TEST_F(SessionsTest, ATokenIsAskedForOnceAsLongAsTheStoreIsTheSame) {
  Request request;
  request.authorization = "Bearer secret";
  for (int i = 0; i < 3; ++i) ASSERT_EQ(sessions_.caller(request, 7).value().name, "olga");
  EXPECT_EQ(tokens_.asked, 1);
  take("secret");
  EXPECT_FALSE(sessions_.caller(request, 8)) << "a revocation changes the store";
  EXPECT_FALSE(sessions_.caller(request, 7)) << "nothing is left of what was known";
  EXPECT_FALSE(sessions_.caller(request));
}

TEST_F(SessionsTest, WhoWasLetInIsLetInWhileTheStoreDoesNotAnswer) {
  Request known;
  known.authorization = "Bearer secret";
  ASSERT_TRUE(sessions_.caller(known, 7));
  Request unknown;
  unknown.authorization = "Bearer other";
  tokens_.answers = false;
  EXPECT_EQ(sessions_.caller(known).value().name, "olga");
  EXPECT_EQ(sessions_.caller(known, 8).value().name, "olga");
  EXPECT_EQ(sessions_.caller(unknown).error().code, store::ErrorCode::io_failed) << "it is not known to be wrong";
  tokens_.answers = true;
  EXPECT_EQ(sessions_.caller(unknown).error().code, store::ErrorCode::not_found);
  take("secret");
  EXPECT_EQ(sessions_.caller(known, 9).error().code, store::ErrorCode::not_found);
  tokens_.answers = false;
  EXPECT_FALSE(sessions_.caller(known, 9)) << "a revoked one is forgotten";
}

TEST_F(SessionsTest, WithoutAVersionATokenIsAskedForEachTime) {
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(by_header("Bearer secret"));
  EXPECT_EQ(tokens_.asked, 3);
}

TEST_F(SessionsTest, ACookieOfARevokedTokenEndsWithTheNextVersion) {
  Request request;
  request.cookie = cookie(sessions_.open("secret").value());
  ASSERT_TRUE(sessions_.caller(request, 1).value().by_cookie);
  take("secret");
  EXPECT_FALSE(sessions_.caller(request, 2));
}

}  // namespace
}  // namespace dripfeed::http
