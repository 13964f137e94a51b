// One thread a folder: it writes what the ledger reserved, piece by piece, and looks once a second whether the folder
// is there. Nothing of a broken-off job stays but its ledger: the unnamed file is removed, at the next start at the
// latest.
#include "server/app/drop_line.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <condition_variable>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "protocol/tape_code/wire_encoder.h"
#include "store/hash/hash.h"

namespace dripfeed::app {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPiece = 16'384;
constexpr std::chrono::seconds kLook{1};
constexpr std::chrono::milliseconds kRetry{20};  // for a text that is not read yet
constexpr std::chrono::minutes kAbandoned{10};
constexpr std::string_view kUnnamed = ".dripfeed-";

std::string system_text() { return std::strerror(errno); }

// A descriptor that closes itself.
class File {
 public:
  File() = default;
  explicit File(int descriptor) : descriptor_(descriptor) {}
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  File(File&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  File& operator=(File&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  ~File() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  [[nodiscard]] int get() const { return descriptor_; }
  explicit operator bool() const { return descriptor_ >= 0; }

 private:
  int descriptor_ = -1;
};

// One job on its way into the folder.
struct Drop {
  explicit Drop(LineOrder given) : order(std::move(given)) {}
  LineOrder order;
  std::string unnamed;  // the path until it is whole
  File file;
  std::optional<tape_code::WireEncoder> encoder;
  std::uint64_t total = 0;
  std::uint64_t written = 0;
  hash::Sha256 sum;  // of what was written, to compare with what is read back
  bool cancelled = false;
};

std::expected<std::string, std::string> sha256_of_file(const std::string& path) {
  const File file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file) return std::unexpected(system_text());
  std::array<std::byte, kPiece> piece{};
  hash::Sha256 sum;
  for (;;) {
    const ssize_t count = ::read(file.get(), piece.data(), piece.size());
    if (count < 0) return std::unexpected(system_text());
    if (count == 0) return sum.hex();
    sum.add(std::span<const std::byte>(piece).first(static_cast<std::size_t>(count)));
  }
}

class DropLine final : public Line {
 public:
  DropLine(const machine::LineSettings& settings, LineChanged changed)
      : folder_(settings.link.path), format_(drop_format(settings)), changed_(std::move(changed)) {
    const auto overwrite = settings.link.options.find("overwrite");
    overwrite_ = overwrite != settings.link.options.end() && overwrite->second == "yes";
    look_at_folder();
    remove_abandoned();
    thread_ = std::jthread([this](const std::stop_token& stop) { loop(stop); });
  }
  ~DropLine() override {
    thread_.request_stop();
    wake_.notify_all();
    thread_.join();
    if (drop_) ::unlink(drop_->unnamed.c_str());
  }

  std::expected<void, std::string> arm(LineOrder order) override {
    const std::lock_guard lock(mutex_);
    if (order.rounds != 1) return std::unexpected(std::string("a file is put into its folder once"));
    if (drop_) return std::unexpected(std::string("a job is being written already"));
    look_at_folder();
    if (!folder_error_.empty()) return std::unexpected(folder_error_);
    if (order.file_name.empty()) return std::unexpected(std::string("the program has no name for a file"));
    Drop drop(std::move(order));
    drop.unnamed = fmt::format("{}/{}{}", folder_, kUnnamed, drop.order.job);
    drop.total = tape_code::wire_length(format_, drop.order.facts.text_bytes(), drop.order.facts.eobs());
    ::unlink(drop.unnamed.c_str());  // of a job that a lost power left
    drop.file = File(::open(drop.unnamed.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644));
    if (!drop.file) return std::unexpected(fmt::format("cannot write to {}: {}", folder_, system_text()));
    drop.encoder.emplace(format_, *drop.order.source, drop.order.facts.text_bytes());
    drop_ = std::move(drop);
    report_.job = drop_->order.job;
    report_.session = drop_->order.session;
    report_.reserve = drop_->order.reserve;
    report_.total = drop_->total;
    report_.handed = report_.clocked = report_.confirmed = 0;
    report_.end = JobEnd::none;
    report_.cause = {};
    report_.known = {};
    publish(LineState::armed, "");
    wake();
    return {};
  }

