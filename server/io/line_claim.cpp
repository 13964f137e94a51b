// flock() on NAME.lock: the system drops it with the process, however that ends. The file stays, because removing it
// would let two processes lock two files of one name.
#include "server/io/line_claim.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "server/io/lock_holder.h"
#include "server/io/serial_identity.h"
#include "server/io/steady_clock.h"

namespace dripfeed::io {

namespace {

namespace fs = std::filesystem;

using Done = std::expected<void, std::string>;

constexpr std::size_t kMostNameBytes = 180;  // of a file name, without its ending

std::int64_t wall_ms() { return SteadyClock().wall_ms(); }

// Letters, digits, '.', '-' and '_' as they are; all else as %XX. Their sum keeps long names distinct.
std::string file_name_of(std::string_view name) {
  std::string file;
  for (const char c : name) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '_';
    file += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  if (file.size() <= kMostNameBytes) return file;
  return fmt::format("{}~{:016x}", file.substr(0, kMostNameBytes - 17), fnv1a(name));
}

// "dripfeed send part.nc --link … (pid 77)"
std::string this_process() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::string line((std::istreambuf_iterator<char>(file)), {});
  while (!line.empty() && line.back() == '\0') line.pop_back();
  std::ranges::replace(line, '\0', ' ');
  line.erase(0, line.substr(0, line.find(' ')).rfind('/') + 1);
  constexpr std::size_t kMost = 120;
  if (line.size() > kMost) line = line.substr(0, kMost) + "…";
  return fmt::format("{} (pid {})", line, ::getpid());
}

// A lock file that is ours while this lives.
class LineLock {
 public:
  static std::expected<LineLock, std::string> take(const std::string& path, const std::string& line) {
    LineLock lock(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0664));
    if (lock.file_ < 0) return std::unexpected(fmt::format("the lock {}: {}", path, std::strerror(errno)));
    if (::flock(lock.file_, LOCK_EX | LOCK_NB) != 0) {
      if (errno != EWOULDBLOCK) return std::unexpected(fmt::format("the lock {}: {}", path, std::strerror(errno)));
      return std::unexpected(fmt::format("the line {} is in use by {}", line, lock.holder()));
    }
    // For people. A crash leaves it there, and no one reads it then.
    const std::string us = fmt::format("{}, since {}\n", this_process(), text_of_time(wall_ms()));
    if (::ftruncate(lock.file_, 0) != 0 ||
        ::pwrite(lock.file_, us.data(), us.size(), 0) != static_cast<ssize_t>(us.size()))
      return std::unexpected(fmt::format("the lock {}: {}", path, std::strerror(errno)));
    return lock;
  }
  LineLock(LineLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  LineLock& operator=(LineLock&& other) noexcept {
    std::swap(file_, other.file_);
    return *this;
  }
  LineLock(const LineLock&) = delete;
  LineLock& operator=(const LineLock&) = delete;
  ~LineLock() {
    if (file_ >= 0) ::close(file_);
  }

 private:
  explicit LineLock(int file) : file_(file) {}
  // Whoever took it a moment ago may not have signed yet.
  [[nodiscard]] std::string holder() const {
    std::string text(512, '\0');
    const ssize_t count = ::pread(file_, text.data(), text.size(), 0);
    text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    text.erase(std::min(text.size(), text.find('\n')));
    return text.empty() ? "another process" : text;
  }

  int file_;
};

// One name of a line that is ours.
struct Held {
  std::string name;
  LineLock lock;
  RecordFile file;
};

std::expected<Held, std::string> hold(const fs::path& folder, const std::string& name) {
  const std::string path = (folder / file_name_of(name)).string();
  auto lock = LineLock::take(path + ".lock", name);
  if (!lock) return std::unexpected(lock.error());
  auto file = RecordFile::open(path + ".state");
  if (!file) return std::unexpected(file.error());
  return Held{.name = name, .lock = std::move(*lock), .file = std::move(*file)};
}

class FileClaim final : public app::LineClaim {
 public:
  FileClaim(fs::path folder, machine::LinkUrl link, std::string sysfs)
      : folder_(std::move(folder)), link_(std::move(link)), sysfs_(std::move(sysfs)) {}

  // Takes every name that the line has now, and lets go of those that it has no more. Between two transfers a device
  // may have been plugged in, or another one.
  Done take_names() {
    const LineNames now = names_of(link_, sysfs_);
    std::vector<Held> held;
    for (const std::string& name : now.names) {
      const auto known = std::ranges::find(held_, name, &Held::name);
      if (known != held_.end()) {
        held.push_back(std::move(*known));
        held_.erase(known);
        continue;
      }
      auto one = hold(folder_, name);
      if (!one) {
        std::ranges::move(held, std::back_inserter(held_));
        return std::unexpected(one.error());
      }
      held.push_back(std::move(*one));
    }
    held_ = std::move(held);
    device_ = now.device;
    if (torn_.empty()) torn_ = read_torn();
    return {};
  }

  [[nodiscard]] std::string torn() const override { return torn_; }

  Done begin(std::string_view what) override {
    if (sending_) return write({.state = RecordState::sending, .what = std::string(what)});
    if (auto taken = take_names(); !taken) return taken;
    if (!torn_.empty()) return std::unexpected(torn_);
    if (auto written = write({.state = RecordState::sending, .what = std::string(what)}); !written) return written;
    sending_ = true;
    return {};
  }

  Done end() override {
    if (!sending_) return {};
    if (auto written = write({.what = what_}); !written) return written;
    sending_ = false;
    return {};
  }

  Done tear(std::string_view why) override {
    const LineRecord record = signed_now({.state = RecordState::torn, .what = what_, .why = std::string(why)});
    torn_ = describe(record);
    sending_ = false;
    return write(record);
  }

