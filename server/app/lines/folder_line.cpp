// A hung file server keeps a system call for as long as it likes. So each folder has a thread of its own, which alone
// touches the folder and holds no lock meanwhile; whoever asks the line something is answered from its state. Line and
// thread share that state: a thread that hangs outlives its line, and finds on its return that no one wants it any
// more.
#include "server/app/lines/folder_line.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <optional>
#include <system_error>
#include <thread>
#include <type_traits>
#include <utility>

#include <fmt/format.h>
#include <sys/prctl.h>
#include <unistd.h>

#include "protocol/tape_code/wire_encoder.h"
#include "server/app/lines/drop_file.h"
#include "server/app/ports/line_mutex.h"

namespace dripfeed::app {

namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr std::size_t kPiece_bytes = 16'384;
constexpr std::chrono::seconds kLook{1};
constexpr std::chrono::milliseconds kRetry{20};     // for a text that is not read yet
constexpr std::chrono::seconds kPatience{1};        // then a folder counts as one that does not answer
constexpr std::chrono::milliseconds kFarewell{20};  // a line that goes waits so long for its thread to tidy up
constexpr std::string_view kNoAnswer = "folder does not answer";

// One job that is being written into the folder.
struct Drop {
  Drop(LineOrder given, const tape_code::WireFormat& format)
      : order(std::move(given)),
        encoder(format, *order.source, order.facts.text_bytes()),
        total(tape_code::wire_length(format, order.facts.text_bytes(), order.facts.eobs())) {}
  LineOrder order;
  tape_code::WireEncoder encoder;
  std::uint64_t total;
  std::uint64_t written = 0;
};

// What line and thread share. Members without a remark are guarded by the mutex, which no one holds over file I/O.
class Folder {
 public:
  Folder(const machine::LineSettings& settings, LineChanged changed, feed::LeftAs left)
      : path_(settings.link.path),
        format_(folder_format(settings)),
        changed_(std::move(changed)),
        left_torn_(left == feed::LeftAs::torn) {
    if (left_torn_) report_.state = LineState::torn;
    const auto overwrite = settings.link.options.find("overwrite");
    overwrite_ = overwrite != settings.link.options.end() && overwrite->second == "yes";
    error_ = fmt::format("{}: not looked at yet", path_);
    report_.link_error = error_;
    report_.confirms = true;
  }

