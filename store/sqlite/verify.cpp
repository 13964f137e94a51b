// What SQLite itself can say of its file.
#include "store/sqlite/verify.h"

#include <array>

#include <fmt/format.h>

#include "store/sqlite/connection.h"
#include "store/sqlite/migrations.h"

namespace dripfeed::sqlite {
namespace {

using sql::Query;
using store::Error;
using store::ErrorCode;
using store::Result;

std::string unsound(Query& row) {
  std::string report = row.text();
  return report == "ok" ? std::string() : report;
}

std::string loose_reference(Query& row) {
  const std::string table = row.text();
  return fmt::format("row {} of {} names one that is not there", row.number(), table);
}

// 20 of one kind of damage; more adds nothing.
constexpr std::array kFile = {sql::FileLook{"PRAGMA integrity_check(20)", unsound},
                              sql::FileLook{"PRAGMA foreign_key_check", loose_reference}};

// A file of this program's schema; an older one is not brought up to date, because that would write.
Result<void> know_schema(Connection& connection) {
  const auto version = schema_version(connection);
  if (!version) return std::unexpected(version.error());
  const std::uint32_t ours = migrations().back().version;
  if (*version == ours) return {};
  return std::unexpected(Error{*version > ours ? ErrorCode::newer_schema : ErrorCode::migration_failed,
                               fmt::format("its schema is {}, this program's is {}", *version, ours)});
}

}  // namespace

Result<Verification> verify(const std::string& path) {
  {
    auto connection = Connection::open(path, {}, Access::read);
    if (!connection) return std::unexpected(connection.error());
    if (auto known = know_schema(**connection); !known) return std::unexpected(known.error());
  }
  auto database = sql::Database::open(std::make_unique<File>(path), sql::Database::May::read);
  if (!database) return std::unexpected(database.error());
  return sql::verify(**database, kFile);
}

}  // namespace dripfeed::sqlite
