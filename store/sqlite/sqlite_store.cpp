// Opening a store, and what concerns the whole of it.
#include <optional>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "store/sql/table_store.h"
#include "store/sqlite/backup.h"
#include "store/sqlite/checkpointer.h"
#include "store/sqlite/migrations.h"
#include "store/sqlite/owner_lock.h"

namespace dripfeed::sqlite {
namespace {

using sql::Query;
using sql::Session;
using store::Error;
using store::ErrorCode;
using store::Result;

// The kind of the file is known to be ours, or it is empty: what is set here stays in it.
Result<void> use_wal(Connection& connection) {
  Session session(connection, "journal");
  std::string mode;
  {
    Query query(session, "PRAGMA journal_mode = WAL");
    if (query.next()) mode = query.text();
  }
  if (!session.ok()) return std::unexpected(session.error());
  if (mode == "wal") return {};
  return session.refuse(ErrorCode::cannot_open, fmt::format("the file system gives no WAL, but {}", mode));
}

// A store is for its owner alone: it has the hashes of tokens and what a shop makes. SQLite gives the files next to it
// the rights of the database.
void create_private(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (descriptor >= 0) ::close(descriptor);  // else it is there, or SQLite says what is wrong
}

// One that an older version made; where it is not ours, its owner has decided.
void keep_private(const std::string& path) {
  for (const char* ending : {"", "-wal", "-shm"}) ::chmod((path + ending).c_str(), 0600);
}

Result<void> bring_up_to_date(const std::string& path, const OpenSettings& settings) {
  auto connection = Connection::open(path, settings, settings.create ? Access::create : Access::write);
  if (!connection) return std::unexpected(connection.error());
  if (auto known = schema_version(**connection); !known) return std::unexpected(known.error());
  if (auto wal = use_wal(**connection); !wal) return wal;
  return migrate(**connection, migrations());
}

Result<std::unique_ptr<Checkpointer>> start_checkpoints(const std::string& path, const OpenSettings& settings) {
  auto own = Connection::open(path, settings, Access::write);
  if (!own) return std::unexpected(own.error());
  return std::make_unique<Checkpointer>(path, std::move(*own));
}

class SqliteStore final : public sql::TableStore {
 public:
  SqliteStore(std::string path, OpenSettings settings, std::unique_ptr<sql::Database> database,
              std::unique_ptr<Checkpointer> checkpointer)
      : TableStore(std::move(database)),
        path_(std::move(path)),
        settings_(std::move(settings)),
        checkpointer_(std::move(checkpointer)) {}

  Result<void> backup(const std::string& path) override;
  Result<void> check() override;

 private:
  std::string path_;
  OpenSettings settings_;
  std::unique_ptr<Checkpointer> checkpointer_;  // nothing: commits do it
};

Result<void> SqliteStore::backup(const std::string& path) {
  auto source = Connection::open(path_, settings_, Access::read);
  if (!source) return std::unexpected(source.error());
  auto copied = copy_to_new_file(**source, path);
  if (copied) keep_private(path);
  return copied;
}

Result<void> SqliteStore::check() {
  auto connection = Connection::open(path_, settings_, Access::read);
  if (!connection) return std::unexpected(connection.error());
  Session session(**connection, "check");
  {
    Query query(session, "PRAGMA integrity_check(1)");
    if (query.next()) {
      const std::string found = query.text();
      if (found != "ok") return session.refuse(ErrorCode::corrupt, found);
    }
  }
  {
    Query query(session, "PRAGMA foreign_key_check");
    if (query.next()) return session.refuse(ErrorCode::corrupt, fmt::format("a reference in {}", query.text()));
  }
  if (!session.ok()) return std::unexpected(session.error());
  return {};
}

}  // namespace

Result<std::unique_ptr<store::Store>> open(const std::string& path, const OpenSettings& settings) {
  std::optional<OwnerLock> lock;
  if (settings.own) {
    auto taken = OwnerLock::take(path);
    if (!taken) return std::unexpected(taken.error());
    lock.emplace(std::move(*taken));
  }
  if (settings.create) create_private(path);
  if (auto ready = bring_up_to_date(path, settings); !ready) return std::unexpected(ready.error());
  keep_private(path);
  auto database = sql::Database::open(std::make_unique<File>(path, settings, std::move(lock)));
  if (!database) return std::unexpected(database.error());
  std::unique_ptr<Checkpointer> checkpointer;
  if (settings.checkpoints_aside) {
    auto started = start_checkpoints(path, settings);
    if (!started) return std::unexpected(started.error());
    checkpointer = std::move(*started);
  }
  auto opened = std::make_unique<SqliteStore>(path, settings, std::move(*database), std::move(checkpointer));
  if (settings.own) {
    if (auto dropped = opened->drop_unused_contents(); !dropped) return std::unexpected(dropped.error());
  }
  return opened;
}

}  // namespace dripfeed::sqlite