  std::expected<void, std::string> arm(LineOrder order) {
    const std::lock_guard lock(mutex_);
    if (order.rounds != 1) return std::unexpected(std::string("a file is put into its folder once"));
    if (left_torn_)
      return std::unexpected(std::string("a transfer broke off here: confirm that the control was reset"));
    if (drop_) return std::unexpected(std::string("a job is being written already"));
    if (hangs()) return std::unexpected(no_answer());
    if (!error_.empty()) return std::unexpected(error_);
    if (order.file_name.empty()) return std::unexpected(std::string("the program has no name for a file"));
    drop_.emplace(std::move(order), format_);
    given_up_ = false;
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

  std::expected<void, std::string> command(feed::Command command) {
    const std::lock_guard lock(mutex_);
    if (command == feed::Command::confirm_reset && left_torn_) {
      left_torn_ = false;
      publish(LineState::disconnected, "");  // until the next look
      wake();
      return {};
    }
    const bool ends =
        command == feed::Command::disarm || command == feed::Command::cancel || command == feed::Command::abort;
    if (!ends) return std::unexpected(std::string("this command has no meaning on a folder"));
    if (!drop_) return std::unexpected(std::string("no job is being written"));
    given_up_ = true;
    wake();
    return {};
  }

  void extend_reserve(std::uint64_t job, std::uint64_t wire_offset) {
    const std::lock_guard lock(mutex_);
    if (!drop_ || drop_->order.job != job) return;
    report_.reserve = std::max(report_.reserve, wire_offset);
    wake();
  }

  [[nodiscard]] LineReport report() const {
    const std::lock_guard lock(mutex_);
    LineReport report = report_;
    if (!hangs()) return report;
    report.link_error = no_answer();
    if (drop_) report.stall = kNoAnswer;
    if (!drop_ && !left_torn_) report.state = LineState::disconnected;
    return report;
  }

  // The line goes: no one is called any more, and the text is given back.
  void close() {
    std::unique_lock lock(mutex_);
    closed_ = true;
    given_up_ = true;
    changed_ = nullptr;
    drop_.reset();
    wake();
    woken_.wait_for(lock, kFarewell, [this] { return over_; });
  }

  // The thread.
  void run() {
    ::prctl(PR_SET_NAME, "folder");
    std::unique_lock lock(mutex_);
    try {
      outside(lock, [this] { remove_abandoned(path_); });
      while (!closed_) turn(lock);
      outside(lock, [this] { file_.reset(); });
    } catch (const std::exception& error) {  // the fence: no memory, say. The folder is out of order, the server is not
      if (!lock.owns_lock()) lock.lock();
      busy_since_.reset();
      error_ = fmt::format("{}: its thread ended: {}", path_, error.what());
      if (drop_) report_.end = JobEnd::failed;
      report_.cause = "the folder's thread ended";
      drop_.reset();
      publish(LineState::disconnected, "", true);
    }
    over_ = true;
    woken_.notify_all();
  }

 private:
  void turn(std::unique_lock<LineMutex>& lock) {
    const std::uint64_t before = wakes_;
    if (drop_ ? write_some(lock) : look(lock)) return;
    const auto wait = drop_ ? std::chrono::nanoseconds(kRetry) : std::chrono::nanoseconds(kLook);
    woken_.wait_for(lock, wait, [&] { return closed_ || wakes_ != before; });
  }

  // Runs `work`, which touches the folder, without the lock.
  template <class Work>
  std::invoke_result_t<Work> outside(std::unique_lock<LineMutex>& lock, const Work& work) {
    struct Busy {
      Busy(Folder& folder, std::unique_lock<LineMutex>& held) : folder_(folder), held_(held) {
        folder_.busy_since_ = SteadyClock::now();
        held_.unlock();
      }
      Busy(const Busy&) = delete;
      Busy& operator=(const Busy&) = delete;
      ~Busy() {
        held_.lock();
        folder_.busy_since_.reset();
      }
      Folder& folder_;
      std::unique_lock<LineMutex>& held_;
    };
    const Busy busy(*this, lock);
    return work();
  }

  // Whether there is more to do at once.
  bool look(std::unique_lock<LineMutex>& lock) {
    std::string seen = outside(lock, [this] { return look_at_folder(path_); });
    error_ = std::move(seen);
    if (!drop_) publish(error_.empty() ? LineState::idle : LineState::disconnected, "");
    return drop_.has_value();
  }

  bool write_some(std::unique_lock<LineMutex>& lock) {
    if (given_up_) return end(lock, JobEnd::cancelled, "cancelled");
    if (!file_) return create(lock);
    if (drop_->written == drop_->total) return name_it(lock);
    const std::uint64_t open = std::min(report_.reserve, drop_->total) - std::min(report_.reserve, drop_->written);
    if (open == 0) {
      publish(LineState::feeding, "waiting for ledger");
      return false;
    }
    std::array<std::byte, kPiece_bytes> piece{};
    std::array<std::uint8_t, kPiece_bytes> ends{};
    const std::size_t most = std::min<std::uint64_t>(open, kPiece_bytes);
    const auto filled = drop_->encoder.fill(std::span(piece).first(most), std::span(ends).first(most));
    if (filled.count == 0 && filled.status == tape_code::FillStatus::not_ready) {
      publish(LineState::feeding, "waiting for text");
      return false;
    }
    const bool may_go_on = filled.status == tape_code::FillStatus::more ||
                           filled.status == tape_code::FillStatus::end ||
                           filled.status == tape_code::FillStatus::not_ready;
    if (!may_go_on) return end(lock, JobEnd::failed, "the text cannot be read");
    return store(lock, std::span(piece).first(filled.count));
  }

  // A job that finds no place for its file goes back: nothing of it is in the folder.
  bool create(std::unique_lock<LineMutex>& lock) {
    const std::string name = fmt::format("{}-{:x}-{}", drop_->order.job, drop_->order.session, ::getpid());
    file_.emplace(path_, name);
    const auto created = outside(lock, [this] { return file_->create(); });
    if (!drop_) return false;
    if (created) return true;
    error_ = created.error();
    return end(lock, JobEnd::disarmed, "the folder does not take a file");
  }

  bool store(std::unique_lock<LineMutex>& lock, std::span<const std::byte> bytes) {
    const auto stored = outside(lock, [&] { return file_->write(bytes); });
    if (!drop_) return false;
    if (!stored) {
      error_ = stored.error();
      return end(lock, JobEnd::failed, "the folder does not take the file");
    }
    drop_->written += bytes.size();
    report_.handed = report_.clocked = drop_->written;
    report_.known = {};  // no name yet: no one reads it
    publish(LineState::feeding, "");
    return true;
  }

  // From here on the control may have the whole file, until the folder says otherwise.
  bool name_it(std::unique_lock<LineMutex>& lock) {
    report_.known = {
        .from = 0, .to = drop_->total, .from_line = 0, .to_line = 0, .to_text = drop_->order.facts.text_bytes()};
    publish(LineState::draining, "");
    const std::string name = drop_->order.file_name;
    const auto named = outside(lock, [&] { return file_->give_name(name, overwrite_, given_up_); });
    if (!drop_) return false;
    if (named) {
      report_.confirmed = report_.known.from = drop_->total;
      return end(lock, JobEnd::done, "");
    }
    if (named.error() != kNameNotTaken) report_.known = {};
    return end(lock, given_up_ ? JobEnd::cancelled : JobEnd::failed, named.error());
  }

  bool end(std::unique_lock<LineMutex>& lock, JobEnd how, std::string_view cause) {
    outside(lock, [this] { file_.reset(); });
    if (!drop_) return false;  // closed meanwhile
    drop_.reset();
    report_.end = how;
    report_.cause = cause;
    publish(error_.empty() ? LineState::idle : LineState::disconnected, "", true);
    return false;
  }

  // The folder keeps its thread for longer than a folder that answers does.
  [[nodiscard]] bool hangs() const { return busy_since_ && SteadyClock::now() - *busy_since_ > kPatience; }
  [[nodiscard]] std::string no_answer() const { return fmt::format("{}: the {}", path_, kNoAnswer); }

  void wake() {
    ++wakes_;
    woken_.notify_all();
  }

  void publish(LineState state, std::string_view stall, bool ended = false) {
    if (left_torn_) state = LineState::torn;
    const bool changed = ended || state != report_.state || stall != report_.stall;
    report_.state = state;
    report_.stall = stall;
    report_.link_error = error_;
    if (!changed) return;
    ++report_.changes;
    if (changed_) changed_();
  }

  const std::string path_;
  const tape_code::WireFormat format_;
  bool overwrite_ = false;  // constant, too
  LineChanged changed_;
  bool left_torn_;     // by whoever had the line before
  std::string error_;  // why nothing can be written there; empty: at the last look it could
  std::optional<Drop> drop_;
  std::optional<DropFile> file_;       // the thread's alone
  std::atomic<bool> given_up_{false};  // read by the thread without the lock
  std::optional<SteadyClock::time_point> busy_since_;
  std::uint64_t wakes_ = 0;
  bool closed_ = false;
  bool over_ = false;  // the thread
  LineReport report_;
  mutable LineMutex mutex_{"a folder"};
  std::condition_variable_any woken_;
};

class FolderLine final : public Line {
 public:
  explicit FolderLine(std::shared_ptr<Folder> folder) : folder_(std::move(folder)) {
    std::thread([shared = folder_] { shared->run(); }).detach();
  }
  ~FolderLine() override { folder_->close(); }

