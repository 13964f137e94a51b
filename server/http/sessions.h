// Who calls: API tokens in the Authorization header, or a browser's cookie that was given for one. Cookies live in
// memory: a restart asks for the token again. A revoked token ends its sessions with the next request.
#pragma once

#include <chrono>
#include <compare>
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
  std::string token_hash;
  std::string session;  // hash of the cookie; "" without one
  friend auto operator<=>(const Credential&, const Credential&) = default;
};

struct Caller {
  std::string name;
  Right right = Right::anybody;
  bool by_cookie = false;
  Credential credential{};
};

class Sessions {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kMostOfOne = 32;          // sessions of one token; the oldest goes
  static constexpr std::chrono::hours kIdle{12};         // a session that nobody uses
  static constexpr std::chrono::hours kLongest{7 * 24};  // any session

  explicit Sessions(store::Tokens& tokens, std::function<Clock::time_point()> now = Clock::now)
      : tokens_(tokens), now_(std::move(now)) {}
  // Nothing when there is no valid token behind the request. `version`: of the store (Store::version()), asked for with
  // this request: who was let in at the same one is let in again without asking. Nothing: the store is asked.
  std::optional<Caller> caller(const Request& request, std::optional<std::uint64_t> version = std::nullopt);
  // The cookie's value for this token; nothing when the token is not valid.
  std::optional<std::string> open(std::string_view token);
  void close(const Request& request);
  // Whether the token, and the session where there is one, is valid now. Does not count as a use.
  bool is_valid(const Credential& credential);

 private:
  struct Session {
    std::string token_hash;
    Clock::time_point opened;
    Clock::time_point used;
  };
  using Rows = std::map<std::string, Session>;  // by the hash of the cookie

  static constexpr std::size_t kMostKnown = 1024;  // then all are asked for anew

  std::optional<Caller> by_hash(const std::string& hash, std::optional<std::uint64_t> version = std::nullopt);
  std::optional<store::Token> token_of(const std::string& hash, std::optional<std::uint64_t> version);
  static bool has_expired(const Session& session, Clock::time_point now);
  // The session, unless it has expired: then it is forgotten.
  Rows::iterator live(const std::string& session);
  void make_room(const std::string& token_hash);

  store::Tokens& tokens_;
  std::function<Clock::time_point()> now_;
  std::mutex mutex_;
  Rows rows_;
  std::optional<std::uint64_t> known_version_;  // of the store that `known_` was read from
  std::map<std::string, store::Token> known_;   // valid tokens by their hash
};

// The cookie's value in a Cookie header, "" without one.
std::string cookie_value(std::string_view header, std::string_view name);

// A write by cookie must come from our own page: the browser says same-origin, or, where it says nothing (plain HTTP on
// a network), the Origin names our host, as the client or a trusted proxy calls it.
bool same_origin(const Request& request);

}  // namespace dripfeed::http
