// The blocks must be the file's own, so they are allocated and not only counted in its length.
#include "server/app/base/disk_reserve.h"

#include <system_error>
#include <utility>

#include <fcntl.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

namespace dripfeed::app {

namespace {

bool allocate(const std::filesystem::path& path, std::uint64_t bytes) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  if (file < 0) return false;
  const bool done = ::posix_fallocate(file, 0, static_cast<off_t>(bytes)) == 0;
  ::close(file);
  std::error_code ignored;  // what is left of a half one is no use, and no harm
  if (!done) std::filesystem::remove(path, ignored);
  return done;
}

}  // namespace

DiskReserve::DiskReserve(std::filesystem::path path, std::uint64_t bytes, Room room)
    : path_(std::move(path)), bytes_(bytes), room_(std::move(room)) {
  is_whole_ = allocate(path_, bytes_);
  if (!is_whole_) spdlog::error("{}: no room for {} bytes: the disk is full", path_.string(), bytes_);
}

bool DiskReserve::give_up() {
  if (!is_whole_.exchange(false)) return false;
  std::error_code failed;
  std::filesystem::remove(path_, failed);
  spdlog::error("the disk is full: {} is given up for the ledger, nothing new begins", path_.string());
  return !failed;
}

void DiskReserve::restore() {
  if (is_whole_.load()) return;
  if (room_(path_.parent_path()) < 2 * bytes_ || !allocate(path_, bytes_)) return;
  spdlog::info("the disk has room again: {} is whole", path_.string());
  is_whole_ = true;
}

std::uint64_t DiskReserve::room_of_disk(const std::filesystem::path& folder) {
  std::error_code unknown;
  const std::filesystem::space_info space = std::filesystem::space(folder, unknown);
  return unknown ? 0 : space.available;
}

Result<void> refuse_on_full_disk(const DiskReserve* disk_reserve) {
  if (disk_reserve == nullptr || disk_reserve->is_whole()) return {};
  return fail(ErrorCode::unavailable, "the disk is full: running work is finished, nothing new begins");
}

}  // namespace dripfeed::app
