// A lock counts from the store, so that a restart forgets none.
#include "server/app/shop/sign_in.h"

#include <algorithm>

#include <fmt/format.h>

#include "store/hash/hash.h"

namespace dripfeed::app {

namespace {

constexpr std::size_t kShortestPassword = 10;
constexpr std::size_t kLongestPassword = 200;
constexpr std::size_t kShortestPin = 4;
constexpr std::size_t kLongestPin = 12;
constexpr std::int64_t kMinute_ms = 60'000;
constexpr std::int64_t kLongestLock_ms = 60 * kMinute_ms;

// 1111, 1234, 9876.
bool is_run(std::string_view digits) {
  const int step = digits[1] - digits[0];
  if (step < -1 || step > 1) return false;
  for (std::size_t i = 1; i < digits.size(); ++i)
    if (digits[i] - digits[i - 1] != step) return false;
  return true;
}

std::string why_no_pin(std::string_view pin) {
  const bool has_digits = std::ranges::all_of(pin, [](char c) { return c >= '0' && c <= '9'; });
  if (!has_digits || pin.size() < kShortestPin || pin.size() > kLongestPin)
    return fmt::format("must have {} to {} digits and nothing else", kShortestPin, kLongestPin);
  return is_run(pin) ? "must not be one digit again and again, nor digits in a row" : "";
}

std::string why_no_password(std::string_view password, std::string_view user) {
  if (password.size() < kShortestPassword || password.size() > kLongestPassword)
    return fmt::format("must have {} to {} bytes", kShortestPassword, kLongestPassword);
  if (password.find('\0') != std::string_view::npos) return "must not have a zero byte";
  return password == user ? "must not be the name" : "";
}

}  // namespace

std::string why_no_secret(store::SecretKind kind, std::string_view secret, std::string_view user) {
  return kind == store::SecretKind::pin ? why_no_pin(secret) : why_no_password(secret, user);
}

std::int64_t lock_after(std::uint32_t failures) {
  if (failures < kFreeTries) return 0;
  constexpr std::uint32_t kMostDoublings = 6;
  return std::min(kMinute_ms << std::min(failures - kFreeTries, kMostDoublings), kLongestLock_ms);
}

Result<SignInAnswer> check_secret(store::Store& store, std::string_view user, store::SecretKind kind,
                                  std::string_view secret, const Clock& clock) {
  const std::int64_t now_ms = clock.wall_ms();
  const auto found = store.users().get(user);
  if (!found && found.error().code != store::ErrorCode::not_found) return std::unexpected(from_store(found.error()));
  if (found && found->locked_until_ms > now_ms) return SignInAnswer{SignIn::locked, found->locked_until_ms};
  std::string hash;
  if (found) {
    auto kept = lift(store.users().secret(user, kind));
    if (!kept) return std::unexpected(kept.error());
    hash = std::move(*kept);
  }
  const bool is_right = hash::is_password_of(secret, hash);
  if (!found) return SignInAnswer{};
  const store::Stamp by{"dripfeed", now_ms};
  if (!is_right || found->disabled_at_ms != 0) {
    const std::int64_t lock_ms = lock_after(found->failures + 1);
    const std::int64_t until_ms = lock_ms == 0 ? 0 : now_ms + lock_ms;
    if (auto noted = lift(store.users().note_refusal(user, until_ms, by)); !noted)
      return std::unexpected(noted.error());
    return SignInAnswer{};
  }
  if (auto cleared = lift(store.users().unlock(user, by)); !cleared) return std::unexpected(cleared.error());
  return SignInAnswer{SignIn::right, 0};
}

Result<store::User> set_secret(store::Store& store, std::string_view user, store::SecretKind kind,
                               std::string_view secret, const store::Stamp& by) {
  if (secret.empty()) return lift(store.users().set_secret(user, kind, "", by));
  if (const std::string why = why_no_secret(kind, secret, user); !why.empty())
    return fail(ErrorCode::invalid, fmt::format("the {} {}", store::name_of(kind), why));
  const auto hash = hash::password_hash(secret);
  if (!hash) return fail(ErrorCode::unavailable, "there is no memory to hash the secret");
  return lift(store.users().set_secret(user, kind, *hash, by));
}

}  // namespace dripfeed::app
