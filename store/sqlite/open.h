// store/sqlite: the store on SQLite: schema and migrations, connections, one file per repository. It alone names
// sqlite3. This header is all that others need: it opens a store, making it where there is none.
#pragma once

#include <cstdint>
#include <memory>

#include "store/store.h"

namespace dripfeed::sqlite {

struct OpenSettings {
  bool own = false;                      // be the one server of this store: others that want to own it get in_use
  bool create = true;                    // make the file when it is not there
  bool checkpoints_aside = false;        // bring the log into the file on a thread, not in a commit: for a server
  bool derived = false;                  // what it holds can be made again: a commit does not wait for the disk
  std::uint32_t busy_timeout_ms = 5000;  // how long to wait for another process's write
  std::string vfs{};                     // SQLite's VFS by name, empty for its default; for tests
};

// Opens the file, brings its schema up to date. Errors: cannot_open, in_use, not_a_store, newer_schema, corrupt,
// migration_failed, disk_full, io_failed.
store::Result<std::unique_ptr<store::Store>> open(const std::string& path, const OpenSettings& settings = {});

}  // namespace dripfeed::sqlite
