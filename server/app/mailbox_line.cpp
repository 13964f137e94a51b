// The thread does what the sender asks for, one request at a time, and sleeps until the sender's deadline or a command.
// Commands take the lock between two requests, never during one.
#include "server/app/mailbox_line.h"

#include <algorithm>
#include <array>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "protocol/modbus/modbus.h"

namespace dripfeed::app {

namespace {

struct StateRow {
  modbus::SenderState sender;
  LineState line;
  JobEnd end;
};
// One row a state of the sender, in its order.
constexpr std::array<StateRow, modbus::kSenderStates> kStateRows = {{
    {modbus::SenderState::idle, LineState::idle, JobEnd::none},
    {modbus::SenderState::looking, LineState::armed, JobEnd::none},
    {modbus::SenderState::opening, LineState::armed, JobEnd::none},
    {modbus::SenderState::ready, LineState::feeding, JobEnd::none},
    {modbus::SenderState::delivering, LineState::feeding, JobEnd::none},
    {modbus::SenderState::closing, LineState::draining, JobEnd::none},
    {modbus::SenderState::finishing, LineState::draining, JobEnd::none},
    {modbus::SenderState::done, LineState::idle, JobEnd::done},
    {modbus::SenderState::holding, LineState::held, JobEnd::none},
    {modbus::SenderState::held, LineState::held, JobEnd::none},
    {modbus::SenderState::releasing, LineState::held, JobEnd::none},
    {modbus::SenderState::aborting, LineState::draining, JobEnd::none},
    {modbus::SenderState::aborted, LineState::idle, JobEnd::cancelled},
    {modbus::SenderState::stopped, LineState::idle, JobEnd::failed},
}};

// Stalls as people name them, in the sender's order; a hold is a person's stop, as on a serial line.
constexpr std::array<std::string_view, 8> kStallNames = {
    "",        "waiting for credit", "waiting for ledger", "waiting for text", "waiting for receiver", "peer gone",
    "stopped", "stopped by a fault",
};

constexpr bool rows_in_order() {
  for (std::size_t i = 0; i < kStateRows.size(); ++i) {
    if (static_cast<std::size_t>(kStateRows[i].sender) != i) return false;
  }
  return true;
}
static_assert(rows_in_order());

// What a person's command on a line means to a mailbox. A torn block cannot be: a block is appended whole or not at
// all.
struct CommandRow {
  feed::Command given;
  modbus::SenderCommand command;
};
constexpr std::array kCommandRows = {
    CommandRow{feed::Command::stop, modbus::SenderCommand::hold},
    CommandRow{feed::Command::resume, modbus::SenderCommand::release},
    CommandRow{feed::Command::disarm, modbus::SenderCommand::abort},
    CommandRow{feed::Command::cancel, modbus::SenderCommand::abort},
    CommandRow{feed::Command::abort, modbus::SenderCommand::abort},
};

// An armed job that is called back drains nothing: it stays armed until the receiver has closed the session.
LineState line_state(const StateRow& row, std::uint64_t handed) {
  const bool called_back = row.sender == modbus::SenderState::aborting && handed == 0;
  return called_back ? LineState::armed : row.line;
}

class MailboxLine final : public Line {
 public:
  MailboxLine(std::unique_ptr<RegisterBus> bus, const Clock& clock, LineChanged changed)
      : bus_(std::move(bus)),
        clock_(clock),
        changed_(std::move(changed)),
        thread_([this](std::stop_token stop) { loop(stop); }) {}

  ~MailboxLine() override {
    thread_.request_stop();
    wake_.notify_all();
  }

  std::expected<void, std::string> arm(LineOrder order) override {
    const std::lock_guard lock(mutex_);
    if (is_left_open()) {
      return std::unexpected(std::string("the receiver has a session of another job: reset it and confirm that"));
    }
    if (order.rounds != 1) return std::unexpected(std::string("a block transfer sends its program once"));
    const modbus::SenderJob job{.source = order.source.get(),
                                .text_bytes = order.facts.text_bytes(),
                                .session = static_cast<std::uint32_t>(order.session),
                                .reserve = order.reserve,
                                .take_over = reset_confirmed_};
    if (const auto started = sender_.start(job, clock_.now()); !started) {
      return std::unexpected(
          fmt::format("{} (the line is {})", modbus::message(started.error()), modbus::name(sender_.state())));
    }
    reset_confirmed_ = false;
    source_ = std::move(order.source);
    order_job_ = order.job;
    session_ = order.session;
    total_ = job.text_bytes;
    reserve_ = order.reserve;
    expires_at_ = clock_.now() + order.expires_after;
    expired_ = false;
    publish();
    wake();
    return {};
  }

  std::expected<void, std::string> command(feed::Command command) override {
    const std::lock_guard lock(mutex_);
    if (command == feed::Command::confirm_reset) return confirm_reset();
    for (const CommandRow& row : kCommandRows) {
      if (row.given != command) continue;
      const auto done = sender_.command(row.command, clock_.now());
      publish();
      wake();
      if (done) return {};
      return std::unexpected(std::string(modbus::message(done.error())));
    }
    return std::unexpected(std::string("this command has no meaning on a block transfer"));
  }

  void extend_reserve(std::uint64_t job, std::uint64_t wire_offset) override {
    const std::lock_guard lock(mutex_);
    if (job != order_job_) return;
    reserve_ = std::max(reserve_, wire_offset);
    sender_.extend_reserve(wire_offset, clock_.now());
    publish();
    wake();
  }

  [[nodiscard]] LineReport report() const override {
    const std::lock_guard lock(mutex_);
    return report_;
  }

