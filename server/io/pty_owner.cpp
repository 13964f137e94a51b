// Locks of the open file (F_OFD_SETLK): a process that looks needs no lock of its own, and two ends in one process see
// each other.
#include "server/io/pty_owner.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "server/io/serial_identity.h"

namespace dripfeed::io {

namespace {

std::string owner_file(const std::string& path) { return path + ".owner"; }

// The whole file.
struct flock lock_of(short type) {
  struct flock lock{};
  lock.l_type = type;
  lock.l_whence = SEEK_SET;
  return lock;
}

// The lock file of `path`, locked; -1 where a living maker has it or the system refuses (errno).
int take_lock(const std::string& path) {
  for (;;) {
    const int file = ::open(owner_file(path).c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644);
    if (file < 0) return -1;
    struct flock whole = lock_of(F_WRLCK);
    struct stat status{};
    if (::fcntl(file, F_OFD_SETLK, &whole) != 0 || ::fstat(file, &status) != 0) {
      const int error = errno;
      ::close(file);
      errno = error;
      return -1;
    }
    if (status.st_nlink > 0) return file;
    ::close(file);  // its maker took it away between our open and our lock
  }
}

std::string link_target(const std::string& path) {
  std::array<char, 256> target{};
  const ssize_t length = ::readlink(path.c_str(), target.data(), target.size());
  return length > 0 ? std::string(target.data(), static_cast<std::size_t>(length)) : std::string();
}

// The device that the maker wrote down, where there is one; `alive` says whether it still holds its lock.
struct Maker {
  std::string device;
  bool alive = false;
};
std::optional<Maker> maker_of(const std::string& path) {
  const int file = ::open(owner_file(path).c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
  if (file < 0) return std::nullopt;
  struct flock lock = lock_of(F_RDLCK);
  Maker maker;
  maker.alive = ::fcntl(file, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
  std::array<char, 256> device{};
  const ssize_t length = ::pread(file, device.data(), device.size(), 0);
  if (length > 0) maker.device.assign(device.data(), static_cast<std::size_t>(length));
  ::close(file);
  return maker;
}

}  // namespace

std::expected<PtyOwner, std::string> PtyOwner::link(const std::string& path, const std::string& device) {
  const int lock = take_lock(path);
  if (lock < 0) {
    if (errno == EAGAIN || errno == EACCES)
      return std::unexpected(fmt::format("{}: another program that lives made this link", path));
    return std::unexpected(fmt::format("{}: {}", owner_file(path), std::strerror(errno)));
  }
  PtyOwner owner(lock, path, device);
  const bool written = ::ftruncate(lock, 0) == 0 &&
                       ::pwrite(lock, device.data(), device.size(), 0) == static_cast<ssize_t>(device.size());
  // Only a link of our own kind is replaced; a file of another's is not.
  if (written && is_pty(link_target(path))) ::unlink(path.c_str());
  if (written && ::symlink(device.c_str(), path.c_str()) == 0) return owner;
  return std::unexpected(fmt::format("{}: cannot link the pseudo-terminal there: {}", path, std::strerror(errno)));
}

PtyOwner::PtyOwner(PtyOwner&& other) noexcept
    : lock_(std::exchange(other.lock_, -1)), path_(std::move(other.path_)), device_(std::move(other.device_)) {}

void PtyOwner::let_go() {
  if (lock_ < 0) return;
  if (link_target(path_) == device_) ::unlink(path_.c_str());
  ::unlink(owner_file(path_).c_str());
  ::close(std::exchange(lock_, -1));
}

bool is_abandoned(const std::string& path) {
  const auto maker = maker_of(path);
  return maker && !maker->alive;
}

std::expected<void, std::string> check_pty_owner(const std::string& path, int descriptor) {
  const auto maker = maker_of(path);
  if (!maker) return {};
  if (!maker->alive) {
    return std::unexpected(
        std::string("the simulated control that made this link has ended; whatever is at the pseudo-"
                    "terminal now belongs to another program"));
  }
  std::array<char, 256> device{};
  if (::ttyname_r(descriptor, device.data(), device.size()) == 0 && maker->device == device.data()) return {};
  return std::unexpected(std::string("the link led to another pseudo-terminal than its maker's; try again"));
}

}  // namespace dripfeed::io
