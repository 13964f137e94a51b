// What binds a sign-in to the browser that began it. The browser keeps one random text in a cookie that no script
// reads; state, nonce and verifier are made of it and of a key that only this process has, so that nothing is kept for
// a browser that never comes back, and no text that was not given here has a state. Each may be used once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <string_view>

#include "server/app/base/error.h"

namespace dripfeed::oidc {

struct Ticket {
  std::string cookie;
  std::string state;     // comes back with the browser
  std::string nonce;     // comes back in the ID token
  std::string verifier;  // is shown to the token endpoint (PKCE)
};

class Tickets {
 public:
  static constexpr std::int64_t kLast_ms = std::int64_t{10} * 60'000;  // at the provider a password is typed
  static constexpr std::size_t kMostUsed = 10'000;

  Tickets();
  Ticket open(std::int64_t now_ms) const;
  // Errors: refused: another browser's, too late, used before; unavailable: too many are used at this time.
  app::Result<Ticket> take(std::string_view cookie, std::string_view state, std::int64_t now_ms);

 private:
  [[nodiscard]] Ticket of(std::string cookie) const;

  std::string key_;
  std::mutex mutex_;
  std::map<std::string, std::int64_t, std::less<>> used_;  // states, until when they could be used
};

}  // namespace dripfeed::oidc
