// Opening a connection and keeping its statements.
#include "store/sqlite/connection.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include "store/sqlite/fault.h"

namespace dripfeed::sqlite {
namespace {

// secure_delete off: what is dropped here is no secret, and zeroing an abandoned upload would write it once more.
// recursive_triggers: an INSERT OR REPLACE must meet the triggers that refuse a DELETE.
constexpr const char* kSettings =
    "PRAGMA foreign_keys = ON;"
    "PRAGMA synchronous = FULL;"
    "PRAGMA recursive_triggers = ON;"
    "PRAGMA trusted_schema = OFF;"
    "PRAGMA secure_delete = OFF;"
    "PRAGMA temp_store = MEMORY;"
    "PRAGMA cell_size_check = ON;";

int flags_of(Access access) {
  switch (access) {
    case Access::read: return SQLITE_OPEN_READONLY;
    case Access::write: return SQLITE_OPEN_READWRITE;
    case Access::create: return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  }
  return SQLITE_OPEN_READONLY;
}

}  // namespace

store::Result<std::unique_ptr<Connection>> Connection::open(const std::string& path, const OpenSettings& settings,
                                                            Access access) {
  sqlite3* handle = nullptr;
  const int result = sqlite3_open_v2(path.c_str(), &handle, flags_of(access) | SQLITE_OPEN_NOMUTEX,
                                     settings.vfs.empty() ? nullptr : settings.vfs.c_str());
  if (handle == nullptr) return std::unexpected(store::Error{store::ErrorCode::internal, "out of memory"});
  std::unique_ptr<Connection> connection(new Connection(handle));
  if (result != SQLITE_OK) return std::unexpected(fault_of(handle, path));
  sqlite3_extended_result_codes(handle, 1);
  sqlite3_busy_timeout(handle, static_cast<int>(settings.busy_timeout_ms));
  if (auto set = connection->execute(kSettings); !set) return std::unexpected(set.error());
  if (settings.derived) {
    if (auto set = connection->execute("PRAGMA synchronous = NORMAL"); !set) return std::unexpected(set.error());
  }
  return connection;
}

Connection::~Connection() {
  for (auto& [sql, statements] : idle_) {
    for (sqlite3_stmt* statement : statements) sqlite3_finalize(statement);
  }
  sqlite3_close_v2(handle_);
}

store::Result<void> Connection::execute(const char* sql) {
  if (sqlite3_exec(handle_, sql, nullptr, nullptr, nullptr) == SQLITE_OK) return {};
  return std::unexpected(fault_of(handle_, {}));
}

sqlite3_stmt* Connection::take(std::string_view sql) {
  if (const auto found = idle_.find(sql); found != idle_.end() && !found->second.empty()) {
    sqlite3_stmt* statement = found->second.back();
    found->second.pop_back();
    return statement;
  }
  sqlite3_stmt* statement = nullptr;
  sqlite3_prepare_v3(handle_, sql.data(), static_cast<int>(sql.size()), SQLITE_PREPARE_PERSISTENT, &statement, nullptr);
  return statement;
}

void Connection::give_back(std::string_view sql, sqlite3_stmt* statement) {
  if (statement == nullptr) return;
  sqlite3_reset(statement);
  sqlite3_clear_bindings(statement);
  auto found = idle_.find(sql);
  if (found == idle_.end()) found = idle_.try_emplace(std::string(sql)).first;
  found->second.push_back(statement);
}

bool Connection::in_transaction() const { return sqlite3_get_autocommit(handle_) == 0; }

}  // namespace dripfeed::sqlite
