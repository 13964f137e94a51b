// The lock of the owner is an advisory lock of the session. The epoch distinguishes a lock that was kept from one that
// was lost and taken again: who took it between may have changed what this server holds true of its lines.
#include "store/postgresql/server.h"

#include <fmt/format.h>

#include "store/postgresql/lingering.h"
#include "store/postgresql/migrations.h"
#include "store/sql/session.h"

namespace dripfeed::postgresql {
namespace {

using sql::Query;
using sql::Session;
using store::Error;
using store::ErrorCode;
using store::Result;

// Nodes share the lock that a server without a name has alone.
constexpr std::string_view kLock = "SELECT pg_try_advisory_lock(1146243408, 2)";
constexpr std::string_view kLockShared = "SELECT pg_try_advisory_lock_shared(1146243408, 2)";
constexpr std::string_view kLockName = "SELECT pg_try_advisory_lock(1146243409, hashtext(?))";
// One start after the other: who looks which nodes run, and changes tables that they use, is not overtaken by another.
constexpr std::string_view kLockStart = "SELECT count(*) FROM (SELECT pg_advisory_lock(1146243408, 4)) l";
constexpr std::string_view kUnlockStart = "SELECT count(*) FROM (SELECT pg_advisory_unlock(1146243408, 4)) l";
constexpr std::string_view kBegin = "UPDATE owner SET epoch = epoch + 1 WHERE id = 1 RETURNING epoch";
constexpr std::string_view kEpoch = "SELECT epoch FROM owner WHERE id = 1";
constexpr std::string_view kBeginNode =
    "INSERT INTO node (name, knows, epoch, started_at_ms, seen_at_ms) VALUES (?, ?, 1, now_ms(), now_ms()) ON CONFLICT "
    "(name) DO UPDATE SET knows = excluded.knows, epoch = node.epoch + 1, started_at_ms = now_ms(), seen_at_ms = "
    "now_ms() RETURNING epoch";
constexpr std::string_view kNodeEpoch = "SELECT epoch FROM node WHERE name = ?";
// What the trigger of the schema asks for.
constexpr std::string_view kNameConnection = "SELECT length(set_config('dripfeed.node', ?, false))";

template <class... P>
Result<std::uint64_t> one_number(Connection& connection, std::string_view sql, const P&... parameters) {
  Session session(connection, "owner");
  std::uint64_t number = 0;
  {
    Query query(session, sql, parameters...);
    if (query.next()) number = query.number();
  }
  if (!session.ok()) return std::unexpected(session.error());
  return number;
}

// Where the server does not wait for its disk, nothing can be called kept.
Result<void> refuse_careless(Connection& connection) {
  const auto careless =
      one_number(connection, "SELECT count(*) FROM pg_settings WHERE name = 'fsync' AND setting = 'off'");
  if (!careless) return std::unexpected(careless.error());
  if (*careless == 0) return {};
  return std::unexpected(Error{ErrorCode::cannot_open, "the server runs with fsync = off: a power cut can lose all"});
}

Result<void> lock_alone(Connection& connection) {
  const auto locked = one_number(connection, kLock);
  if (!locked) return std::unexpected(locked.error());
  if (*locked == 0) return std::unexpected(Error{ErrorCode::in_use, "another server has the database"});
  return {};
}

}  // namespace

Result<std::unique_ptr<Connection>> connect_alone(const std::string& url) {
  auto connection = Connection::open(url, {});
  if (!connection) return connection;
  const auto locked = wait_for_the_ended(ErrorCode::in_use, [&] { return lock_alone(**connection); });
  if (!locked) return std::unexpected(locked.error());
  return connection;
}

Result<std::unique_ptr<Server>> Server::open(const std::string& url, const OpenSettings& settings) {
  std::unique_ptr<Server> server(new Server(url, settings));
  auto first = Connection::open(url, settings);
  if (!first) return std::unexpected(first.error());
  const auto locked = wait_for_the_ended(ErrorCode::in_use, [&] { return server->lock(**first); });
  if (!locked) return std::unexpected(locked.error());
  if (auto alone = one_number(**first, kLockStart); !alone) return std::unexpected(alone.error());
  if (auto ready = bring_up_to_date(**first, settings); !ready) return std::unexpected(ready.error());
  if (auto learned = (*first)->learn_numbered_tables(); !learned) return std::unexpected(learned.error());
  if (settings.own) {
    if (auto careful = refuse_careless(**first); !careful) return std::unexpected(careful.error());
    if (auto begun = server->begin_epoch(**first); !begun) return std::unexpected(begun.error());
  }
  if (auto others = one_number(**first, kUnlockStart); !others) return std::unexpected(others.error());
  // Only now: a change of the tables may take longer than a pulse.
  if (settings.own) server->pulse_ = std::make_shared<const Pulse>(url);
  server->first_ = std::move(*first);
  server->first_->heed(server->pulse_);
  return server;
}

std::unique_ptr<Server> Server::only_read(const std::string& url) {
  return std::unique_ptr<Server>(new Server(url, {}));
}

Result<void> Server::lock(Connection& connection) const {
  if (!settings_.own) return {};
  return settings_.node.empty() ? lock_alone(connection) : lock_as_node(connection);
}

Result<void> Server::lock_as_node(Connection& connection) const {
  const auto shared = one_number(connection, kLockShared);
  if (!shared) return std::unexpected(shared.error());
  if (*shared == 0)
    return std::unexpected(Error{ErrorCode::in_use, "a server without a node's name has the database alone"});
  const auto locked = one_number(connection, kLockName, settings_.node);
  if (!locked) return std::unexpected(locked.error());
  if (*locked == 0)
    return std::unexpected(
        Error{ErrorCode::in_use, fmt::format("another server runs as node {} of the database", settings_.node)});
  if (auto named = one_number(connection, kNameConnection, settings_.node); !named)
    return std::unexpected(named.error());
  return {};
}

Result<void> Server::begin_epoch(Connection& connection) {
  const bool is_alone = settings_.node.empty();
  if (is_alone) {
    const auto nodes = one_number(connection, "SELECT count(*) FROM node");
    if (!nodes) return std::unexpected(nodes.error());
    if (*nodes > 0)
      return std::unexpected(Error{ErrorCode::cannot_open, "the store has nodes: name this one with --node"});
  }
  const auto epoch = is_alone ? one_number(connection, kBegin)
                              : one_number(connection, kBeginNode, settings_.node, migrations().back().version);
  if (!epoch) return std::unexpected(epoch.error());
  epoch_ = *epoch;
  return {};
}

Result<void> Server::know_epoch(Connection& connection) const {
  const auto epoch =
      settings_.node.empty() ? one_number(connection, kEpoch) : one_number(connection, kNodeEpoch, settings_.node);
  if (!epoch) return std::unexpected(epoch.error());
  if (*epoch == epoch_) return {};
  return std::unexpected(Error{ErrorCode::in_use, "another server had the database meanwhile; restart this one"});
}

Result<std::unique_ptr<sql::Connection>> Server::connect_to_read() { return Connection::open(url_, settings_, pulse_); }

Result<std::unique_ptr<sql::Connection>> Server::connect_to_write() {
  if (first_) return std::move(first_);
  auto connection = Connection::open(url_, settings_, pulse_);
  if (!connection) return std::unexpected(connection.error());
  if (auto locked = lock(**connection); !locked) return std::unexpected(locked.error());
  if (settings_.own) {
    if (auto same = know_epoch(**connection); !same) return std::unexpected(same.error());
  }
  if (auto learned = (*connection)->learn_numbered_tables(); !learned) return std::unexpected(learned.error());
  return connection;
}

}  // namespace dripfeed::postgresql