  Done confirm_reset(std::string_view reason) override {
    if (reason.find_first_not_of(" \t\r\n") == std::string_view::npos)
      return std::unexpected(std::string("a confirmed reset needs a reason: who looked, and what was done"));
    if (sending_) return std::unexpected(std::string("something is being sent on this line"));
    if (auto taken = take_names(); !taken) return taken;
    torn_.clear();
    const Done written = write({.what = "reset confirmed", .why = std::string(reason)});
    if (!written) torn_ = written.error();
    return written;
  }

 private:
  // The device is that of the path as written: a record of what is plugged in anywhere says nothing of a path.
  [[nodiscard]] std::string read_torn() const {
    for (const Held& one : held_) {
      if (one.file.record().state != RecordState::clean) return describe(one.file.record());
    }
    return held_.empty() ? std::string() : other_device(held_.front().file.record().device, device_);
  }

  static LineRecord signed_now(LineRecord record) {
    record.by = this_process();
    record.at_ms = wall_ms();
    return record;
  }

  Done write(LineRecord record) {
    record = signed_now(std::move(record));
    what_ = record.what;
    for (Held& one : held_) {
      record.line = one.name;
      record.device = device_.empty() ? one.file.record().device : device_;
      if (auto written = one.file.write(record); !written) return written;
    }
    return {};
  }

  fs::path folder_;
  machine::LinkUrl link_;
  std::string sysfs_;
  std::vector<Held> held_;  // the first one is the path or address as written
  std::string device_;      // at the port now
  std::string torn_;
  std::string what_ = "what was sent";
  bool sending_ = false;
};

// Makes the folder and its parents, each durable; or what the system refused.
std::error_code make_folder(const fs::path& folder) {
  std::error_code error;
  if (fs::is_directory(folder, error)) return {};
  if (folder.has_relative_path()) {
    if (auto above = make_folder(folder.parent_path())) return above;
  }
  fs::create_directory(folder, error);
  if (!error) error.assign(sync_folder(folder.parent_path().string()), std::generic_category());
  return error;
}

const char* environment(const char* name) {
  const char* const value = std::getenv(name);  // nothing changes it while the process runs
  return value != nullptr && *value != '\0' ? value : nullptr;
}

std::unexpected<std::string> no_folder(const fs::path& folder, std::string_view why) {
  return std::unexpected(fmt::format(
      "the folder of the lines' records, {}: {}; make it writable for this user, or name another one by DRIPFEED_LINES",
      folder.string(), why));
}

std::expected<fs::path, std::string> made(const fs::path& folder) {
  if (const auto error = make_folder(folder)) return no_folder(folder, error.message());
  if (::access(folder.c_str(), W_OK | X_OK) != 0) return no_folder(folder, std::strerror(errno));
  return folder;
}

}  // namespace

std::expected<fs::path, std::string> lines_folder() {
  if (const char* const given = environment("DRIPFEED_LINES")) return made(plain_path(given));
  const fs::path of_system = "/var/lib/dripfeed/lines";
  std::error_code error;
  if (!make_folder(of_system) || fs::exists(of_system.parent_path(), error)) return made(of_system);
  if (const char* const state = environment("XDG_STATE_HOME"); state != nullptr && *state == '/')
    return made(fs::path(state) / "dripfeed/lines");
  if (const char* const home = environment("HOME")) return made(fs::path(home) / ".local/state/dripfeed/lines");
  return no_folder(of_system, "it cannot be made, and there is no HOME");
}

fs::path known_lines_folder() {
  if (const char* const given = environment("DRIPFEED_LINES")) return plain_path(given);
  fs::path of_system = "/var/lib/dripfeed/lines";
  std::error_code error;
  if (fs::exists(of_system.parent_path(), error) || ::access("/var/lib", W_OK) == 0) return of_system;
  if (const char* const state = environment("XDG_STATE_HOME"); state != nullptr && *state == '/')
    return fs::path(state) / "dripfeed/lines";
  if (const char* const home = environment("HOME")) return fs::path(home) / ".local/state/dripfeed/lines";
  return {};
}

std::string line_holder(const fs::path& folder, const machine::LinkUrl& link, const std::string& sysfs) {
  for (const std::string& name : names_of(link, sysfs).names) {
    const std::string path = (folder / file_name_of(name)).string() + ".lock";
    if (!lock_holder(path)) continue;
    std::string signature;
    std::ifstream file(path);
    std::getline(file, signature);
    return signature.empty() ? "another process" : signature;
  }
  return {};
}

std::expected<std::unique_ptr<app::LineClaim>, std::string> claim_line_in(const fs::path& folder,
                                                                          const machine::LinkUrl& link,
                                                                          const std::string& sysfs) {
  auto claim = std::make_unique<FileClaim>(folder, link, sysfs);
  if (const auto taken = claim->take_names(); !taken) return std::unexpected(taken.error());
  return claim;
}

std::expected<std::unique_ptr<app::LineClaim>, std::string> claim_line(const machine::LinkUrl& link) {
  const auto folder = lines_folder();
  if (!folder) return std::unexpected(folder.error());
  return claim_line_in(*folder, link);
}

std::expected<LineRecord, std::string> look_at_line(const machine::LinkUrl& link) {
  const auto folder = lines_folder();
  if (!folder) return std::unexpected(folder.error());
  LineRecord first;
  for (const std::string& name : names_of(link).names) {
    auto record = RecordFile::look((*folder / file_name_of(name)).string() + ".state");
    if (!record || record->state != RecordState::clean) return record;
    if (first.line.empty()) first = std::move(*record);
    if (first.line.empty()) first.line = name;
  }
  return first;
}

}  // namespace dripfeed::io
