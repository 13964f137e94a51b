// Backups for people: a whole store as one file, made while a server runs and read through before it gets its name; and
// the store of such a file, in the place of none or of another one. SQLite holds all that a store has, so there is no
// second file to keep with it.
#pragma once

#include <functional>
#include <string>

#include "store/sql/connection.h"
#include "store/sqlite/verify.h"

namespace dripfeed::sqlite {

// What is in a store, or in its backup.
struct Holding {
  std::uint32_t schema = 0;
  std::uint64_t file_bytes = 0;
  std::uint64_t machines = 0;
  std::uint64_t families = 0;
  std::uint64_t parts = 0;
  std::uint64_t programs = 0;
  std::uint64_t releases = 0;
  std::uint64_t receipts = 0;
  std::uint64_t tokens = 0;
  Verification found;  // with faults: nothing was made or changed
  std::string kept{};  // of a restore: where the store that was there is now; "" where there was none
};

// One state of the store at `path` to the new file `backup`. A server may run meanwhile and is not held up: what is
// written goes to the disk in small pieces. An older schema stays as it is; it is read through in a copy that is
// brought up to date. Errors: exists, cannot_open, not_a_store, newer_schema, corrupt, disk_full, io_failed.
store::Result<Holding> back_up(const std::string& path, const std::string& backup);

// Reads the backup through, brings a copy of it up to date and puts that at `path`. `replace`: a store that is there
// keeps its bytes under another name, see Holding::kept; without it there must be none. Errors: as back_up(), in_use
// while a server runs there, exists.
store::Result<Holding> restore(const std::string& backup, const std::string& path, bool replace);

// Reads the backup through, as restore() does, and gives its rows to `take`, in the newest schema and as one state.
// What it is given is the copy of a moment, next to the backup. Errors: as back_up(), and those of `take`.
store::Result<Holding> read_out(const std::string& backup,
                                const std::function<store::Result<void>(sql::Connection& from)>& take);

}  // namespace dripfeed::sqlite
