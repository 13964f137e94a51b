// One row a key.
#include "store/sql/reply_table.h"

#include <fmt/format.h>

namespace dripfeed::sql {
namespace {

using store::ErrorCode;
using store::Reply;
using store::ReplyKey;
using store::Result;

constexpr std::string_view kFind =
    "SELECT request_sha256, status, headers, body, at_ms FROM reply WHERE actor = ? AND route = ? AND reply_key = ?";
constexpr std::string_view kInsert =
    "INSERT INTO reply (actor, route, reply_key, request_sha256, status, headers, body, at_ms) "
    "VALUES (?, ?, ?, ?, ?, ?, ?, ?)";

std::string subject_of(const ReplyKey& key) { return fmt::format("{} on {}", key.key, key.route); }

}  // namespace

Result<std::optional<Reply>> ReplyTable::find(const ReplyKey& key) {
  return database_.read(subject_of(key), [&](Session& session) -> Result<std::optional<Reply>> {
    Query query(session, kFind, key.actor, key.route, key.key);
    if (!query.next()) return std::nullopt;
    if (query.text() != key.request_sha256) return session.refuse(ErrorCode::key_reused);
    Reply reply;
    reply.status = static_cast<std::uint16_t>(query.number());
    reply.headers = query.text();
    reply.body = query.text();
    reply.at_ms = query.signed_number();
    return reply;
  });
}

Result<void> ReplyTable::keep(const ReplyKey& key, const Reply& reply) {
  return database_.write(subject_of(key), [&](Session& session) -> Result<void> {
    if (key.key.empty()) return session.refuse(ErrorCode::invalid_value, "an idempotency key is not empty");
    session.run(kInsert, key.actor, key.route, key.key, key.request_sha256, reply.status, reply.headers, reply.body,
                reply.at_ms);
    return {};
  });
}

Result<std::uint64_t> ReplyTable::forget_before(std::int64_t at_ms) {
  return database_.write("replies", [&](Session& session) -> Result<std::uint64_t> {
    session.run("DELETE FROM reply WHERE at_ms < ?", at_ms);
    return session.changed_rows();
  });
}

}  // namespace dripfeed::sql
