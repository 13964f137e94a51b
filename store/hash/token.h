// Tokens: random secrets that people and programs show. Only their hashes are kept, so a copy of the store opens
// nothing. A token has 256 random bits, so a plain hash is enough (passwords would need argon2id).
#pragma once

#include <string>
#include <string_view>

namespace dripfeed::hash {

// 43 characters of base64url, from the system's random source. The program ends when libsodium cannot start: there is
// no safe step.
std::string random_token();
// What the store keeps and looks for.
std::string token_hash(std::string_view token);
// A token that only who has the key can make of the text again: 43 characters of base64url (HMAC-SHA256).
std::string derived_token(std::string_view key, std::string_view text);
// SHA-256 as 43 characters of base64url: what RFC 7636 asks for as the challenge of a verifier.
std::string challenge_of(std::string_view verifier);
// In constant time for equal lengths.
bool same_secret(std::string_view a, std::string_view b);

}  // namespace dripfeed::hash
