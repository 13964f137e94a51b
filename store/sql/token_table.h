// API tokens in the database.
#pragma once

#include "store/sql/database.h"
#include "store/tokens.h"

namespace dripfeed::sql {

class TokenTable final : public store::Tokens {
 public:
  explicit TokenTable(Database& database) : database_(database) {}
  store::Result<store::Token> add(const store::NewToken& token, const store::Stamp& by) override;
  store::Result<store::Token> find(std::string_view token_hash) override;
  store::Result<store::Token> revoke(store::Id token, const store::Stamp& by) override;
  store::Result<store::Page<store::Token>> list(const store::PageRequest& page) override;

 private:
  Database& database_;
};

}  // namespace dripfeed::sql
