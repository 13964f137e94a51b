// The audit names tokens by id, name and role, never by their hash.
#include "store/sql/token_table.h"

#include <fmt/format.h>

#include "store/sql/audit_table.h"
#include "store/sql/paging.h"

namespace dripfeed::sql {
namespace {

using store::ErrorCode;
using store::Id;
using store::Result;
using store::Stamp;
using store::Token;

constexpr std::string_view kSelect =
    "SELECT t.id, t.name, t.role, t.created_by, t.created_at_ms, t.revoked_at_ms, a.name, t.account, t.scope,"
    " t.expires_at_ms FROM token t LEFT JOIN account a ON a.id = t.account WHERE ";

Token read_token(Query& query) {
  Token token;
  token.id = query.number();
  token.name = query.text();
  token.role = query.value<store::Role>();
  token.created_by = query.text();
  token.created_at_ms = query.signed_number();
  token.revoked_at_ms = query.signed_number();
  token.user = query.text();
  token.user_id = query.number();
  token.scope = query.text();
  token.expires_at_ms = query.signed_number();
  return token;
}

std::string select_where(std::string_view rest) { return fmt::format("{}{}", kSelect, rest); }

// The user's number; 0 for no one. Refuses a name that no one has.
Result<Id> user_of(Session& session, const std::string& name) {
  if (name.empty()) return 0;
  Query query(session, "SELECT id FROM account WHERE name = ?", name);
  if (!query.next()) return session.refuse(ErrorCode::broken_reference, fmt::format("there is no user {}", name));
  return query.number();
}

// The audit and the four eyes know people and programs by their names.
Result<void> refuse_name_of_user(Session& session, const store::NewToken& token) {
  if (!token.user.empty()) return {};
  Query query(session, "SELECT 1 FROM account WHERE name = ?", token.name);
  if (!query.next()) return {};
  return session.refuse(ErrorCode::exists, fmt::format("a user has the name {}", token.name));
}

// Whether someone could still look after the server without this token.
bool has_other_admin(Session& session, Id token, std::int64_t now_ms) {
  Query query(session,
              "SELECT 1 FROM token WHERE id <> ? AND role = 'admin' AND revoked_at_ms = 0 AND (expires_at_ms = 0 OR "
              "expires_at_ms > ?) UNION ALL SELECT 1 FROM account WHERE role = 'admin' AND disabled_at_ms = 0 AND "
              "(password <> '' OR provider <> '') LIMIT 1",
              token, now_ms);
  return query.next();
}

std::string words_of(const store::NewToken& token) {
  std::string words = fmt::format("{} as {}", token.name, store::name_of(token.role));
  if (!token.user.empty()) words += fmt::format(", for {}", token.user);
  if (!token.scope.empty()) words += fmt::format(", may change: {}", token.scope);
  if (token.expires_at_ms != 0) words += fmt::format(", until {}", token.expires_at_ms);
  return words;
}

std::string subject_of(Id token) { return fmt::format("token/{}", token); }

}  // namespace

Result<Token> TokenTable::add(const store::NewToken& token, const Stamp& by) {
  return database_.write("token", [&](Session& session) -> Result<Token> {
    if (token.name.empty() || token.hash.empty()) {
      return session.refuse(ErrorCode::invalid_value, "a token needs a name and a hash");
    }
    if (token.expires_at_ms != 0 && token.expires_at_ms <= by.at_ms)
      return session.refuse(ErrorCode::invalid_value, "it would end before it is made");
    if (auto free = refuse_name_of_user(session, token); !free) return std::unexpected(free.error());
    const auto user = user_of(session, token.user);
    if (!user) return std::unexpected(user.error());
    session.run(
        "INSERT INTO token (name, role, hash, created_by, created_at_ms, revoked_at_ms, account, scope, expires_at_ms)"
        " VALUES (?, ?, ?, ?, ?, 0, ?, ?, ?)",
        token.name, token.role, token.hash, by.actor, by.at_ms, NumberOrNull{*user}, token.scope, token.expires_at_ms);
    const Id id = session.last_id();
    add_audit_row(session, {.action = "token.add", .subject = subject_of(id), .detail = words_of(token)}, by);
    return Token{.id = id,
                 .name = token.name,
                 .role = token.role,
                 .created_by = by.actor,
                 .created_at_ms = by.at_ms,
                 .user = token.user,
                 .user_id = *user,
                 .scope = token.scope,
                 .expires_at_ms = token.expires_at_ms};
  });
}

Result<Token> TokenTable::find(std::string_view token_hash) {
  return database_.read("token", [&](Session& session) -> Result<Token> {
    static const std::string kSql = select_where("t.hash = ? AND t.revoked_at_ms = 0");
    Query query(session, kSql, token_hash);
    if (!query.next()) return session.refuse(ErrorCode::not_found);
    return read_token(query);
  });
}

Result<Token> TokenTable::revoke(Id token, const Stamp& by) {
  return database_.write(subject_of(token), [&](Session& session) -> Result<Token> {
    Token found;
    {
      static const std::string kSql = select_where("t.id = ?");
      Query query(session, kSql, token);
      if (!query.next()) return session.refuse(ErrorCode::not_found);
      found = read_token(query);
    }
    if (found.revoked_at_ms != 0) return found;
    if (found.role == store::Role::admin && !has_other_admin(session, token, by.at_ms))
      return session.refuse(ErrorCode::refused_transition, "no other admin is left: make another admin's token before");
    found.revoked_at_ms = by.at_ms;
    session.run("UPDATE token SET revoked_at_ms = ? WHERE id = ?", by.at_ms, token);
    add_audit_row(session, {.action = "token.revoke", .subject = subject_of(token), .detail = found.name}, by);
    return found;
  });
}

Result<store::Page<Token>> TokenTable::list(const store::PageRequest& page) {
  return database_.read("tokens", [&](Session& session) -> Result<store::Page<Token>> {
    const auto from = newest_first(page);
    if (!from) return std::unexpected(from.error());
    static const std::string kSql = select_where("t.id < ? ORDER BY t.id DESC LIMIT ?");
    Query query(session, kSql, from->after, from->rows);
    return collect(query, page, read_token, [](const Token& token) { return fmt::format("{}", token.id); });
  });
}

}  // namespace dripfeed::sql
