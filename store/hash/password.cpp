// Argon2id by libsodium, at the cost that it names "interactive".
#include "store/hash/password.h"

#include <array>

#include <sodium.h>

#include "store/hash/sodium_start.h"

namespace dripfeed::hash {

static_assert(kPasswordMemory_bytes == crypto_pwhash_MEMLIMIT_INTERACTIVE);

std::optional<std::string> password_hash(std::string_view password) {
  start_sodium();
  std::array<char, crypto_pwhash_STRBYTES> text{};
  if (crypto_pwhash_str(text.data(), password.data(), password.size(), crypto_pwhash_OPSLIMIT_INTERACTIVE,
                        crypto_pwhash_MEMLIMIT_INTERACTIVE) != 0) {
    return std::nullopt;
  }
  return std::string(text.data());
}

// A name that no one has must not answer sooner than one with a wrong password.
bool is_password_of(std::string_view password, const std::string& hash) {
  start_sodium();
  static const std::optional<std::string> kOfNoUser = password_hash(std::string_view("\0", 1));
  const std::string& against = hash.empty() && kOfNoUser ? *kOfNoUser : hash;
  const bool is_right = crypto_pwhash_str_verify(against.c_str(), password.data(), password.size()) == 0;
  return is_right && !hash.empty();
}

}  // namespace dripfeed::hash
