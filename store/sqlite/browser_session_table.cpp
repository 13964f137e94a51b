// A session is joined with its token at each look, so that a revoked token has none.
#include "store/sqlite/browser_session_table.h"

namespace dripfeed::sqlite {
namespace {

using store::BrowserSession;
using store::ErrorCode;
using store::Result;

constexpr std::string_view kFind =
    "SELECT t.id, t.name, t.role, t.created_by, t.created_at_ms, t.hash, s.opened_at_ms, s.used_at_ms"
    " FROM browser_session s JOIN token t ON t.id = s.token WHERE s.hash = ? AND t.revoked_at_ms = 0";
// All of one token but the newest ones.
constexpr std::string_view kTrim =
    "DELETE FROM browser_session WHERE hash IN"
    " (SELECT hash FROM browser_session WHERE token = ? ORDER BY used_at_ms DESC, opened_at_ms DESC LIMIT -1 OFFSET ?)";

BrowserSession read_session(Query& query) {
  BrowserSession found;
  found.token.id = query.number();
  found.token.name = query.text();
  found.token.role = query.value<store::Role>();
  found.token.created_by = query.text();
  found.token.created_at_ms = query.signed_number();
  found.token_hash = query.text();
  found.opened_at_ms = query.signed_number();
  found.used_at_ms = query.signed_number();
  return found;
}

}  // namespace

Result<void> BrowserSessionTable::open(std::string_view session_hash, std::string_view token_hash, std::size_t most,
                                       std::int64_t at_ms) {
  return database_.write("session", [&](Session& session) -> Result<void> {
    if (session_hash.empty()) return session.refuse(ErrorCode::invalid_value, "a session needs a hash");
    store::Id token = 0;
    {
      Query query(session, "SELECT id FROM token WHERE hash = ? AND revoked_at_ms = 0", token_hash);
      if (!query.next()) return session.refuse(ErrorCode::not_found);
      token = query.number();
    }
    session.run(kTrim, token, most - 1);
    session.run("INSERT INTO browser_session (hash, token, opened_at_ms, used_at_ms) VALUES (?, ?, ?, ?)", session_hash,
                token, at_ms, at_ms);
    return {};
  });
}

Result<BrowserSession> BrowserSessionTable::find(std::string_view session_hash) {
  return database_.read("session", [&](Session& session) -> Result<BrowserSession> {
    Query query(session, kFind, session_hash);
    if (!query.next()) return session.refuse(ErrorCode::not_found);
    return read_session(query);
  });
}

Result<void> BrowserSessionTable::note_use(std::string_view session_hash, std::int64_t at_ms) {
  return database_.write("session", [&](Session& session) -> Result<void> {
    session.run("UPDATE browser_session SET used_at_ms = ? WHERE hash = ? AND used_at_ms < ?", at_ms, session_hash,
                at_ms);
    return {};
  });
}

Result<void> BrowserSessionTable::close(std::string_view session_hash) {
  return database_.write("session", [&](Session& session) -> Result<void> {
    session.run("DELETE FROM browser_session WHERE hash = ?", session_hash);
    return {};
  });
}

Result<void> BrowserSessionTable::forget(std::int64_t opened_before_ms, std::int64_t used_before_ms) {
  return database_.write("session", [&](Session& session) -> Result<void> {
    session.run("DELETE FROM browser_session WHERE opened_at_ms < ? OR used_at_ms < ?", opened_before_ms,
                used_before_ms);
    return {};
  });
}

}  // namespace dripfeed::sqlite
