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
  std::string user{};              // whose rights it has, up to its role; "" for a program's own
  Id user_id = 0;                  // the same; 0: none
  std::string scope{};             // what it may change, words with blanks between; "": all that its role may
  std::int64_t expires_at_ms = 0;  // 0: never
};

struct NewToken {
  std::string name;
  Role role = Role::viewer;
  std::string hash;
  std::string user{};
  std::string scope{};
  std::int64_t expires_at_ms = 0;
};

class Tokens : public Repository {
 public:
  // Errors: exists (the hash), invalid_value (empty name or hash, an end that is over), broken_reference (no such
  // user).
  virtual Result<Token> add(const NewToken& token, const Stamp& by) = 0;
  // The token with this hash, unless it is revoked; whoever asks looks at expires_at_ms. Errors: not_found.
  virtual Result<Token> find(std::string_view token_hash) = 0;
  // Errors: not_found. Revoking twice changes nothing.
  virtual Result<Token> revoke(Id token, const Stamp& by) = 0;
  // Newest first.
  virtual Result<Page<Token>> list(const PageRequest& page) = 0;
};

}  // namespace dripfeed::store
