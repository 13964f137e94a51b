// libcjose reads keys and tokens and asks OpenSSL. Which algorithm may be used with which key is decided here, before
// it.
#include "server/oidc/key_set.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include <cjose/cjose.h>
#include <fmt/format.h>

#include "server/oidc/members.h"

namespace dripfeed::oidc {

// Of members of classes that the header names, so with a name.
namespace by_cjose {

struct AlgorithmRow {
  std::string_view name;
  cjose_jwk_kty_t type;
  cjose_jwk_ec_curve curve;  // of an elliptic one
};
struct Release {
  void operator()(cjose_jwk_t* key) const { cjose_jwk_release(key); }
  void operator()(cjose_jws_t* token) const { cjose_jws_release(token); }
};
using Key = std::unique_ptr<cjose_jwk_t, Release>;
using Token = std::unique_ptr<cjose_jws_t, Release>;

}  // namespace by_cjose

namespace {

using by_cjose::AlgorithmRow;

constexpr std::array kAlgorithms = {
    AlgorithmRow{"RS256", CJOSE_JWK_KTY_RSA, CJOSE_JWK_EC_INVALID},
    AlgorithmRow{"RS384", CJOSE_JWK_KTY_RSA, CJOSE_JWK_EC_INVALID},
    AlgorithmRow{"RS512", CJOSE_JWK_KTY_RSA, CJOSE_JWK_EC_INVALID},
    AlgorithmRow{"PS256", CJOSE_JWK_KTY_RSA, CJOSE_JWK_EC_INVALID},
    AlgorithmRow{"PS384", CJOSE_JWK_KTY_RSA, CJOSE_JWK_EC_INVALID},
    AlgorithmRow{"PS512", CJOSE_JWK_KTY_RSA, CJOSE_JWK_EC_INVALID},
    AlgorithmRow{"ES256", CJOSE_JWK_KTY_EC, CJOSE_JWK_EC_P_256},
    AlgorithmRow{"ES384", CJOSE_JWK_KTY_EC, CJOSE_JWK_EC_P_384},
    AlgorithmRow{"ES512", CJOSE_JWK_KTY_EC, CJOSE_JWK_EC_P_521},
};

const AlgorithmRow* row_of(std::string_view algorithm) {
  const auto* const row = std::ranges::find(kAlgorithms, algorithm, &AlgorithmRow::name);
  return row == kAlgorithms.end() ? nullptr : row;
}

std::string header_text(cjose_header_t* header, const char* name) {
  cjose_err error{};
  const char* const text = cjose_header_get(header, name, &error);
  return text == nullptr ? std::string() : std::string(text);
}

// "" where it is not there.
std::string raw_header(cjose_header_t* header, const char* name) {
  cjose_err error{};
  char* const raw = cjose_header_get_raw(header, name, &error);
  if (raw == nullptr) return {};
  std::string text(raw);
  std::free(raw);
  return text;
}

}  // namespace

bool is_taken_algorithm(std::string_view algorithm) { return row_of(algorithm) != nullptr; }

struct SignedToken::Parts {
  by_cjose::Token token;
  const AlgorithmRow* algorithm = nullptr;
  std::string key_id;
};

SignedToken::SignedToken(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
SignedToken::SignedToken(SignedToken&&) noexcept = default;
SignedToken& SignedToken::operator=(SignedToken&&) noexcept = default;
SignedToken::~SignedToken() = default;

app::Result<SignedToken> SignedToken::read(std::string_view compact) {
  cjose_err error{};
  auto parts = std::make_unique<Parts>();
  parts->token.reset(cjose_jws_import(compact.data(), compact.size(), &error));
  if (!parts->token) return refuse("it is not a signed token");
  cjose_header_t* const header = cjose_jws_get_protected(parts->token.get());
  const std::string algorithm = header_text(header, CJOSE_HDR_ALG);
  parts->algorithm = row_of(algorithm);
  if (parts->algorithm == nullptr) return refuse(fmt::format("its algorithm \"{}\" is not taken", algorithm));
  if (!raw_header(header, "crit").empty()) return refuse("its header asks for what is not known here");
  parts->key_id = header_text(header, CJOSE_HDR_KID);
  return SignedToken(std::move(parts));
}

struct KeySet::Key {
  by_cjose::Key key;
  cjose_jwk_kty_t type = CJOSE_JWK_KTY_RSA;
  cjose_jwk_ec_curve curve = CJOSE_JWK_EC_INVALID;
  std::string id;
  std::string algorithm;  // "": any of its type

  [[nodiscard]] bool is_for(const AlgorithmRow& row) const {
    return type == row.type && curve == row.curve && (algorithm.empty() || algorithm == row.name);
  }
};

KeySet::KeySet() = default;
KeySet::KeySet(KeySet&&) noexcept = default;
KeySet& KeySet::operator=(KeySet&&) noexcept = default;
KeySet::~KeySet() = default;

app::Result<KeySet> KeySet::read(std::string_view text) {
  const auto document = json::parse(text);
  const auto keys = document && document->is_object() ? document->find("keys") : json::Document::const_iterator();
  if (!document || !document->is_object() || keys == document->end() || !keys->is_array())
    return refuse("it has no list of keys");
  if (keys->size() > kMostKeys) return refuse(fmt::format("it has more than {} keys", kMostKeys));
  KeySet set;
  for (const json::Document& one : *keys) {
    if (!one.is_object()) continue;
    if (const std::string use = text_in(one, "use"); !use.empty() && use != "sig") continue;
    const std::string written = json::dump(one);
    cjose_err error{};
    Key key{.key = by_cjose::Key(cjose_jwk_import(written.data(), written.size(), &error)),
            .id = text_in(one, "kid"),
            .algorithm = text_in(one, "alg")};
    if (!key.key) continue;
    key.type = cjose_jwk_get_kty(key.key.get(), &error);
    if (key.type == CJOSE_JWK_KTY_EC) {
      key.curve = cjose_jwk_EC_get_curve(key.key.get(), &error);
    } else if (key.type != CJOSE_JWK_KTY_RSA || cjose_jwk_get_keysize(key.key.get(), &error) < kShortestRsa_bits) {
      continue;
    }
    set.keys_.push_back(std::move(key));
  }
  if (set.keys_.empty()) return refuse("it has no key that is taken here");
  return set;
}

const KeySet::Key* KeySet::find(const SignedToken& token) const {
  const SignedToken::Parts& parts = *token.parts_;
  const Key* found = nullptr;
  for (const Key& key : keys_) {
    if (!key.is_for(*parts.algorithm) || (!parts.key_id.empty() && key.id != parts.key_id)) continue;
    if (found != nullptr) return nullptr;  // which of them is not known
    found = &key;
  }
  return found;
}

bool KeySet::has_key_of(const SignedToken& token) const { return find(token) != nullptr; }

app::Result<std::string> KeySet::verify(const SignedToken& token) const {
  const Key* const key = find(token);
  if (key == nullptr) return refuse("the provider has no key of its key id and algorithm");
  cjose_err error{};
  cjose_jws_t* const parts = token.parts_->token.get();
  if (!cjose_jws_verify(parts, key->key.get(), &error)) return refuse("its signature is not by the provider's key");
  std::uint8_t* bytes = nullptr;
  std::size_t count = 0;
  if (!cjose_jws_get_plaintext(parts, &bytes, &count, &error)) return refuse("it has no content");
  return std::string(reinterpret_cast<const char*>(bytes), count);
}

}  // namespace dripfeed::oidc
