// Who calls: tokens, cookies given for them, revocation, and where a write by cookie may come from.
#include "server/http/sessions.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "store/hash/hash.h"

namespace dripfeed::http {
namespace {

class KnownTokens final : public store::Tokens {
 public:
  void give(const std::string& token, std::string name, store::Role role) {
    store::Token row;
    row.name = std::move(name);
    row.role = role;
    rows_[hash::token_hash(token)] = row;
  }
  void take(const std::string& token) { rows_.erase(hash::token_hash(token)); }

  int asked = 0;

  store::Result<store::Token> find(std::string_view token_hash) override {
    ++asked;
    const auto found = rows_.find(std::string(token_hash));
    if (found == rows_.end()) return std::unexpected(store::Error{store::ErrorCode::not_found, ""});
    return found->second;
  }
  store::Result<store::Token> add(std::string_view, store::Role, std::string_view, const store::Stamp&) override {
    return std::unexpected(store::Error{});
  }
  store::Result<store::Token> revoke(store::Id, const store::Stamp&) override {
    return std::unexpected(store::Error{});
  }
  store::Result<store::Page<store::Token>> list(const store::PageRequest&) override {
    return std::unexpected(store::Error{});
  }

 private:
  std::map<std::string, store::Token> rows_;
};

// Those of KnownTokens, as the store has it.
class KnownSessions final : public store::BrowserSessions {
 public:
  explicit KnownSessions(KnownTokens& tokens) : tokens_(tokens) {}

  int noted = 0;

  store::Result<void> open(std::string_view session_hash, std::string_view token_hash, std::size_t most,
                           std::int64_t at_ms) override {
    const auto token = tokens_.find(token_hash);
    if (!token) return std::unexpected(token.error());
    std::vector<std::string> own;
    for (const auto& [hash, row] : rows_)
      if (row.token_hash == token_hash) own.push_back(hash);
    std::ranges::sort(own, {}, [&](const std::string& hash) { return rows_[hash].used_at_ms; });
    for (std::size_t i = 0; i + most <= own.size(); ++i) rows_.erase(own[i]);
    rows_[std::string(session_hash)] = {*token, std::string(token_hash), at_ms, at_ms};
    return {};
  }
  store::Result<store::BrowserSession> find(std::string_view session_hash) override {
    const auto found = rows_.find(std::string(session_hash));
    if (found == rows_.end()) return std::unexpected(store::Error{store::ErrorCode::not_found, ""});
    const auto token = tokens_.find(found->second.token_hash);
    if (!token) return std::unexpected(token.error());
    store::BrowserSession session = found->second;
    session.token = *token;
    return session;
  }
  store::Result<void> note_use(std::string_view session_hash, std::int64_t at_ms) override {
    ++noted;
    rows_[std::string(session_hash)].used_at_ms = at_ms;
    return {};
  }
  store::Result<void> close(std::string_view session_hash) override {
    rows_.erase(std::string(session_hash));
    return {};
  }
  store::Result<void> forget(std::int64_t opened_before_ms, std::int64_t used_before_ms) override {
    std::erase_if(rows_, [&](const auto& row) {
      return row.second.opened_at_ms < opened_before_ms || row.second.used_at_ms < used_before_ms;
    });
    return {};
  }

 private:
  KnownTokens& tokens_;
  std::map<std::string, store::BrowserSession> rows_;
};

constexpr std::int64_t kSecond_ms = 1000;
constexpr std::int64_t kHour_ms = 3600 * kSecond_ms;

class SessionsTest : public ::testing::Test {
 protected:
  SessionsTest() { tokens_.give("secret", "olga", store::Role::operator_); }
  std::optional<Caller> by_header(std::string header) {
    Request request;
    request.authorization = std::move(header);
    return sessions_.caller(request);
  }
  std::optional<Caller> by_cookie(const std::string& header) {
    Request request;
    request.cookie = header;
    return sessions_.caller(request);
  }
  static std::string cookie(const std::string& value) { return std::string(kSessionCookie) + "=" + value; }

  KnownTokens tokens_;
  KnownSessions kept_{tokens_};
  std::int64_t now_ms_ = 1'700'000'000'000;
  Sessions sessions_{tokens_, kept_, [this] { return now_ms_; }};
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
    tokens_.give("t", "x", role);
    EXPECT_EQ(by_header("Bearer t")->right, right);
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
  tokens_.give("secret", "olga", store::Role::viewer);
  EXPECT_EQ(by_cookie(cookie(*value))->right, Right::viewer) << "a changed role counts at once";
  tokens_.take("secret");
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
  tokens_.give("admin", "anna", store::Role::admin);
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

TEST_F(SessionsTest, ASessionEndsWhenNobodyUsesItAndOneDayInAnyCase) {
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
  tokens_.take("secret");
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
  EXPECT_EQ(kept_.noted, 1);
  EXPECT_TRUE(sessions_.is_valid(held));
  EXPECT_EQ(kept_.noted, 1) << "not again and again";
  Sessions after{tokens_, kept_, [this] { return now_ms_; }};
  now_ms_ += Sessions::kIdle_ms / 2 + kSecond_ms;
  Request request;
  request.cookie = cookie(value);
  ASSERT_TRUE(after.caller(request)) << "used six hours ago, by another server";
  EXPECT_EQ(after.caller(request)->name, "olga");
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
  tokens_.take("secret");
  EXPECT_FALSE(sessions_.caller(request, 8)) << "a revocation changes the store";
  EXPECT_FALSE(sessions_.caller(request, 7)) << "nothing is left of what was known";
  EXPECT_FALSE(sessions_.caller(request));
}

TEST_F(SessionsTest, WithoutAVersionATokenIsAskedForEachTime) {
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(by_header("Bearer secret"));
  EXPECT_EQ(tokens_.asked, 3);
}

TEST_F(SessionsTest, ACookieOfARevokedTokenEndsWithTheNextVersion) {
  Request request;
  request.cookie = cookie(sessions_.open("secret").value());
  ASSERT_TRUE(sessions_.caller(request, 1).value().by_cookie);
  tokens_.take("secret");
  EXPECT_FALSE(sessions_.caller(request, 2));
}

}  // namespace
}  // namespace dripfeed::http
