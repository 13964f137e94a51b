// The copy is made in one step, so it is one state: writers go on in the WAL meanwhile.
#include "store/sqlite/backup.h"

#include <filesystem>

#include <fmt/format.h>
#include <sqlite3.h>

#include "store/sqlite/fault.h"
#include "store/sqlite/open.h"
#include "store/sqlite/owner_lock.h"

namespace dripfeed::sqlite {
namespace {

using store::Error;
using store::ErrorCode;
using store::Result;

Result<void> copy(Connection& source, Connection& target) {
  sqlite3_backup* backup = sqlite3_backup_init(target.handle(), "main", source.handle(), "main");
  if (backup == nullptr) return std::unexpected(fault_of(target.handle(), "backup"));
  constexpr int kAllPages = -1;
  sqlite3_backup_step(backup, kAllPages);
  // Its faults are kept in the target's connection.
  if (sqlite3_backup_finish(backup) != SQLITE_OK) return std::unexpected(fault_of(target.handle(), "backup"));
  return {};
}

Result<void> rename_file(const std::string& from, const std::string& to) {
  std::error_code fault;
  std::filesystem::rename(from, to, fault);
  if (!fault) return {};
  return std::unexpected(Error{ErrorCode::io_failed, fmt::format("{} to {}: {}", from, to, fault.message())});
}

void remove_file(const std::string& path) {
  std::error_code ignored;  // what is not there needs no removing
  std::filesystem::remove(path, ignored);
}

// A copy of the backup beside `path`, brought up to date and read through.
Result<void> prepare(const std::string& backup, const std::string& fresh) {
  {
    auto source = Connection::open(backup, {}, Access::read);
    if (!source) return std::unexpected(source.error());
    if (auto copied = copy_to_new_file(**source, fresh); !copied) return copied;
  }
  auto opened = open(fresh, {.create = false});
  if (!opened) return std::unexpected(opened.error());
  return (*opened)->check();
}

// What is in the WAL of the old store belongs to the old file only: it must be gone before another file has its name.
void empty_wal(const std::string& path) {
  if (auto old = Connection::open(path, {}, Access::write)) {
    static_cast<void>((*old)->execute("PRAGMA wal_checkpoint(TRUNCATE)"));
  }
  remove_file(path + "-wal");
  remove_file(path + "-shm");
}

}  // namespace

Result<void> copy_to_new_file(Connection& source, const std::string& path) {
  std::error_code fault;
  if (std::filesystem::exists(path, fault)) return std::unexpected(Error{ErrorCode::exists, path});
  const std::string unfinished = path + ".unfinished";
  remove_file(unfinished);
  Result<void> done;
  {
    auto target = Connection::open(unfinished, {}, Access::create);
    done = target ? copy(source, **target) : std::unexpected(target.error());
  }
  if (done) done = rename_file(unfinished, path);
  if (!done) remove_file(unfinished);
  return done;
}

Result<void> restore(const std::string& backup, const std::string& path) {
  const auto lock = OwnerLock::take(path);
  if (!lock) return std::unexpected(lock.error());
  const std::string fresh = path + ".restored";
  for (const char* ending : {"", "-wal", "-shm"}) remove_file(fresh + ending);
  auto done = prepare(backup, fresh);
  if (done) {
    empty_wal(path);
    done = rename_file(fresh, path);
  }
  if (!done) {
    for (const char* ending : {"", "-wal", "-shm"}) remove_file(fresh + ending);
  }
  return done;
}

}  // namespace dripfeed::sqlite
