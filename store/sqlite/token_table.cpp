// The audit tells of tokens by id, name and role, never by their hash.
#include "store/sqlite/token_table.h"

#include <fmt/format.h>

#include "store/sqlite/audit_table.h"
#include "store/sqlite/paging.h"

namespace dripfeed::sqlite {
namespace {

using store::ErrorCode;
using store::Id;
using store::Result;
using store::Stamp;
using store::Token;

constexpr std::string_view kFind =
    "SELECT id, name, role, created_by, created_at_ms, revoked_at_ms FROM token WHERE hash = ? AND revoked_at_ms = 0";
constexpr std::string_view kOne =
    "SELECT id, name, role, created_by, created_at_ms, revoked_at_ms FROM token WHERE id = ?";
constexpr std::string_view kList =
    "SELECT id, name, role, created_by, created_at_ms, revoked_at_ms FROM token WHERE id < ? ORDER BY id DESC LIMIT ?";

Token read_token(Query& query) {
  Token token;
  token.id = query.number();
  token.name = query.text();
  token.role = query.value<store::Role>();
  token.created_by = query.text();
  token.created_at_ms = query.signed_number();
  token.revoked_at_ms = query.signed_number();
  return token;
}

std::string subject_of(Id token) { return fmt::format("token/{}", token); }

}  // namespace

Result<Token> TokenTable::add(std::string_view name, store::Role role, std::string_view token_hash, const Stamp& by) {
  return database_.write("token", [&](Session& session) -> Result<Token> {
    if (name.empty() || token_hash.empty()) {
      return session.refuse(ErrorCode::invalid_value, "a token needs a name and a hash");
    }
    session.run(
        "INSERT INTO token (name, role, hash, created_by, created_at_ms, revoked_at_ms) VALUES (?, ?, ?, ?, ?, 0)",
        name, role, token_hash, by.actor, by.at_ms);
    const Id id = session.last_id();
    add_audit_row(session,
                  {.action = "token.add",
                   .subject = subject_of(id),
                   .detail = fmt::format("{} as {}", name, store::name_of(role))},
                  by);
    return Token{id, std::string(name), role, by.actor, by.at_ms, 0};
  });
}

Result<Token> TokenTable::find(std::string_view token_hash) {
  return database_.read("token", [&](Session& session) -> Result<Token> {
    Query query(session, kFind, token_hash);
    if (!query.next()) return session.refuse(ErrorCode::not_found);
    return read_token(query);
  });
}

Result<Token> TokenTable::revoke(Id token, const Stamp& by) {
  return database_.write(subject_of(token), [&](Session& session) -> Result<Token> {
    Token found;
    {
      Query query(session, kOne, token);
      if (!query.next()) return session.refuse(ErrorCode::not_found);
      found = read_token(query);
    }
    if (found.revoked_at_ms != 0) return found;
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
    Query query(session, kList, from->after, from->rows);
    return collect(query, page, read_token, [](const Token& token) { return fmt::format("{}", token.id); });
  });
}

}  // namespace dripfeed::sqlite
