// POSIX reads without a layer between: the stream has a buffer of its own.
#include "server/cli/program_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "server/cli/memory_budget.h"

namespace dripfeed::cli {

namespace {

std::string system_error(const std::string& path) { return fmt::format("{}: {}", path, std::strerror(errno)); }

}  // namespace

app::Result<std::unique_ptr<ProgramFile>> ProgramFile::open(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return app::fail(app::ErrorCode::unavailable, system_error(path));
  struct stat facts{};
  const bool known = fstat(file, &facts) == 0;
  std::unique_ptr<ProgramFile> opened(new ProgramFile(
      file, path,
      known && S_ISREG(facts.st_mode) ? std::optional(static_cast<std::uint64_t>(facts.st_size)) : std::nullopt));
  if (known && S_ISDIR(facts.st_mode))
    return app::fail(app::ErrorCode::unavailable, fmt::format("{}: is a folder", path));
  return opened;
}

ProgramFile::~ProgramFile() { ::close(file_); }

std::expected<std::size_t, std::string> ProgramFile::read(std::span<char> into) {
  for (;;) {
    const ssize_t count = ::read(file_, into.data(), into.size());
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno != EINTR) return std::unexpected(system_error(path_));
  }
}

std::expected<std::string, std::string> ProgramFile::whole() {
  if (!size_bytes_ || *size_bytes_ > UINT32_MAX)
    return std::unexpected(fmt::format("{}: a text of 4 GiB or more cannot be held whole", path_));
  auto text = bytes(0, *size_bytes_);
  if (!text) return std::unexpected(text.error().text);
  return std::move(*text);
}

app::Result<text::Source> ProgramFile::head() {
  grant_memory(size_bytes_.value_or(0));
  auto text = bytes(0, kWholeBytes);
  if (!text) return std::unexpected(text.error());
  const std::size_t last = text->find_last_of("\r\n");
  if (text->size() == kWholeBytes && last != std::string::npos) text->resize(last + 1);
  return text::Source(path_, std::move(*text));
}

app::Result<ProgramFile::Line> ProgramFile::line_at(std::uint64_t offset) {
  constexpr std::uint64_t kLongest = 4096;  // bytes shown on either side
  const std::uint64_t first = offset > kLongest ? offset - kLongest : 0;
  const auto around = bytes(first, 2 * kLongest);
  if (!around) return std::unexpected(around.error());
  const auto here = std::min(static_cast<std::size_t>(offset - first), around->size());
  const std::size_t eob = here == 0 ? std::string::npos : around->find_last_of("\r\n", here - 1);
  const std::size_t begin = eob == std::string::npos ? 0 : eob + 1;
  const std::size_t end = std::min(around->find_first_of("\r\n", here), around->size());
  return Line{around->substr(begin, end - begin), here - begin};
}

app::Result<std::string> ProgramFile::bytes(std::uint64_t offset, std::size_t count) const {
  std::string text(count, '\0');
  std::size_t filled = 0;
  while (filled < count) {
    const ssize_t got = ::pread(file_, text.data() + filled, count - filled, static_cast<off_t>(offset + filled));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return app::fail(app::ErrorCode::unavailable, system_error(path_));
    if (got == 0) break;
    filled += static_cast<std::size_t>(got);
  }
  text.resize(filled);
  return text;
}

}  // namespace dripfeed::cli
