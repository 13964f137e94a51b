// Signing in by a name with a password or a PIN: what a good secret is, who is let in, and who has to wait after too
// many wrong ones. A check takes about a tenth of a second and 64 MiB (argon2id): give it a thread of its own.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "server/app/base/error.h"
#include "server/app/ports/clock.h"
#include "store/store.h"

namespace dripfeed::app {

// What is wrong with a new password or PIN, as the end of a sentence ("must have …"); "" where nothing is.
std::string why_no_secret(store::SecretKind kind, std::string_view secret, std::string_view user);

enum class SignIn : std::uint8_t { right, wrong, locked };

struct SignInAnswer {
  SignIn outcome = SignIn::wrong;
  std::int64_t locked_until_ms = 0;  // of `locked`
};

// From the fifth wrong secret in a row each one locks the user: a minute, then twice as long each time, an hour at
// most.
inline constexpr std::uint32_t kFreeTries = 5;
std::int64_t lock_after(std::uint32_t failures);  // in milliseconds, 0: none

// Whether the secret is the user's. Who is not there, disabled, or has no such secret is `wrong`, and takes as long.
Result<SignInAnswer> check_secret(store::Store& store, std::string_view user, store::SecretKind kind,
                                  std::string_view secret, const Clock& clock);

// Sets a password or PIN; "" takes it away. Errors: not_found, invalid (see why_no_secret), unavailable (no memory).
Result<store::User> set_secret(store::Store& store, std::string_view user, store::SecretKind kind,
                               std::string_view secret, const store::Stamp& by);

}  // namespace dripfeed::app
