// Nothing is read through but a file of this program's schema, so an older backup is read through in a copy.
#include "store/sqlite/archive.h"

#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "store/sql/session.h"
#include "store/sqlite/backup.h"
#include "store/sqlite/library.h"
#include "store/sqlite/migrations.h"
#include "store/sqlite/owner_lock.h"

namespace dripfeed::sqlite {
namespace {

using sql::Query;
using sql::Session;
using store::Error;
using store::ErrorCode;
using store::Result;

// Removes a file that did not get its name.
class Unfinished {
 public:
  Unfinished(const std::string& path, std::string_view ending) : path_(name_with_ending(path, ending)) {}
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;
  ~Unfinished() { remove_store(path_); }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

struct Count {
  std::string_view sql;
  std::uint64_t Holding::* into;
};
constexpr std::array kCounts = {
    Count{"SELECT count(*) FROM machine", &Holding::machines},
    Count{"SELECT count(*) FROM family", &Holding::families},
    Count{"SELECT count(*) FROM part", &Holding::parts},
    Count{"SELECT count(*) FROM program", &Holding::programs},
    Count{"SELECT count(*) FROM text_release", &Holding::releases},
    Count{"SELECT count(*) FROM receipt", &Holding::receipts},
    Count{"SELECT count(*) FROM token", &Holding::tokens},
};

Result<void> count_rows(const std::string& path, Holding& holding) {
  auto connection = Connection::open(path, {}, Access::read);
  if (!connection) return std::unexpected(connection.error());
  Session session(**connection, "backup");
  for (const Count& count : kCounts) {
    Query query(session, count.sql);
    if (query.next()) holding.*count.into = query.number();
  }
  if (!session.ok()) return std::unexpected(session.error());
  return {};
}

// Of a file with this program's schema.
Result<Holding> read_through(const std::string& path) {
  auto found = verify(path);
  if (!found) return std::unexpected(found.error());
  Holding holding;
  holding.schema = migrations().back().version;
  holding.found = std::move(*found);
  if (holding.found.faults.empty()) {
    if (auto counted = count_rows(path, holding); !counted) return std::unexpected(counted.error());
  }
  std::error_code ignored;  // it was read a moment ago
  holding.file_bytes = std::filesystem::file_size(path, ignored);
  return holding;
}

Result<std::uint32_t> version_of(Connection& connection) {
  const auto version = schema_version(connection);
  if (!version) return version;
  const std::uint32_t ours = migrations().back().version;
  if (*version <= ours) return version;
  return std::unexpected(
      Error{ErrorCode::newer_schema, fmt::format("its schema is {}, this program's is {}", *version, ours)});
}

// The store in that file, copied to `fresh` and brought up to date.
Result<void> copy_up_to_date(const std::string& file, const std::string& fresh) {
  {
    auto source = Connection::open(file, {}, Access::read);
    if (!source) return std::unexpected(source.error());
    if (const auto version = version_of(**source); !version) return std::unexpected(version.error());
    if (auto copied = copy_aside(**source, fresh); !copied) return copied;
  }
  const auto opened = open(fresh, {.create = false});
  return opened ? Result<void>() : std::unexpected(opened.error());
}

Result<Holding> read_through_any(const std::string& file, std::uint32_t version) {
  if (version == migrations().back().version) return read_through(file);
  const Unfinished fresh(file, "looked-at");
  if (auto copied = copy_up_to_date(file, fresh.path()); !copied) return std::unexpected(copied.error());
  auto holding = read_through(fresh.path());
  if (holding) holding->schema = version;
  return holding;
}

// What is in the WAL of the old store belongs to the old file only: it must be gone before that has another name.
Result<std::string> put_aside(const std::string& path) {
  std::error_code fault;
  if (!std::filesystem::exists(path, fault)) {
    remove_store(path);
    return std::string();
  }
  // One that is no store keeps what it has; the files next to it are moved with it.
  if (auto old = Connection::open(path, {}, Access::write))
    static_cast<void>((*old)->execute("PRAGMA wal_checkpoint(TRUNCATE)"));
  std::string kept;
  for (int i = 1; kept.empty() || std::filesystem::exists(kept, fault); ++i)
    kept = fmt::format("{}.replaced-{}", path, i);
  for (const char* ending : {"-wal", "-shm", ""}) {
    if (!std::filesystem::exists(path + ending, fault)) continue;
    std::filesystem::rename(path + ending, kept + ending, fault);
    if (fault)
      return std::unexpected(Error{ErrorCode::io_failed, fmt::format("{}: {}", path + ending, fault.message())});
  }
  return kept;
}

}  // namespace

Result<Holding> back_up(const std::string& path, const std::string& backup) {
  std::error_code fault;
  if (std::filesystem::exists(backup, fault)) return std::unexpected(Error{ErrorCode::exists, backup});
  auto source = Connection::open(path, {}, Access::read);
  if (!source) return std::unexpected(source.error());
  const auto version = version_of(**source);
  if (!version) return std::unexpected(version.error());
  const Unfinished unfinished(backup, "unfinished");
  if (auto copied = copy_aside(**source, unfinished.path()); !copied) return std::unexpected(copied.error());
  auto holding = read_through_any(unfinished.path(), *version);
  if (!holding || !holding->found.faults.empty()) return holding;
  if (auto named = give_name(unfinished.path(), backup); !named) return std::unexpected(named.error());
  return holding;
}

Result<Holding> restore(const std::string& backup, const std::string& path, bool replace) {
  const auto lock = OwnerLock::take(path);
  if (!lock) return std::unexpected(lock.error());
  std::error_code fault;
  if (!replace && std::filesystem::exists(path, fault)) return std::unexpected(Error{ErrorCode::exists, path});
  const Unfinished fresh(path, "restored");
  if (auto copied = copy_up_to_date(backup, fresh.path()); !copied) return std::unexpected(copied.error());
  auto holding = read_through(fresh.path());
  if (!holding || !holding->found.faults.empty()) return holding;
  auto kept = put_aside(path);
  if (!kept) return std::unexpected(kept.error());
  holding->kept = std::move(*kept);
  if (auto named = give_name(fresh.path(), path); !named) return std::unexpected(named.error());
  remove_store(library_path(path));  // it is of the store that was there, and is made again
  return holding;
}

Result<Holding> read_out(const std::string& backup, const std::function<Result<void>(sql::Connection& from)>& take) {
  const Unfinished fresh(backup, "looked-at");
  if (auto copied = copy_up_to_date(backup, fresh.path()); !copied) return std::unexpected(copied.error());
  auto holding = read_through(fresh.path());
  if (!holding || !holding->found.faults.empty()) return holding;
  auto source = Connection::open(fresh.path(), {}, Access::read);
  if (!source) return std::unexpected(source.error());
  if (auto taken = take(**source); !taken) return std::unexpected(taken.error());
  return holding;
}

}  // namespace dripfeed::sqlite
