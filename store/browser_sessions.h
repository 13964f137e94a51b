// Sessions of browsers: a cookie that was given for a token, for a user's password or PIN, or for a user whom an OpenID
// Connect provider vouched for. Only the hash of the cookie is kept. They are no record: what ended is deleted, and
// nothing of them is in the audit.
#pragma once

#include "store/tokens.h"
#include "store/users.h"

namespace dripfeed::store {

// Who may open a session: a token or a user.
struct SessionOwner {
  std::string token_hash{};  // "": the user
  std::string user{};
  SecretKind secret = SecretKind::password;  // of the user
  bool by_provider = false;                  // one vouched for the user: it counts as a password
};

struct BrowserSession {
  std::optional<Token> token;  // valid
  std::string token_hash;
  Id user_id = 0;  // without a token; not disabled
  SecretKind secret = SecretKind::password;
  bool by_provider = false;
  std::int64_t opened_at_ms = 0;
  std::int64_t used_at_ms = 0;  // as the last note of a use says
};

class BrowserSessions : public Repository {
 public:
  // Of more than `most` sessions of one owner those that were used longest ago end. Errors: not_found (the token, or it
  // is revoked; the user, or it is disabled), exists (the session), invalid_value (an empty hash).
  virtual Result<void> open(std::string_view session_hash, const SessionOwner& owner, std::size_t most,
                            std::int64_t at_ms) = 0;
  // Errors: not_found: there is none, or its token is revoked, or its user disabled.
  virtual Result<BrowserSession> find(std::string_view session_hash) = 0;
  // A session that has ended meanwhile stays so.
  virtual Result<void> note_use(std::string_view session_hash, std::int64_t at_ms) = 0;
  virtual Result<void> close(std::string_view session_hash) = 0;
  // Ends what was opened before `opened_before_ms`, or used last before `used_before_ms`.
  virtual Result<void> forget(std::int64_t opened_before_ms, std::int64_t used_before_ms) = 0;
};

}  // namespace dripfeed::store
