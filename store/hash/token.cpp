// Random tokens by libsodium.
#include "store/hash/token.h"

#include <array>

#include <sodium.h>

#include "store/hash/sha256.h"
#include "store/hash/sodium_start.h"

namespace dripfeed::hash {

std::string random_token() {
  start_sodium();
  std::array<unsigned char, 32> secret{};
  randombytes_buf(secret.data(), secret.size());
  constexpr int kVariant = sodium_base64_VARIANT_URLSAFE_NO_PADDING;
  std::string text(sodium_base64_ENCODED_LEN(secret.size(), kVariant), '\0');
  sodium_bin2base64(text.data(), text.size(), secret.data(), secret.size(), kVariant);
  sodium_memzero(secret.data(), secret.size());
  text.pop_back();  // the final zero
  return text;
}

std::string token_hash(std::string_view token) { return sha256_hex(token); }

bool same_secret(std::string_view a, std::string_view b) {
  return a.size() == b.size() && sodium_memcmp(a.data(), b.data(), a.size()) == 0;
}

}  // namespace dripfeed::hash
