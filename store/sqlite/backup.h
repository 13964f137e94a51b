// Copies of a whole store, by SQLite's online backup.
#pragma once

#include "store/sqlite/connection.h"

namespace dripfeed::sqlite {

// Copies one state of the source to a new file; under another name until it is whole. Errors: exists, disk_full,
// io_failed, cannot_open.
store::Result<void> copy_to_new_file(Connection& source, const std::string& path);

}  // namespace dripfeed::sqlite
