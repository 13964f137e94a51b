// First line: "dripfeed-journal 1 NAME". Then for each entry "LENGTH HASH\n" and as many bytes, and a line feed.
#include "store/journal/journal_file.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "store/hash/hash.h"
#include "store/journal/entry_text.h"

namespace dripfeed::journal {
namespace {

using store::Error;
using store::ErrorCode;
using store::Result;

constexpr std::string_view kTitle = "dripfeed-journal 1 ";
constexpr std::size_t kNameDigits = 64;
constexpr std::size_t kHashDigits = 16;
constexpr mode_t kOwnerOnly = 0600;

std::string frame(std::string_view text) {
  return fmt::format("{} {}\n{}\n", text.size(), hash::sha256_hex(text).substr(0, kHashDigits), text);
}

struct Framed {
  Entry entry;
  std::size_t length = 0;  // with its frame
};

// The entry at the beginning of these bytes, if it is whole.
std::optional<Framed> framed_at(std::string_view bytes) {
  std::size_t length = 0;
  const auto [at, error] = std::from_chars(bytes.data(), bytes.data() + bytes.size(), length);
  const auto digits = static_cast<std::size_t>(at - bytes.data());
  const std::size_t head = digits + 1 + kHashDigits + 1;
  if (error != std::errc() || bytes.size() < head || length > bytes.size() - head - 1 || bytes.size() == head)
    return std::nullopt;
  const std::string_view text = bytes.substr(head, length);
  const std::string_view hash = bytes.substr(digits + 1, kHashDigits);
  if (bytes[digits] != ' ' || bytes[head - 1] != '\n' || bytes[head + length] != '\n' ||
      hash != std::string_view(hash::sha256_hex(text)).substr(0, kHashDigits))
    return std::nullopt;
  auto entry = entry_of(text);
  if (!entry) return std::nullopt;
  return Framed{std::move(*entry), head + length + 1};
}

bool has_an_entry(std::string_view bytes) {
  for (std::size_t at = bytes.find('\n'); at != std::string_view::npos; at = bytes.find('\n', at + 1)) {
    if (framed_at(bytes.substr(at + 1))) return true;
  }
  return false;
}

Result<std::string> read_all(int file) {
  std::string all;
  std::array<char, 65'536> piece;
  for (;;) {
    const ssize_t count = ::pread(file, piece.data(), piece.size(), static_cast<off_t>(all.size()));
    if (count < 0) return std::unexpected(Error{ErrorCode::io_failed, std::generic_category().message(errno)});
    if (count == 0) return all;
    all.append(piece.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

Result<JournalFile> JournalFile::open(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kOwnerOnly);
  if (descriptor < 0) {
    const int error = errno;
    return std::unexpected(
        Error{ErrorCode::cannot_open, fmt::format("{}: {}", path, std::generic_category().message(error))});
  }
  JournalFile file(path, descriptor);
  if (auto read = file.read(); !read) return std::unexpected(read.error());
  return file;
}

JournalFile::JournalFile(JournalFile&& other) noexcept
    : path_(std::move(other.path_)),
      file_(std::exchange(other.file_, -1)),
      name_(std::move(other.name_)),
      entries_(std::move(other.entries_)),
      end_(other.end_) {}

JournalFile::~JournalFile() {
  if (file_ >= 0) ::close(file_);
}

Error JournalFile::fault(int error) const {
  return {store::code_of_file_fault(error), fmt::format("{}: {}", path_, std::generic_category().message(error))};
}

Result<void> JournalFile::make_name() {
  name_ = hash::sha256_hex(hash::random_token());
  end_ = 0;
  return write_at_end(fmt::format("{}{}\n", kTitle, name_));
}

// A title that is not whole is one that a crash tore when the file was made.
Result<void> JournalFile::read() {
  const auto all = read_all(file_);
  if (!all) return std::unexpected(all.error());
  const std::string_view bytes = *all;
  const std::size_t title = kTitle.size() + kNameDigits + 1;
  if (bytes.size() < title && bytes.substr(0, kTitle.size()) == kTitle.substr(0, bytes.size())) return make_name();
  if (!bytes.starts_with(kTitle) || bytes[title - 1] != '\n')
    return std::unexpected(Error{ErrorCode::corrupt, fmt::format("{} is not a journal of a ledger", path_)});
  name_ = bytes.substr(kTitle.size(), kNameDigits);
  end_ = title;
  while (end_ < bytes.size()) {
    auto next = framed_at(bytes.substr(end_));
    if (!next) break;
    end_ += next->length;
    entries_.push_back(std::move(next->entry));
  }
  if (end_ == bytes.size()) return {};
  if (has_an_entry(bytes.substr(end_)))
    return std::unexpected(Error{ErrorCode::corrupt, fmt::format("{}: the entry at byte {} is damaged", path_, end_)});
  // Cut off, so that a shorter entry does not leave a piece of it standing.
  if (::ftruncate(file_, static_cast<off_t>(end_)) != 0) return std::unexpected(fault(errno));
  return {};
}

Result<void> JournalFile::write_at_end(const std::string& bytes) {
  std::size_t done = 0;
  int error = 0;
  while (done < bytes.size() && error == 0) {
    const ssize_t count = ::pwrite(file_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(end_ + done));
    if (count >= 0) done += static_cast<std::size_t>(count);
    if (count < 0 && errno != EINTR) error = errno;
  }
  if (error == 0 && ::fdatasync(file_) != 0) error = errno;
  if (error == 0) {
    end_ += bytes.size();
    return {};
  }
  // Whatever stands there now is written over by the next one, and no part of it is whole.
  static_cast<void>(::ftruncate(file_, static_cast<off_t>(end_)));
  return std::unexpected(fault(error));
}

Result<void> JournalFile::append(const Entry& entry) { return write_at_end(frame(text_of(entry))); }

Result<void> JournalFile::clear() {
  const std::uint64_t title = kTitle.size() + kNameDigits + 1;
  if (::ftruncate(file_, static_cast<off_t>(title)) != 0 || ::fdatasync(file_) != 0)
    return std::unexpected(fault(errno));
  end_ = title;
  return {};
}

}  // namespace dripfeed::journal
