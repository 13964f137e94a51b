// Opens the library next to a store. One that is damaged, or of another version, is made again, empty.
#pragma once

#include <memory>

#include "store/library.h"
#include "store/sqlite/open.h"

namespace dripfeed::sqlite {

// Where the library of the store at `path` stands.
std::string library_path(const std::string& path);

// Errors: cannot_open, disk_full, io_failed.
store::Result<std::unique_ptr<store::Library>> open_library(const std::string& path, const OpenSettings& settings = {});

}  // namespace dripfeed::sqlite
