// Random tokens by libsodium.
#include "store/hash/token.h"

#include <array>

#include <sodium.h>

#include "store/hash/sha256.h"
#include "store/hash/sodium_start.h"

namespace dripfeed::hash {

namespace {

using Digest = std::array<unsigned char, 32>;

// Leaves nothing of the bytes.
std::string text_of(Digest& bytes) {
  constexpr int kVariant = sodium_base64_VARIANT_URLSAFE_NO_PADDING;
  std::string text(sodium_base64_ENCODED_LEN(bytes.size(), kVariant), '\0');
  sodium_bin2base64(text.data(), text.size(), bytes.data(), bytes.size(), kVariant);
  sodium_memzero(bytes.data(), bytes.size());
  text.pop_back();  // the final zero
  return text;
}

const unsigned char* bytes_of(std::string_view text) { return reinterpret_cast<const unsigned char*>(text.data()); }

}  // namespace

std::string random_token() {
  start_sodium();
  Digest secret{};
  randombytes_buf(secret.data(), secret.size());
  return text_of(secret);
}

std::string derived_token(std::string_view key, std::string_view text) {
  start_sodium();
  static_assert(crypto_auth_hmacsha256_BYTES == sizeof(Digest));
  crypto_auth_hmacsha256_state state;
  crypto_auth_hmacsha256_init(&state, bytes_of(key), key.size());
  crypto_auth_hmacsha256_update(&state, bytes_of(text), text.size());
  Digest code{};
  crypto_auth_hmacsha256_final(&state, code.data());
  return text_of(code);
}

std::string challenge_of(std::string_view verifier) {
  start_sodium();
  static_assert(crypto_hash_sha256_BYTES == sizeof(Digest));
  Digest digest{};
  crypto_hash_sha256(digest.data(), bytes_of(verifier), verifier.size());
  return text_of(digest);
}

std::string token_hash(std::string_view token) { return sha256_hex(token); }

bool same_secret(std::string_view a, std::string_view b) {
  return a.size() == b.size() && sodium_memcmp(a.data(), b.data(), a.size()) == 0;
}

}  // namespace dripfeed::hash
