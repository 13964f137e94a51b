// Copies of a whole store, by SQLite's online backup.
#pragma once

#include "store/sqlite/connection.h"

namespace dripfeed::sqlite {

// Copies one state of the source to a new file; under another name until it is whole. The file needs no others next to
// it, also on a disk that cannot be written. Errors: exists, disk_full, io_failed, cannot_open.
store::Result<void> copy_to_new_file(Connection& source, const std::string& path);
// The same in two steps, for who looks at the file before it gets its name.
store::Result<void> copy_aside(Connection& source, const std::string& unfinished);
store::Result<void> give_name(const std::string& unfinished, const std::string& path);

// A name next to `path` that no other process takes.
std::string name_with_ending(const std::string& path, std::string_view ending);
// With SQLite's files next to it. What is not there needs no removing.
void remove_store(const std::string& path);

}  // namespace dripfeed::sqlite
