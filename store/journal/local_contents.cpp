// Copies in pieces of 1 MiB, and compares the hash of what was copied.
#include "store/journal/local_contents.h"

#include <cerrno>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>
#include <unistd.h>

#include "store/hash/sha256.h"

namespace dripfeed::journal {
namespace {

using store::Error;
using store::ErrorCode;
using store::Result;

constexpr std::size_t kPiece = 16 * store::kChunkBytes;

std::unexpected<Error> fault(const std::string& what, int error) {
  return std::unexpected(
      Error{store::code_of_file_fault(error), fmt::format("{}: {}", what, std::generic_category().message(error))});
}

class LocalCopy final : public store::ContentReader {
 public:
  explicit LocalCopy(int file) : file_(file) {}
  ~LocalCopy() override { ::close(file_); }

  Result<std::size_t> read(std::uint64_t offset, std::span<char> into) override {
    const ssize_t count = ::pread(file_, into.data(), into.size(), static_cast<off_t>(offset));
    if (count < 0) return fault("the copy of a text", errno);
    return static_cast<std::size_t>(count);
  }

  Result<void> append(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t count = ::write(file_, bytes.data(), bytes.size());
      if (count < 0 && errno != EINTR) return fault("the copy of a text", errno);
      if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return {};
  }

 private:
  int file_;
};

}  // namespace

Result<std::shared_ptr<store::ContentReader>> LocalContents::reader(std::string_view sha256) {
  std::string path = folder_ + "/fed-text-XXXXXX";
  const int file = ::mkostemp(path.data(), O_CLOEXEC);
  if (file < 0) return fault(folder_, errno);
  ::unlink(path.c_str());
  auto copy = std::make_shared<LocalCopy>(file);
  hash::Sha256 hash;
  std::vector<char> piece(kPiece);
  std::uint64_t offset = 0;
  for (;;) {
    const auto got = there_.read(sha256, offset, piece);
    if (!got) return std::unexpected(got.error());
    if (*got == 0) break;
    const std::string_view bytes(piece.data(), *got);
    if (auto written = copy->append(bytes); !written) return std::unexpected(written.error());
    hash.add(bytes);
    offset += *got;
  }
  if (hash.hex() != sha256) return std::unexpected(Error{ErrorCode::corrupt, fmt::format("content/{}", sha256)});
  return copy;
}

}  // namespace dripfeed::journal