  std::expected<void, std::string> command(feed::Command command) override {
    const std::lock_guard lock(mutex_);
    const bool ends =
        command == feed::Command::disarm || command == feed::Command::cancel || command == feed::Command::abort;
    if (!ends) return std::unexpected(std::string("this command has no meaning on a folder"));
    if (!drop_) return std::unexpected(std::string("no job is being written"));
    drop_->cancelled = true;
    wake();
    return {};
  }

  void extend_reserve(std::uint64_t job, std::uint64_t wire_offset) override {
    const std::lock_guard lock(mutex_);
    if (!drop_ || drop_->order.job != job) return;
    report_.reserve = std::max(report_.reserve, wire_offset);
    wake();
  }

  [[nodiscard]] LineReport report() const override {
    const std::lock_guard lock(mutex_);
    return report_;
  }

 private:
  void wake() {
    ++wakes_;
    wake_.notify_all();
  }

  void loop(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
      const std::uint64_t before = wakes_;
      const bool goes_on = drop_ ? write_some() : false;
      if (goes_on) {
        lock.unlock();  // a long text lets others in between two pieces
        lock.lock();
        continue;
      }
      if (!drop_) look_at_folder();
      const auto wait = drop_ ? std::chrono::nanoseconds(kRetry) : std::chrono::nanoseconds(kLook);
      wake_.wait_for(lock, stop, wait, [&] { return wakes_ != before; });
    }
  }

  // Whether there is more to do at once.
  bool write_some() {
    if (drop_->cancelled) return end(JobEnd::cancelled, "cancelled");
    if (drop_->written == drop_->total) return name_it();
    const std::uint64_t open = std::min(report_.reserve, drop_->total) - std::min(report_.reserve, drop_->written);
    if (open == 0) {
      publish(LineState::feeding, "waiting for ledger");
      return false;
    }
    std::array<std::byte, kPiece> piece{};
    std::array<std::uint8_t, kPiece> ends{};
    const std::size_t most = std::min<std::uint64_t>(open, kPiece);
    const auto filled = drop_->encoder->fill(std::span(piece).first(most), std::span(ends).first(most));
    if (filled.count == 0 && filled.status == tape_code::FillStatus::not_ready) {
      publish(LineState::feeding, "waiting for text");
      return false;
    }
    const bool may_go_on = filled.status == tape_code::FillStatus::more ||
                           filled.status == tape_code::FillStatus::end ||
                           filled.status == tape_code::FillStatus::not_ready;
    if (!may_go_on) return end(JobEnd::failed, "the text cannot be read");
    return store(std::span(piece).first(filled.count));
  }

