// The cookie is the time at which it was given, a dot, and random characters.
#include "server/oidc/tickets.h"

#include <charconv>
#include <utility>

#include <fmt/format.h>

#include "store/hash/token.h"

namespace dripfeed::oidc {

namespace {

// 0 where it states none.
std::int64_t given_at_ms(std::string_view cookie) {
  const std::string_view digits = cookie.substr(0, cookie.find('.'));
  std::int64_t at_ms = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), at_ms);
  return error == std::errc{} && end == digits.data() + digits.size() ? at_ms : 0;
}

}  // namespace

Tickets::Tickets() : key_(hash::random_token()) {}

Ticket Tickets::of(std::string cookie) const {
  const auto derived = [&](std::string_view purpose) {
    return hash::derived_token(key_, fmt::format("{}:{}", purpose, cookie));
  };
  return {.cookie = cookie, .state = derived("state"), .nonce = derived("nonce"), .verifier = derived("verifier")};
}

Ticket Tickets::open(std::int64_t now_ms) const { return of(fmt::format("{}.{}", now_ms, hash::random_token())); }

app::Result<Ticket> Tickets::take(std::string_view cookie, std::string_view state, std::int64_t now_ms) {
  Ticket ticket = of(std::string(cookie));
  if (cookie.empty() || !hash::same_secret(ticket.state, state))
    return app::fail(app::ErrorCode::refused, "this browser did not begin this sign-in: begin it again");
  const std::int64_t at_ms = given_at_ms(cookie);
  if (now_ms < at_ms || now_ms - at_ms > kLast_ms)
    return app::fail(app::ErrorCode::refused, "this sign-in took too long: begin it again");
  const std::lock_guard lock(mutex_);
  std::erase_if(used_, [&](const auto& one) { return one.second < now_ms; });
  if (used_.size() >= kMostUsed) return app::fail(app::ErrorCode::unavailable, "too many sign-ins: try again later");
  if (!used_.emplace(ticket.state, at_ms + kLast_ms).second)
    return app::fail(app::ErrorCode::refused, "this sign-in was used before: begin it again");
  return ticket;
}

}  // namespace dripfeed::oidc