  std::expected<void, std::string> arm(LineOrder order) override { return folder_->arm(std::move(order)); }
  std::expected<void, std::string> command(feed::Command command) override { return folder_->command(command); }
  void extend_reserve(std::uint64_t job, std::uint64_t wire_offset) override {
    folder_->extend_reserve(job, wire_offset);
  }
  [[nodiscard]] LineReport report() const override { return folder_->report(); }

 private:
  std::shared_ptr<Folder> folder_;
};

}  // namespace

tape_code::WireFormat folder_format(const machine::LineSettings& settings) {
  tape_code::WireFormat format;
  format.eighth_bit = tape_code::EighthBit::data;
  format.eob = settings.eob;
  return format;
}

std::expected<std::unique_ptr<Line>, std::string> make_folder_line(const machine::LineSettings& settings,
                                                                   LineChanged changed, feed::LeftAs left) {
  const auto effective = machine::effective_line(settings);
  if (!effective) return std::unexpected(effective.error());
  try {
    return std::make_unique<FolderLine>(std::make_shared<Folder>(*effective, std::move(changed), left));
  } catch (const std::system_error& error) {
    return std::unexpected(fmt::format("{}: no thread for the folder: {}", settings.link.text, error.what()));
  }
}

}  // namespace dripfeed::app
