// A store of this program's schema; an older one is not brought up to date, because that would write.
#include "store/postgresql/verify.h"

#include <fmt/format.h>

#include "store/postgresql/migrations.h"
#include "store/postgresql/server.h"

namespace dripfeed::postgresql {
namespace {

using store::Error;
using store::ErrorCode;
using store::Result;

Result<void> know_schema(Connection& connection) {
  const auto version = schema_version(connection);
  if (!version) return std::unexpected(version.error());
  const std::uint32_t ours = migrations().back().version;
  if (*version == ours) return {};
  if (*version == 0) return std::unexpected(Error{ErrorCode::cannot_open, "there is no store in the database"});
  return std::unexpected(Error{*version > ours ? ErrorCode::newer_schema : ErrorCode::migration_failed,
                               fmt::format("its schema is {}, this program's is {}", *version, ours)});
}

}  // namespace

Result<sql::Verification> verify(const std::string& url) {
  {
    auto connection = Connection::open(url, {});
    if (!connection) return std::unexpected(connection.error());
    if (auto known = know_schema(**connection); !known) return std::unexpected(known.error());
  }
  auto database = sql::Database::open(Server::only_read(url), sql::Database::May::read);
  if (!database) return std::unexpected(database.error());
  return sql::verify(**database);
}

}  // namespace dripfeed::postgresql
