// One place for the name of the store's file.
#include "server/cli/data_folder.h"

#include <filesystem>

#include <fmt/format.h>

namespace dripfeed::cli {

namespace fs = std::filesystem;

std::string store_path(const std::string& data) { return (fs::path(data) / "dripfeed.db").string(); }

app::Result<void> make_data_folder(const std::string& data) {
  std::error_code error;
  const bool made = fs::create_directories(data, error);
  if (!error && made) fs::permissions(data, fs::perms::owner_all, error);
  if (error) return app::fail(app::ErrorCode::unavailable, fmt::format("{}: {}", data, error.message()));
  return {};
}

}  // namespace dripfeed::cli
