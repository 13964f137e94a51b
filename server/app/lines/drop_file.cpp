// Plain system calls: a stream would hide which of them failed.
#include "server/app/lines/drop_file.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace dripfeed::app {

namespace {

namespace fs = std::filesystem;

using Named = std::expected<void, std::string_view>;

constexpr std::size_t kPiece_bytes = 16'384;
constexpr std::chrono::minutes kAbandoned{10};
constexpr std::string_view kUnnamed = ".dripfeed-";
constexpr std::string_view kNotTaken = "the folder does not take the file";
constexpr std::string_view kGivenUp = "cancelled";

std::string system_text() { return std::strerror(errno); }

// A descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int descriptor) : descriptor_(descriptor) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  [[nodiscard]] int get() const { return descriptor_; }
  explicit operator bool() const { return descriptor_ >= 0; }

 private:
  int descriptor_;
};

std::expected<std::string, std::string> sha256_of_file(const std::string& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file) return std::unexpected(system_text());
  std::array<std::byte, kPiece_bytes> piece{};
  hash::Sha256 sum;
  for (;;) {
    const ssize_t count = ::read(file.get(), piece.data(), piece.size());
    if (count < 0) return std::unexpected(system_text());
    if (count == 0) return sum.hex();
    sum.add(std::span<const std::byte>(piece).first(static_cast<std::size_t>(count)));
  }
}

}  // namespace

std::string look_at_folder(const std::string& folder) {
  struct stat status{};
  if (::stat(folder.c_str(), &status) != 0) return fmt::format("{}: {}", folder, system_text());
  if (!S_ISDIR(status.st_mode)) return fmt::format("{} is not a folder", folder);
  if (::access(folder.c_str(), W_OK | X_OK) != 0) return fmt::format("{} cannot be written to", folder);
  return {};
}

void remove_abandoned(const std::string& folder) {
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (!at->path().filename().string().starts_with(kUnnamed)) continue;
    std::error_code failed;  // gone meanwhile, or another's: it stays
    const auto touched = fs::last_write_time(at->path(), failed);
    if (!failed && fs::file_time_type::clock::now() - touched > kAbandoned) fs::remove(at->path(), failed);
  }
}

DropFile::DropFile(std::string folder, std::string_view name)
    : folder_(std::move(folder)), path_(fmt::format("{}/{}{}", folder_, kUnnamed, name)) {}

DropFile::~DropFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (exists_) ::unlink(path_.c_str());
}

std::expected<void, std::string> DropFile::create() {
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (descriptor_ < 0) return std::unexpected(fmt::format("cannot write to {}: {}", folder_, system_text()));
  exists_ = true;
  return {};
}

std::expected<void, std::string> DropFile::write(std::span<const std::byte> bytes) {
  sum_.add(bytes);
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return std::unexpected(fmt::format("cannot write to {}: {}", folder_, system_text()));
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return {};
}

Named DropFile::give_name(const std::string& name, bool overwrite, const std::atomic<bool>& given_up) {
  if (::fsync(descriptor_) != 0) return std::unexpected(kNotTaken);
  digest_ = sum_.hex();
  const auto read_back = sha256_of_file(path_);
  if (!read_back || *read_back != digest_)
    return std::unexpected("the file that was read back differs from what was written");
  const std::string path = fmt::format("{}/{}", folder_, name);
  if (!overwrite) {
    if (const Named named = take_free_name(path, given_up); !named) return named;
  } else {
    if (given_up) return std::unexpected(kGivenUp);
    if (::rename(path_.c_str(), path.c_str()) != 0) return std::unexpected(kNameNotTaken);
    exists_ = false;
  }
  const Descriptor folder(::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder) ::fsync(folder.get());
  return {};
}

// link() fails where the name is taken, whoever was quicker; a folder that knows no links (some network shares) gets a
// look first.
Named DropFile::take_free_name(const std::string& path, const std::atomic<bool>& given_up) {
  if (given_up) return std::unexpected(kGivenUp);
  if (::link(path_.c_str(), path.c_str()) == 0) return {};  // the destructor removes the other name
  if (errno == EEXIST) return same_text(path);
  struct stat status{};
  if (::stat(path.c_str(), &status) == 0) return same_text(path);
  if (given_up) return std::unexpected(kGivenUp);
  if (::rename(path_.c_str(), path.c_str()) != 0) return std::unexpected(kNameNotTaken);
  exists_ = false;
  return {};
}

Named DropFile::same_text(const std::string& path) {
  const auto there = sha256_of_file(path);
  if (!there || *there != digest_) return std::unexpected("another program lies there under this name");
  return {};
}

}  // namespace dripfeed::app
