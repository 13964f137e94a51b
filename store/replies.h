// Replies under idempotency keys: the same request with the same key gets the same answer and has its effect once.
// keep() belongs into the same Store::atomically() as the effect.
#pragma once

#include <optional>

#include "store/basics.h"
#include "store/error.h"

namespace dripfeed::store {

struct ReplyKey {
  std::string actor{};  // keys of different people never meet
  std::string route{};  // method and path
  std::string key{};
  std::string request_sha256{};
};

struct Reply {
  std::uint16_t status = 0;
  std::string headers{};  // as the caller writes them; not read here
  std::string body{};
  std::int64_t at_ms = 0;
};

class Replies : public Repository {
 public:
  // What was answered before, if anything. Errors: key_reused (the key is known with another request).
  virtual Result<std::optional<Reply>> find(const ReplyKey& key) = 0;
  // Errors: exists, invalid_value (empty key).
  virtual Result<void> keep(const ReplyKey& key, const Reply& reply) = 0;
  // Forgets answers from before this time; how many.
  virtual Result<std::uint64_t> forget_before(std::int64_t at_ms) = 0;
};

}  // namespace dripfeed::store
