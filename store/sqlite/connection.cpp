// Opening a connection.
#include "store/sqlite/connection.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include "store/sqlite/checkpointer.h"
#include "store/sqlite/fault.h"
#include "store/sqlite/statement.h"

namespace dripfeed::sqlite {
namespace {

// secure_delete off: what is dropped here is not a secret, and zeroing an abandoned upload would write it once more.
// recursive_triggers: an INSERT OR REPLACE must meet the triggers that refuse a DELETE.
constexpr const char* kSettings =
    "PRAGMA foreign_keys = ON;"
    "PRAGMA synchronous = FULL;"
    "PRAGMA recursive_triggers = ON;"
    "PRAGMA trusted_schema = OFF;"
    "PRAGMA secure_delete = OFF;"
    "PRAGMA temp_store = MEMORY;"
    "PRAGMA cell_size_check = ON;";

// IMMEDIATE: the write lock now, not in the middle. data_version counts the commits of all connections but the one that
// asks.
constexpr sql::Words kWords{.begin_to_write = "BEGIN IMMEDIATE",
                            .begin_to_read = "BEGIN",
                            .version = "PRAGMA data_version",
                            .newest_event = "SELECT seq FROM sqlite_sequence WHERE name = 'event'"};

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
  drop_statements();
  sqlite3_close_v2(handle_);
}

const sql::Words& Connection::words() const { return kWords; }

store::Result<void> Connection::execute(const char* sql) {
  if (sqlite3_exec(handle_, sql, nullptr, nullptr, nullptr) == SQLITE_OK) return {};
  return std::unexpected(fault_of(handle_, {}));
}

std::unique_ptr<sql::Statement> Connection::prepare(std::string_view sql) {
  sqlite3_stmt* statement = nullptr;
  sqlite3_prepare_v3(handle_, sql.data(), static_cast<int>(sql.size()), SQLITE_PREPARE_PERSISTENT, &statement, nullptr);
  if (statement == nullptr) return nullptr;
  return std::make_unique<Statement>(statement);
}

bool Connection::in_transaction() const { return sqlite3_get_autocommit(handle_) == 0; }

std::uint64_t Connection::changed_rows() const { return static_cast<std::uint64_t>(sqlite3_changes64(handle_)); }

store::Id Connection::last_id() const { return static_cast<store::Id>(sqlite3_last_insert_rowid(handle_)); }

store::Error Connection::fault(std::string_view about) const { return fault_of(handle_, about); }

store::Result<std::unique_ptr<sql::Connection>> File::connect_to_read() {
  return Connection::open(path_, settings_, Access::read);
}

// A commit brings the log into the file only where no thread does it, or when that lags.
store::Result<std::unique_ptr<sql::Connection>> File::connect_to_write() {
  auto opened = Connection::open(path_, settings_, Access::write);
  if (opened && settings_.checkpoints_aside) {
    const std::string rarely = fmt::format("PRAGMA wal_autocheckpoint = {}", Checkpointer::kFallbackPages);
    if (auto set = (*opened)->execute(rarely.c_str()); !set) return std::unexpected(set.error());
  }
  return opened;
}

}  // namespace dripfeed::sqlite
