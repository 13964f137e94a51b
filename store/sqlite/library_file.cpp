// The file is made where it is not there, and made again where it cannot be used: nothing stands in it that is not
// derived.
#include <array>
#include <cstdio>

#include <fmt/format.h>

#include "store/sqlite/connection.h"
#include "store/sqlite/library.h"
#include "store/sqlite/library_table.h"

namespace dripfeed::sqlite {
namespace {

using sql::Query;
using sql::Session;
using store::ErrorCode;
using store::Result;

// "DRIL": a library, and no store.
constexpr std::uint64_t kApplicationId = 0x4452494c;

std::uint64_t pragma(Session& session, std::string_view sql) {
  Query query(session, sql);
  return query.next() ? query.number() : 0;
}

// Whether it is a whole library of this version.
Result<bool> is_usable(Connection& connection) {
  Session session(connection, "library");
  const bool ours = pragma(session, "PRAGMA application_id") == kApplicationId &&
                    pragma(session, "PRAGMA user_version") == kLibraryVersion;
  if (!session.ok()) return std::unexpected(session.error());
  return ours;
}

Result<void> make(Connection& connection) {
  if (auto wal = connection.execute("PRAGMA journal_mode = WAL"); !wal) return wal;
  return connection.execute(
      fmt::format("BEGIN IMMEDIATE; {} PRAGMA application_id = {}; PRAGMA user_version = {}; COMMIT", kLibrarySchema,
                  kApplicationId, kLibraryVersion)
          .c_str());
}

Result<void> open_or_make(const std::string& path, const OpenSettings& settings) {
  auto connection = Connection::open(path, settings, Access::create);
  if (!connection) return std::unexpected(connection.error());
  const auto usable = is_usable(**connection);
  if (!usable) return std::unexpected(usable.error());
  return *usable ? Result<void>{} : make(**connection);
}

void drop_file(const std::string& path) {
  for (const char* ending : {"", "-wal", "-shm"}) std::remove((path + ending).c_str());
}

bool is_damage(ErrorCode code) {
  constexpr std::array kDamage = {ErrorCode::corrupt, ErrorCode::not_a_store, ErrorCode::internal, ErrorCode::exists};
  for (const ErrorCode one : kDamage)
    if (one == code) return true;
  return false;
}

}  // namespace

std::string library_path(const std::string& path) { return path + "-library"; }

Result<std::unique_ptr<store::Library>> open_library(const std::string& path, const OpenSettings& given) {
  OpenSettings settings = given;
  settings.derived = true;
  auto ready = open_or_make(path, settings);
  if (!ready && is_damage(ready.error().code)) {
    drop_file(path);
    ready = open_or_make(path, settings);
  }
  if (!ready) return std::unexpected(ready.error());
  auto database = sql::Database::open(std::make_unique<File>(path, settings));
  if (!database) return std::unexpected(database.error());
  return std::make_unique<LibraryTable>(std::move(*database));
}

}  // namespace dripfeed::sqlite
