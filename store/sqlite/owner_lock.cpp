// flock() on PATH.lock. The file stays: removing it would let two owners lock two files of one name.
#include "store/sqlite/owner_lock.h"

#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

namespace dripfeed::sqlite {

store::Result<OwnerLock> OwnerLock::take(const std::string& store_path) {
  const std::string path = store_path + ".lock";
  constexpr int kOwnerOnly = 0600;
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kOwnerOnly);
  if (file < 0) {
    return std::unexpected(store::Error{store::ErrorCode::cannot_open,
                                        fmt::format("{}: {}", path, std::generic_category().message(errno))});
  }
  OwnerLock lock(file);
  if (::flock(file, LOCK_EX | LOCK_NB) == 0) return lock;
  return std::unexpected(store::Error{store::ErrorCode::in_use, store_path});
}

OwnerLock::OwnerLock(OwnerLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}

OwnerLock::~OwnerLock() {
  if (file_ >= 0) ::close(file_);
}

}  // namespace dripfeed::sqlite
