// The copy is of one state: a transaction that reads stays open on the source while the steps are made, and writers go
// on in the WAL meanwhile. Each step is brought to the disk before the next one, so that a commit of the ledger never
// waits for more than one of them.
#include "store/sqlite/backup.h"

#include <cerrno>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <unistd.h>

#include "store/sqlite/fault.h"

namespace dripfeed::sqlite {
namespace {

using store::Error;
using store::ErrorCode;
using store::Result;

constexpr int kStepPages = 256;  // 1 MiB

Error system_fault(const std::string& path) {
  return {store::code_of_file_fault(errno), fmt::format("{}: {}", path, std::generic_category().message(errno))};
}

// A file or folder, for fdatasync() and fsync(). Closing one that SQLite has open, too, would drop SQLite's locks on
// it.
class Synced {
 public:
  explicit Synced(const std::string& path, int flags) : path_(path), file_(::open(path.c_str(), flags | O_CLOEXEC)) {}
  Synced(const Synced&) = delete;
  Synced& operator=(const Synced&) = delete;
  ~Synced() {
    if (file_ >= 0) ::close(file_);
  }
  [[nodiscard]] Result<void> sync() const {
    if (file_ >= 0 && (::fsync(file_) == 0 || errno == EINVAL)) return {};  // some systems have it for no folder
    return std::unexpected(system_fault(path_));
  }

 private:
  std::string path_;
  int file_;
};

Result<void> make_steps(Connection& source, Connection& target, const Synced& file) {
  sqlite3_backup* const backup = sqlite3_backup_init(target.handle(), "main", source.handle(), "main");
  if (backup == nullptr) return std::unexpected(fault_of(target.handle(), "backup"));
  Result<void> synced;
  while (synced && sqlite3_backup_step(backup, kStepPages) == SQLITE_OK) synced = file.sync();
  // Its faults are kept in the target's connection.
  if (sqlite3_backup_finish(backup) != SQLITE_OK) return std::unexpected(fault_of(target.handle(), "backup"));
  return synced;
}

// In WAL a file wants two others next to it, and a folder that can be written.
constexpr const char* kOneFile = "PRAGMA journal_mode = DELETE";
constexpr const char* kHoldState = "BEGIN; SELECT count(*) FROM sqlite_schema";

Result<void> copy(Connection& source, Connection& target, const Synced& file) {
  if (auto held = source.execute(kHoldState); !held) return held;
  auto done = make_steps(source, target, file);
  static_cast<void>(source.execute("COMMIT"));  // it only read
  return done ? target.execute(kOneFile) : done;
}

}  // namespace

std::string name_with_ending(const std::string& path, std::string_view ending) {
  return fmt::format("{}.{}.{}", path, ::getpid(), ending);
}

void remove_store(const std::string& path) {
  std::error_code ignored;
  for (const char* ending : {"", "-wal", "-shm", "-journal"}) std::filesystem::remove(path + ending, ignored);
}

Result<void> copy_aside(Connection& source, const std::string& unfinished) {
  remove_store(unfinished);
  // For its owner alone, as a store is.
  const int made = ::open(unfinished.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (made < 0) {
    const Error fault = system_fault(unfinished);
    return std::unexpected(
        Error{fault.code == ErrorCode::disk_full ? fault.code : ErrorCode::cannot_open, fault.detail});
  }
  ::close(made);
  Result<void> done;
  {
    const Synced file(unfinished, O_RDWR);
    auto target = Connection::open(unfinished, {}, Access::write);
    done = target ? copy(source, **target, file) : std::unexpected(target.error());
  }
  if (!done) remove_store(unfinished);
  return done;
}

Result<void> give_name(const std::string& unfinished, const std::string& path) {
  std::error_code fault;
  std::filesystem::rename(unfinished, path, fault);
  if (fault) {
    return std::unexpected(Error{ErrorCode::io_failed, fmt::format("{} to {}: {}", unfinished, path, fault.message())});
  }
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return Synced(folder.empty() ? "." : folder, O_RDONLY | O_DIRECTORY).sync();
}

Result<void> copy_to_new_file(Connection& source, const std::string& path) {
  std::error_code fault;
  if (std::filesystem::exists(path, fault)) return std::unexpected(Error{ErrorCode::exists, path});
  const std::string unfinished = name_with_ending(path, "unfinished");
  auto done = copy_aside(source, unfinished);
  if (done) done = give_name(unfinished, path);
  if (!done) remove_store(unfinished);
  return done;
}

}  // namespace dripfeed::sqlite
