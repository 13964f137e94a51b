// The public keys of a provider (RFC 7517) and tokens that it signed (RFC 7515). Only asymmetric signatures are taken:
// who knows a public key, or no key, must not be able to sign.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/base/error.h"

namespace dripfeed::oidc {

// RS256 to RS512, PS256 to PS512, ES256 to ES512.
bool is_taken_algorithm(std::string_view algorithm);

// As it came: nothing of it is believed before KeySet::verify().
class SignedToken {
 public:
  // Errors: refused, as the end of a sentence: no token of three parts, an algorithm that is not taken, a header that
  // must be understood and is not (`crit`).
  static app::Result<SignedToken> read(std::string_view compact);
  SignedToken(SignedToken&&) noexcept;
  SignedToken& operator=(SignedToken&&) noexcept;
  ~SignedToken();

 private:
  friend class KeySet;
  struct Parts;
  explicit SignedToken(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

class KeySet {
 public:
  static constexpr std::size_t kShortestRsa_bits = 2048;
  static constexpr std::size_t kMostKeys = 100;

  // Keys that are for something else, or that cannot be read, are left out. Errors: refused, as the end of a sentence.
  static app::Result<KeySet> read(std::string_view text);
  KeySet(KeySet&&) noexcept;
  KeySet& operator=(KeySet&&) noexcept;
  ~KeySet();

  // By the token's key id and algorithm; without an id by the algorithm, where one key alone is of it.
  [[nodiscard]] bool has_key_of(const SignedToken& token) const;
  // The bytes that were signed. Errors: refused, as the end of a sentence: no key, another signature.
  [[nodiscard]] app::Result<std::string> verify(const SignedToken& token) const;

 private:
  struct Key;
  KeySet();
  [[nodiscard]] const Key* find(const SignedToken& token) const;
  std::vector<Key> keys_;
};

}  // namespace dripfeed::oidc
