// SHA-256 by libsodium.
#include "store/hash/sha256.h"

#include <sodium.h>

#include "store/hash/sodium_start.h"

namespace dripfeed::hash {
namespace {

using Sodium = crypto_hash_sha256_state;

std::string hex_of(std::span<const unsigned char> bytes) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  text.reserve(bytes.size() * 2);
  for (const unsigned char byte : bytes) {
    text.push_back(kDigits[byte >> 4U]);
    text.push_back(kDigits[byte & 15U]);
  }
  return text;
}

}  // namespace

Sha256::Sha256() {
  static_assert(sizeof(State) == sizeof(Sodium) && alignof(State) >= alignof(Sodium));
  start_sodium();
  crypto_hash_sha256_init(reinterpret_cast<Sodium*>(&state_));
}

void Sha256::add(std::string_view bytes) {
  crypto_hash_sha256_update(reinterpret_cast<Sodium*>(&state_), reinterpret_cast<const unsigned char*>(bytes.data()),
                            bytes.size());
}

void Sha256::add(std::span<const std::byte> bytes) {
  add(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

std::string Sha256::hex() const {
  State copy = state_;  // finishing destroys it
  std::array<unsigned char, crypto_hash_sha256_BYTES> digest{};
  crypto_hash_sha256_final(reinterpret_cast<Sodium*>(&copy), digest.data());
  return hex_of(digest);
}

std::string sha256_hex(std::string_view bytes) {
  Sha256 hash;
  hash.add(bytes);
  return hash.hex();
}

}  // namespace dripfeed::hash