  bool store(std::span<const std::byte> bytes) {
    drop_->sum.add(bytes);
    while (!bytes.empty()) {
      const ssize_t count = ::write(drop_->file.get(), bytes.data(), bytes.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return end(JobEnd::failed, "the folder does not take the file");
      bytes = bytes.subspan(static_cast<std::size_t>(count));
      drop_->written += static_cast<std::uint64_t>(count);
    }
    report_.handed = drop_->written;
    report_.clocked = drop_->written;
    report_.known = {.from = 0, .to = 0, .from_line = 0, .to_line = 0, .to_text = 0};  // no name yet: nobody reads it
    publish(LineState::feeding, "");
    return true;
  }

  // The whole file is on the disk and reads back as written; now it gets its name, unless that is taken.
  bool name_it() {
    publish(LineState::draining, "");
    if (::fsync(drop_->file.get()) != 0) return end(JobEnd::failed, "the folder does not take the file");
    const auto read_back = sha256_of_file(drop_->unnamed);
    if (!read_back || *read_back != drop_->sum.hex())
      return end(JobEnd::failed, "the file reads back otherwise than written");
    const std::string path = fmt::format("{}/{}", folder_, drop_->order.file_name);
    if (overwrite_) {
      if (::rename(drop_->unnamed.c_str(), path.c_str()) != 0)
        return end(JobEnd::failed, "the folder does not take the name");
      return whole();
    }
    // link() fails where the name is taken, whoever was quicker; a folder that knows no links (some network shares)
    // gets a look first.
    if (::link(drop_->unnamed.c_str(), path.c_str()) == 0) {
      ::unlink(drop_->unnamed.c_str());
      return whole();
    }
    if (errno == EEXIST) return taken(path);
    struct stat status{};
    if (::stat(path.c_str(), &status) == 0) return taken(path);
    if (::rename(drop_->unnamed.c_str(), path.c_str()) != 0)
      return end(JobEnd::failed, "the folder does not take the name");
    return whole();
  }

  bool taken(const std::string& path) {
    const auto there = sha256_of_file(path);
    if (!there || *there != drop_->sum.hex()) return end(JobEnd::failed, "another program lies there under this name");
    ::unlink(drop_->unnamed.c_str());
    return whole();  // the same text lies there already
  }

  bool whole() {
    const File folder(::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder) ::fsync(folder.get());
    report_.confirmed = drop_->total;
    report_.known = {.from = drop_->total,
                     .to = drop_->total,
                     .from_line = 0,
                     .to_line = 0,
                     .to_text = drop_->order.facts.text_bytes()};
    return end(JobEnd::done, "");
  }

  bool end(JobEnd how, std::string_view cause) {
    if (how != JobEnd::done) ::unlink(drop_->unnamed.c_str());
    drop_.reset();
    report_.end = how;
    report_.cause = cause;
    publish(LineState::idle, "", true);
    return false;
  }

  void look_at_folder() {
    struct stat status{};
    if (::stat(folder_.c_str(), &status) != 0) {
      folder_error_ = fmt::format("{}: {}", folder_, system_text());
    } else if (!S_ISDIR(status.st_mode)) {
      folder_error_ = fmt::format("{} is not a folder", folder_);
    } else if (::access(folder_.c_str(), W_OK | X_OK) != 0) {
      folder_error_ = fmt::format("{} cannot be written to", folder_);
    } else {
      folder_error_.clear();
    }
    if (!drop_) publish(folder_error_.empty() ? LineState::idle : LineState::disconnected, "");
  }

  // What a lost power left. Another line may be writing to the same folder, so only what nobody touched for long goes.
  void remove_abandoned() const {
    std::error_code error;
    for (fs::directory_iterator at(folder_, error), end; !error && at != end; at.increment(error)) {
      if (!at->path().filename().string().starts_with(kUnnamed)) continue;
      std::error_code failed;  // gone meanwhile, or somebody else's: it stays
      const auto touched = fs::last_write_time(at->path(), failed);
      if (!failed && fs::file_time_type::clock::now() - touched > kAbandoned) fs::remove(at->path(), failed);
    }
  }

  void publish(LineState state, std::string_view stall, bool ended = false) {
    const bool changed = ended || state != report_.state || stall != report_.stall;
    report_.state = state;
    report_.stall = stall;
    report_.link_error = folder_error_;
    report_.confirms = true;
    if (!changed) return;
    ++report_.changes;
    changed_();
  }

  std::string folder_;
  tape_code::WireFormat format_;
  LineChanged changed_;
  bool overwrite_ = false;
  std::string folder_error_;
  std::optional<Drop> drop_;
  std::uint64_t wakes_ = 0;
  mutable std::mutex mutex_;
  std::condition_variable_any wake_;
  LineReport report_;
  std::jthread thread_;
};

}  // namespace

tape_code::WireFormat drop_format(const machine::LineSettings& settings) {
  tape_code::WireFormat format;
  format.eighth_bit = tape_code::EighthBit::data;
  format.eob = settings.eob;
  return format;
}

std::expected<std::unique_ptr<Line>, std::string> make_drop_line(const machine::LineSettings& settings,
                                                                 LineChanged changed) {
  const auto effective = machine::effective_line(settings);
  if (!effective) return std::unexpected(effective.error());
  return std::make_unique<DropLine>(*effective, std::move(changed));
}

}  // namespace dripfeed::app
