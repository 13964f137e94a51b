// The key is what the base64 after the prefix stands for.
#include "store/hash/webhook_secret.h"

#include <array>

#include <fmt/format.h>
#include <sodium.h>

#include "store/hash/sodium_start.h"

namespace dripfeed::hash {

namespace {

constexpr std::string_view kPrefix = "whsec_";
constexpr std::size_t kKey_bytes = 24;
constexpr int kVariant = sodium_base64_VARIANT_ORIGINAL;

std::string base64(const unsigned char* bytes, std::size_t count) {
  std::string text(sodium_base64_ENCODED_LEN(count, kVariant), '\0');
  sodium_bin2base64(text.data(), text.size(), bytes, count, kVariant);
  text.pop_back();  // the final zero
  return text;
}

std::optional<std::string> key_of(std::string_view secret) {
  if (!secret.starts_with(kPrefix)) return std::nullopt;
  secret.remove_prefix(kPrefix.size());
  std::string key(secret.size(), '\0');
  std::size_t length = 0;
  const int done = sodium_base642bin(reinterpret_cast<unsigned char*>(key.data()), key.size(), secret.data(),
                                     secret.size(), nullptr, &length, nullptr, kVariant);
  if (done != 0 || length == 0) return std::nullopt;
  key.resize(length);
  return key;
}

}  // namespace

std::string new_webhook_secret() {
  start_sodium();
  std::array<unsigned char, kKey_bytes> key{};
  randombytes_buf(key.data(), key.size());
  return std::string(kPrefix) + base64(key.data(), key.size());
}

std::optional<std::string> webhook_signature(std::string_view secret, const WebhookMessage& message) {
  start_sodium();
  const auto key = key_of(secret);
  if (!key) return std::nullopt;
  crypto_auth_hmacsha256_state state;
  crypto_auth_hmacsha256_init(&state, reinterpret_cast<const unsigned char*>(key->data()), key->size());
  const std::string head = fmt::format("{}.{}.", message.id, message.at_s);
  for (const std::string_view part : {std::string_view(head), message.body})
    crypto_auth_hmacsha256_update(&state, reinterpret_cast<const unsigned char*>(part.data()), part.size());
  std::array<unsigned char, crypto_auth_hmacsha256_BYTES> code{};
  crypto_auth_hmacsha256_final(&state, code.data());
  return "v1," + base64(code.data(), code.size());
}

}  // namespace dripfeed::hash
