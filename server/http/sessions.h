// Who calls: API tokens in the Authorization header, or a browser's cookie that was given for a token or for a user's
// password or PIN, or for a user whom a provider vouched for. Sessions of browsers live in the store, so a restart of
// the server ends no session. A revoked token and a disabled user end their sessions with the next request.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "server/http/request.h"
#include "server/http/router.h"
#include "store/store.h"

namespace dripfeed::http {

inline constexpr std::string_view kSessionCookie = "dripfeed_session";

// What a caller was let in by.
struct Credential {
  std::string owner;    // hash of the token, or "user/7" for a user's session
  std::string session;  // hash of the cookie; "" without one
  friend auto operator<=>(const Credential&, const Credential&) = default;
};

struct Caller {
  std::string name;
  Right right = Right::anybody;                             // for all that belongs to no machine of `on_machines`
  std::map<std::string, Right, std::less<>> on_machines{};  // instead of `right`
  std::string scope{};                                      // what it may change, see rights.h; "": all that it may
  std::string signed_in_by{};                               // "token", "password", "pin", "provider"
  bool by_cookie = false;
  Credential credential{};
};

class Sessions {
 public:
  static constexpr std::size_t kMostOfOne = 32;  // sessions of one owner; the one that was used longest ago goes
  static constexpr std::int64_t kIdle_ms = std::int64_t{12} * 3600 * 1000;         // a session that is not used
  static constexpr std::int64_t kLongest_ms = std::int64_t{7} * 24 * 3600 * 1000;  // any session
  // A PIN is short and typed where others look on.
  static constexpr std::int64_t kPinIdle_ms = std::int64_t{30} * 60'000;
  static constexpr std::int64_t kPinLongest_ms = std::int64_t{12} * 3600 * 1000;
  static constexpr Right kPinRight = Right::operator_;  // at most

  // `now_ms`: milliseconds since 1970.
  Sessions(store::Tokens& tokens, store::Users& users, store::BrowserSessions& kept,
           std::function<std::int64_t()> now_ms)
      : tokens_(tokens), users_(users), kept_(kept), now_ms_(std::move(now_ms)) {}
  // `version`: of the store (Store::version()), asked for with this request: who was let in at the same one is let in
  // again without asking. Nothing: the store is asked. While it does not answer, who was let in before is let in: a
  // person must be able to stop a line that still feeds. Errors: not_found (no valid token or session), and those of a
  // store that cannot be read.
  store::Result<Caller> caller(const Request& request, std::optional<std::uint64_t> version = std::nullopt);
  // The cookie's value for this token. Errors: not_found (the token is not valid), and those of a store that cannot
  // write.
  store::Result<std::string> open(std::string_view token);
  // The same for a user whose password or PIN was right. Errors: not_found (disabled).
  store::Result<std::string> open(std::string_view user, store::SecretKind secret);
  // The same for a user whom a provider vouched for.
  store::Result<std::string> open_by_provider(std::string_view user);
  store::Result<void> close(const Request& request);
  // Whether the token or the user, and the session where there is one, is valid now. Does not count as a use. It may
  // write: the uses of this session that were not noted in the store yet.
  bool is_valid(const Credential& credential);

 private:
  // What a request by header or cookie stands for.
  struct Known {
    std::optional<store::Token> token;
    std::optional<store::Rights> user;  // of the session, or whose token it is
    std::string owner;
    store::SecretKind secret = store::SecretKind::password;  // without a token
    bool by_provider = false;
    std::int64_t opened_at_ms = 0;  // 0: no session
    std::int64_t used_at_ms = 0;
  };

  static constexpr std::size_t kMostKnown = 1024;                          // then all are asked for again
  static constexpr std::int64_t kNoteEvery_ms = std::int64_t{5} * 60'000;  // uses, in the store

  struct Remembered {
    Known known;
    std::uint64_t version = 0;  // of the store that said it
  };
  // Of a token (its hash) or of a session, from what is known at this version or from the store.
  store::Result<Known> known(const std::string& hash, bool is_session, std::optional<std::uint64_t> version);
  store::Result<Known> ask(const std::string& hash, bool is_session);
  static Caller caller_of(const Known& known);
  [[nodiscard]] bool has_expired(const Known& session, const std::string& hash) const;
  [[nodiscard]] bool has_ended(const std::optional<store::Token>& token) const;
  bool is_valid_session(const Credential& credential);
  store::Result<std::string> open_for(const store::SessionOwner& owner);

  store::Tokens& tokens_;
  store::Users& users_;
  store::BrowserSessions& kept_;
  std::function<std::int64_t()> now_ms_;
  std::mutex mutex_;
  std::map<std::string, Remembered> known_;   // by the hash of the token or of the cookie
  std::map<std::string, std::int64_t> used_;  // sessions: the last use here, later than the store's
};

// The cookie's value in a Cookie header, "" without one.
std::string cookie_value(std::string_view header, std::string_view name);

// A write by cookie must come from our own page: the browser says same-origin, or, where it says nothing (plain HTTP on
// a network), the Origin names our host, as the client or a trusted proxy calls it.
bool same_origin(const Request& request);

}  // namespace dripfeed::http
