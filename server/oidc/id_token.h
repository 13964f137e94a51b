// What an ID token claims (OpenID Connect Core 1.0, 2 and 3.1.3.7), after its signature was verified.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/base/error.h"

namespace dripfeed::oidc {

// How much the provider's clock and ours may differ.
inline constexpr std::chrono::seconds kClockSkew{60};
// A token is used at once: one that was made longer ago is not of this sign-in.
inline constexpr std::chrono::seconds kOldestToken{600};

struct ExpectedClaims {
  std::string_view issuer;
  std::string_view client_id;
  std::string_view nonce;
  std::int64_t now_s = 0;  // since 1970
};

// Which claims hold what is wanted: a name, or names with dots between of objects inside each other.
struct ClaimNames {
  std::string name;
  std::string groups;  // "": none are read
};

// Of the token endpoint; "" where it is not there.
struct TokenAnswer {
  std::string id_token;
  std::string error;
};
TokenAnswer read_token_answer(std::string_view text);

struct Identity {
  std::string subject;
  std::string name;
  std::vector<std::string> groups;
};

// Errors: refused, as the end of a sentence: "it is of another issuer".
app::Result<Identity> read_id_token(std::string_view payload, const ExpectedClaims& expected, const ClaimNames& names);

}  // namespace dripfeed::oidc
