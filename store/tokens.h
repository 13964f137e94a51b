// API tokens: only their hashes are kept (hash/token.h makes them). A revoked token stays in the list.
#pragma once

#include "store/basics.h"
#include "store/error.h"

namespace dripfeed::store {

// Each may do what those before it may.
enum class Role : std::uint8_t { viewer, operator_, programmer, approver, admin };
template <>
inline constexpr std::array<std::string_view, 5> kNames<Role>{"viewer", "operator", "programmer", "approver", "admin"};

struct Token {
  Id id = 0;
  std::string name;  // of the person or the program that has it
  Role role = Role::viewer;
  std::string created_by;
  std::int64_t created_at_ms = 0;
  std::int64_t revoked_at_ms = 0;  // 0: valid
};

class Tokens : public Repository {
 public:
  // Errors: exists (the hash), invalid_value (empty name or hash).
  virtual Result<Token> add(std::string_view name, Role role, std::string_view token_hash, const Stamp& by) = 0;
  // The valid token with this hash. Errors: not_found (none, or revoked).
  virtual Result<Token> find(std::string_view token_hash) = 0;
  // Errors: not_found. Revoking twice changes nothing.
  virtual Result<Token> revoke(Id token, const Stamp& by) = 0;
  // Newest first.
  virtual Result<Page<Token>> list(const PageRequest& page) = 0;
};

}  // namespace dripfeed::store