 private:
  // A job found the session of another one open, which a host or a line left that is gone. Nothing says what the
  // machine did of it, so a person must have reset it before a new session takes its place.
  [[nodiscard]] bool is_left_open() const {
    return sender_.state() == modbus::SenderState::stopped &&
           sender_.stop_reason() == modbus::StopReason::session_running && !reset_confirmed_;
  }

  std::expected<void, std::string> confirm_reset() {
    if (modbus::polls(sender_.state())) return std::unexpected(std::string("a job is on the line"));
    reset_confirmed_ = true;
    publish();
    return {};
  }

  void wake() {
    ++wakes_;
    wake_.notify_all();
  }

  void loop(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
      sender_.tick(clock_.now());
      expire();
      const auto request = sender_.next_request(clock_.now());
      while (sender_.next_event()) {
      }  // the report says all that the events changed
      publish();  // before a sleep that may have no end: the job may just have stopped
      if (request) {
        serve(*request, lock);
      } else {
        sleep(stop, lock);
      }
    }
  }

  // The receiver has not taken the session: nothing of the job went out.
  [[nodiscard]] bool is_armed() const {
    return sender_.state() == modbus::SenderState::looking || sender_.state() == modbus::SenderState::opening;
  }

  void expire() {
    if (expired_ || !is_armed() || clock_.now() < expires_at_) return;
    expired_ = true;
    static_cast<void>(sender_.command(modbus::SenderCommand::abort, clock_.now()));  // an armed one takes it always
  }

  // The bus works without the lock. A command given meanwhile composes another message in the sender's registers, so
  // those that are written are a copy.
  void serve(const modbus::Request& request, std::unique_lock<std::mutex>& lock) {
    modbus::StatusImage status{};
    modbus::Mailbox mailbox{};
    std::ranges::copy(request.registers, mailbox.begin());
    const auto registers = std::span<const std::uint16_t>(mailbox).first(request.registers.size());
    lock.unlock();
    const bool writes = request.kind == modbus::Request::Kind::write_mailbox;
    const auto result =
        writes ? bus_->exchange(kMailboxAddress, registers, kStatusAddress, status) : read_status(status);
    lock.lock();
    if (!result) {
      link_error_ = result.error().text;
      sender_.request_failed(clock_.now());
      return;
    }
    link_error_.clear();
    if (!writes) {
      sender_.status_read(status, clock_.now());
    } else if (*result) {
      sender_.exchanged(status, clock_.now());
    } else {
      sender_.written(clock_.now());
    }
  }

  std::expected<bool, BusFailure> read_status(modbus::StatusImage& status) {
    const auto read = bus_->read(kStatusAddress, status);
    if (!read) return std::unexpected(read.error());
    return true;
  }

  void sleep(const std::stop_token& stop, std::unique_lock<std::mutex>& lock) {
    const std::uint64_t before = wakes_;
    const auto woken = [&] { return wakes_ != before; };
    auto deadline = sender_.deadline();
    if (is_armed() && !expired_) deadline = std::min(deadline.value_or(expires_at_), expires_at_);
    if (deadline) {
      wake_.wait_for(lock, stop, std::max(*deadline - clock_.now(), modbus::Time(0)), woken);
    } else {
      wake_.wait(lock, stop, woken);
    }
  }

  void publish() {
    const StateRow& row = kStateRows[static_cast<std::size_t>(sender_.state())];
    // Whether the receiver heard the abort or not: no block of an expired job was handed.
    const JobEnd end = row.end != JobEnd::none && expired_ ? JobEnd::disarmed : row.end;
    const modbus::SenderCounters counters = sender_.counters();
    const LineState state = is_left_open() ? LineState::torn : line_state(row, counters.handed);
    const modbus::SenderStall stall = sender_.stall();
    const std::string_view stall_name = kStallNames[static_cast<std::size_t>(stall)];
    const bool changed = state != report_.state || end != report_.end || stall_name != report_.stall ||
                         order_job_ != report_.job || session_ != report_.session;
    report_.job = order_job_;
    report_.session = session_;
    report_.state = state;
    report_.end = end;
    report_.stall = stall_name;
    report_.cause =
        sender_.stop_reason() == modbus::StopReason::none ? std::string_view() : modbus::name(sender_.stop_reason());
    if (expired_) report_.cause = feed::name(feed::Cause::expired);
    report_.stop_wanted = state == LineState::held;
    report_.link_error = link_error_;
    report_.total = total_;
    report_.handed = counters.handed;
    report_.clocked = counters.clocked;
    report_.confirmed = counters.confirmed;
    report_.confirms = true;
    report_.reserve = reserve_;
    report_.known = {
        .from = counters.confirmed, .to = counters.handed, .from_line = 0, .to_line = 0, .to_text = counters.handed};
    if (!changed) return;
    ++report_.changes;
    changed_();
  }

  std::unique_ptr<RegisterBus> bus_;
  const Clock& clock_;
  LineChanged changed_;
  modbus::Sender sender_{modbus::SenderSettings{}};
  std::shared_ptr<tape_code::TextSource> source_;
  std::uint64_t order_job_ = 0;
  std::uint64_t session_ = 0;
  std::uint64_t total_ = 0;
  std::uint64_t reserve_ = 0;
  std::uint64_t wakes_ = 0;
  modbus::Time expires_at_{};
  bool expired_ = false;
  bool reset_confirmed_ = false;  // for the next session
  std::string link_error_;
  mutable std::mutex mutex_;
  std::condition_variable_any wake_;
  LineReport report_;
  std::jthread thread_;  // last: it uses all of the above
};

}  // namespace

std::unique_ptr<Line> make_mailbox_line(std::unique_ptr<RegisterBus> bus, const Clock& clock, LineChanged changed) {
  return std::make_unique<MailboxLine>(std::move(bus), clock, std::move(changed));
}

}  // namespace dripfeed::app
