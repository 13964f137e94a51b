// O_TMPFILE where the file system has it; elsewhere a name that is gone before the first byte is written.
#include "server/http/spool.h"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include "server/http/request.h"

namespace dripfeed::http {

namespace {

std::unexpected<std::string> refusal(std::string_view why) {
  return std::unexpected(fmt::format("the disk does not take this upload: {}", why));
}

std::unexpected<std::string> system_refusal(int error) { return refusal(std::generic_category().message(error)); }

std::expected<int, std::string> open_unnamed(const std::filesystem::path& folder) {
  if (::mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST) return system_refusal(errno);
  int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (file >= 0) return file;
  if (errno != EOPNOTSUPP && errno != EISDIR && errno != EINVAL) return system_refusal(errno);
  std::string name = (folder / "XXXXXX").string();
  file = ::mkostemp(name.data(), O_CLOEXEC);
  if (file < 0) return system_refusal(errno);
  ::unlink(name.c_str());  // should it fail, an empty name is left in a folder of ours
  return file;
}

// Uploads are never what takes the last room of a disk on which the ledger lies.
bool has_room(int file, std::uint64_t bytes) {
  struct statvfs disk{};
  if (::fstatvfs(file, &disk) != 0) return true;  // then a write says it
  return std::uint64_t{disk.f_bavail} * disk.f_frsize >= bytes + kSpoolKeepsFree_bytes;
}

}  // namespace

// A file goes with its last descriptor, which takes the disk some time. Where the lane is stopped the process ends.
SpooledBody::~SpooledBody() {
  if (file_ >= 0) static_cast<void>(lanes_.submit(Lane::spool, [file = file_] { ::close(file); }));
}

std::expected<void, std::string> SpooledBody::append(const std::filesystem::path& folder, std::string_view piece) {
  if (file_ < 0) {
    const auto opened = open_unnamed(folder);
    if (!opened) return std::unexpected(opened.error());
    file_ = *opened;
  }
  if (!has_room(file_, piece.size())) return refusal("no room is left");
  while (!piece.empty()) {
    const ssize_t count = ::write(file_, piece.data(), piece.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return system_refusal(errno);
    piece.remove_prefix(static_cast<std::size_t>(count));
    bytes_ += static_cast<std::uint64_t>(count);
  }
  return {};
}

std::expected<std::size_t, std::string> SpooledBody::read(std::uint64_t offset, std::span<char> into) const {
  const std::size_t most = static_cast<std::size_t>(std::min<std::uint64_t>(into.size(), bytes_ - offset));
  std::size_t done = 0;
  while (done < most) {
    const ssize_t count = ::pread(file_, into.data() + done, most - done, static_cast<off_t>(offset + done));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return system_refusal(errno);
    if (count == 0) return refusal("a part of it is missing");
    done += static_cast<std::size_t>(count);
  }
  return done;
}

std::expected<std::string, std::string> SpooledBody::read() const {
  std::string text(bytes_, '\0');
  const auto read_all = read(0, text);
  if (!read_all) return std::unexpected(read_all.error());
  return text;
}

std::uint64_t body_bytes(const Request& request) {
  return request.spooled ? request.spooled->bytes() : request.body.size();
}

BodyPieces pieces_of(const Request& request) {
  return
      [&request, offset = std::uint64_t{0}](std::span<char> into) mutable -> std::expected<std::size_t, std::string> {
        if (request.spooled) {
          const auto count = request.spooled->read(offset, into);
          if (count) offset += *count;
          return count;
        }
        const std::size_t count = request.body.copy(into.data(), into.size(), static_cast<std::size_t>(offset));
        offset += count;
        return count;
      };
}

std::expected<void, std::string> fetch_body(Request& request) {
  if (!request.spooled) return {};
  auto text = request.spooled->read();
  if (!text) return std::unexpected(text.error());
  request.body = std::move(*text);
  request.spooled.reset();
  return {};
}

bool Spool::append(std::shared_ptr<SpooledBody> body, std::string piece, Then then) const {
  return lanes_.submit(Lane::spool, [&folder = folder_, body = std::move(body), piece = std::move(piece),
                                     then = std::move(then)]() mutable { then(body->append(folder, piece)); });
}

}  // namespace dripfeed::http
