// Files of a folder tree, for import and export: what is there, read and written whole, never beyond the folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "server/app/base/error.h"

namespace dripfeed::cli {

struct FoundFile {
  std::string path;       // in the folder, with slashes
  std::string why_not{};  // it is not read: "is a link"; "" where it may be
};

// All below the folder, by path: links are not followed, hidden ones not entered. Errors: unavailable.
app::Result<std::vector<FoundFile>> files_below(const std::filesystem::path& folder);

// Errors: unavailable (not there, no file, longer than `most_bytes`).
app::Result<std::string> read_file(const std::filesystem::path& file, std::uint64_t most_bytes);

// A file that was not there, with the folders to it. Errors: unavailable.
app::Result<void> write_new_file(const std::filesystem::path& file, std::string_view bytes);

// A name as one step of a path: what a file system or a shell takes for something else is percent-encoded.
std::string file_step(std::string_view name);

}  // namespace dripfeed::cli
