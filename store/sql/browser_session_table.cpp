// A session is joined with its token or its user at each look, so that a revoked token has none, nor a disabled user.
#include "store/sql/browser_session_table.h"

namespace dripfeed::sql {
namespace {

using store::BrowserSession;
using store::ErrorCode;
using store::Id;
using store::Result;
using store::SessionOwner;

constexpr std::string_view kFind =
    "SELECT t.id, t.name, t.role, t.created_by, t.created_at_ms, t.account, t.scope, t.expires_at_ms, t.hash,"
    " s.account, s.secret, s.by_provider, s.opened_at_ms, s.used_at_ms FROM browser_session s LEFT JOIN token t ON "
    "t.id = s.token"
    " LEFT JOIN account a ON a.id = s.account"
    " WHERE s.hash = ? AND (t.revoked_at_ms = 0 OR (s.token IS NULL AND a.disabled_at_ms = 0))";
// All of one owner but the newest ones: a million of them at once.
constexpr std::string_view kTrim =
    "DELETE FROM browser_session WHERE hash IN"
    " (SELECT hash FROM browser_session WHERE token IS NOT DISTINCT FROM ? AND account IS NOT DISTINCT FROM ?"
    " ORDER BY used_at_ms DESC, opened_at_ms DESC LIMIT 1000000 OFFSET ?)";

BrowserSession read_session(Query& query) {
  store::Token token;
  token.id = query.number();
  token.name = query.text();
  const std::string role = query.text();
  token.created_by = query.text();
  token.created_at_ms = query.signed_number();
  token.user_id = query.number();
  token.scope = query.text();
  token.expires_at_ms = query.signed_number();
  BrowserSession found;
  found.token_hash = query.text();
  found.user_id = query.number();
  found.secret = store::named<store::SecretKind>(query.text()).value_or(store::SecretKind::password);
  found.by_provider = query.flag();
  found.opened_at_ms = query.signed_number();
  found.used_at_ms = query.signed_number();
  if (token.id != 0) {
    token.role = store::named<store::Role>(role).value_or(store::Role::viewer);
    found.token = std::move(token);
  }
  return found;
}

Id owner_id(Session& session, const SessionOwner& owner) {
  const bool is_token = !owner.token_hash.empty();
  Query query(session,
              is_token ? "SELECT id FROM token WHERE hash = ? AND revoked_at_ms = 0"
                       : "SELECT id FROM account WHERE name = ? AND disabled_at_ms = 0",
              is_token ? owner.token_hash : owner.user);
  return query.next() ? query.number() : 0;
}

}  // namespace

Result<void> BrowserSessionTable::open(std::string_view session_hash, const SessionOwner& owner, std::size_t most,
                                       std::int64_t at_ms) {
  return database_.write("session", [&](Session& session) -> Result<void> {
    if (session_hash.empty()) return session.refuse(ErrorCode::invalid_value, "a session needs a hash");
    const Id id = owner_id(session, owner);
    if (id == 0) return session.refuse(ErrorCode::not_found);
    const bool is_token = !owner.token_hash.empty();
    const NumberOrNull token{is_token ? id : 0};
    const NumberOrNull user{is_token ? 0 : id};
    session.run(kTrim, token, user, most - 1);
    session.run(
        "INSERT INTO browser_session (hash, token, account, secret, by_provider, opened_at_ms, used_at_ms)"
        " VALUES (?, ?, ?, ?, ?, ?, ?)",
        session_hash, token, user, is_token ? std::string_view() : store::name_of(owner.secret),
        std::uint64_t{owner.by_provider ? 1U : 0U}, at_ms, at_ms);
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

}  // namespace dripfeed::sql
