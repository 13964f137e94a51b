// Who calls: API tokens in the Authorization header, or a browser's cookie that was given for one. Cookies live in
// memory: a restart asks for the token again. A revoked token ends its sessions with the next request.
#pragma once

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "server/http/request.h"
#include "server/http/router.h"
#include "store/store.h"

namespace dripfeed::http {

inline constexpr std::string_view kSessionCookie = "dripfeed_session";

struct Caller {
  std::string name;
  Right right = Right::anybody;
  bool by_cookie = false;
};

class Sessions {
 public:
  static constexpr std::size_t kMost = 10'000;  // beyond it any one goes: its browser signs in again

  explicit Sessions(store::Tokens& tokens) : tokens_(tokens) {}
  // Nothing when there is no valid token behind the request.
  std::optional<Caller> caller(const Request& request);
  // The cookie's value for this token; nothing when the token is not valid.
  std::optional<std::string> open(std::string_view token);
  void close(const Request& request);

 private:
  std::optional<Caller> by_hash(const std::string& hash);

  store::Tokens& tokens_;
  std::mutex mutex_;
  std::map<std::string, std::string> hashes_;  // cookie → token hash
};

// The cookie's value in a Cookie header, "" without one.
std::string cookie_value(std::string_view header, std::string_view name);

// A write by cookie must come from our own page: its Origin is our host, or the browser says same-origin.
bool same_origin(const Request& request);

}  // namespace dripfeed::http
