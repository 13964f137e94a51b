// write() and fdatasync(): nothing in between that could keep a line back.
#include "server/cli/file_ledger.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace dripfeed::cli {

std::expected<FileLedger, std::string> FileLedger::create(const std::string& path, const std::string& head) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0644);
  if (descriptor < 0) return std::unexpected(fmt::format("ledger {}: {}", path, std::strerror(errno)));
  FileLedger ledger(descriptor, path);
  const auto written = ledger.append(head + "\nat_ms handed clocked confirmed reserve note\n");
  if (!written) return std::unexpected(written.error());
  return ledger;
}

FileLedger::FileLedger(FileLedger&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), path_(std::move(other.path_)) {}

FileLedger::~FileLedger() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::expected<void, std::string> FileLedger::append(const std::string& line) {
  const ssize_t count = ::write(descriptor_, line.data(), line.size());
  if (count == static_cast<ssize_t>(line.size()) && ::fdatasync(descriptor_) == 0) return {};
  return std::unexpected(fmt::format("ledger {}: {}", path_, count >= 0 ? "not written whole" : std::strerror(errno)));
}

std::expected<void, std::string> FileLedger::write(std::int64_t at_ms, const app::LineReport& report,
                                                   std::uint64_t reserve, const std::string& note) {
  return append(
      fmt::format("{} {} {} {} {} {}\n", at_ms, report.handed, report.clocked, report.confirmed, reserve, note));
}

}  // namespace dripfeed::cli
