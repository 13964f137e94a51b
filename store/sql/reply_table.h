// Replies under idempotency keys in the database.
#pragma once

#include "store/replies.h"
#include "store/sql/database.h"

namespace dripfeed::sql {

class ReplyTable final : public store::Replies {
 public:
  explicit ReplyTable(Database& database) : database_(database) {}
  store::Result<std::optional<store::Reply>> find(const store::ReplyKey& key) override;
  store::Result<void> keep(const store::ReplyKey& key, const store::Reply& reply) override;
  store::Result<std::uint64_t> forget_before(std::int64_t at_ms) override;

 private:
  Database& database_;
};

}  // namespace dripfeed::sql
