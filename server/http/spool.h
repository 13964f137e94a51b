// Long bodies of requests lie in files until they are answered, so that many of them at a time cost no memory. The
// files have no name, so that nothing is left when the process ends, however it ends. All that may wait for the disk is
// done on the lane `spool`; the HTTP thread hands over one piece of a body at a time and reads on when it is written.
//
// The file is read, and not mapped: a disk that fails under a mapping ends the process, and with it the feeds.
#pragma once

#include <cstdint>
#include <expected>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "server/http/lanes.h"

namespace dripfeed::http {

inline constexpr std::uint64_t kSpoolKeepsFree_bytes = std::uint64_t{128} << 20U;  // of the disk, for what feeds book

// One body. It is written on the lane `spool`, piece after piece, and then read by whoever answers. Destroying it never
// waits for the disk.
class SpooledBody {
 public:
  explicit SpooledBody(Lanes& lanes) : lanes_(lanes) {}
  SpooledBody(const SpooledBody&) = delete;
  SpooledBody& operator=(const SpooledBody&) = delete;
  ~SpooledBody();

  // The first call makes the file. Errors: why the disk does not take it, as one sentence.
  std::expected<void, std::string> append(const std::filesystem::path& folder, std::string_view piece);
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
  // From `offset` on, as much as fits; 0 at the end. Errors: as append().
  std::expected<std::size_t, std::string> read(std::uint64_t offset, std::span<char> into) const;
  // All that was appended. Errors: as append().
  std::expected<std::string, std::string> read() const;

 private:
  Lanes& lanes_;
  int file_ = -1;
  std::uint64_t bytes_ = 0;
};

class Spool {
 public:
  // Called on the lane's thread.
  using Then = std::move_only_function<void(std::expected<void, std::string>)>;

  // The folder is made when it is first needed.
  Spool(Lanes& lanes, std::filesystem::path folder) : lanes_(lanes), folder_(std::move(folder)) {}
  [[nodiscard]] std::shared_ptr<SpooledBody> begin() const { return std::make_shared<SpooledBody>(lanes_); }
  // False when too much waits for the disk; then `then` is not called.
  bool append(std::shared_ptr<SpooledBody> body, std::string piece, Then then) const;

 private:
  Lanes& lanes_;
  std::filesystem::path folder_;
};

}  // namespace dripfeed::http
