// A folder that goes away with the test.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include <stdlib.h>

namespace dripfeed::test {

class TempFolder {
 public:
  // In memory where the system has such a place: for tests that commit very often.
  enum class Where : std::uint8_t { disk, memory };

  explicit TempFolder(Where where = Where::disk) {
    const std::filesystem::path memory = "/dev/shm";
    const bool there = where == Where::memory && std::filesystem::is_directory(memory);
    std::string name = ((there ? memory : std::filesystem::temp_directory_path()) / "dripfeed-test-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;
  ~TempFolder() {
    std::error_code ignored;  // what cannot be removed is the system's
    std::filesystem::remove_all(path_, ignored);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::string file(std::string_view name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace dripfeed::test
