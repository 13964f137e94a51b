// A turn does what the sender asks for, one request at a time, and says when the next one is wanted. Commands take the
// lock between two requests, never during one.
#include "server/app/lines/modbus_line.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <utility>

#include <fmt/format.h>

#include "protocol/modbus/modbus.h"
#include "server/app/lines/machine_watch.h"
#include "server/app/ports/line_mutex.h"

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

// Whether watchers want to know at once; the line that is executed goes with the progress.
bool differs(const std::optional<MachineReport>& one, const std::optional<MachineReport>& other) {
  if (!one || !other) return one.has_value() != other.has_value();
  return one->state != other->state || one->alarm != other->alarm;
}

class ModbusLine final : public Line, private BusUser {
 public:
  ModbusLine(const ModbusLineSettings& settings, const Clock& clock, LineChanged changed)
      : clock_(clock),
        changed_(std::move(changed)),
        idle_poll_(settings.idle_poll),
        watch_(settings.idle_poll),
        left_torn_(settings.left == feed::LeftAs::torn) {
    publish();
  }

  // The turns begin; or why there are none.
  std::expected<void, std::string> sit(const machine::LinkUrl& link, BusSeatMaker take_seat) {
    auto seat = take_seat(link, *this);
    if (!seat) return std::unexpected(seat.error());
    const std::lock_guard lock(mutex_);
    seat_ = std::move(*seat);
    return {};
  }

  std::expected<void, std::string> arm(LineOrder order) override {
    const std::lock_guard lock(mutex_);
    if (left_torn_) return std::unexpected(std::string("a block may be torn: reset the control and confirm that"));
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

  std::optional<modbus::Ring> take_ring() override {
    const std::lock_guard lock(mutex_);
    return watch_.bell().take_ring();
  }

  void answer_ring(const modbus::BellAnswer& answer) override {
    const std::lock_guard lock(mutex_);
    watch_.bell().answer(answer);
    wake();
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
    left_torn_ = false;
    publish();
    return {};
  }

  void wake() {
    if (seat_) seat_->wake();
  }

  std::optional<std::chrono::nanoseconds> turn(RegisterBus& bus) override {
    std::unique_lock lock(mutex_);
    sender_.tick(clock_.now());
    expire();
    const bool rings = watch_.bell().want() != modbus::Doorbell::Want::nothing && clock_.now() >= bell_at_;
    const auto request = rings ? std::nullopt : sender_.next_request(clock_.now());
    publish_events();  // before a request that may take long: the job may just have stopped
    if (rings) {
      serve_bell(bus, lock);
    } else if (request) {
      serve(*request, bus, lock);
    } else if (!modbus::polls(sender_.state()) && clock_.now() >= watch_.next_look()) {
      look(bus, lock);
    } else {
      return wait();
    }
    publish_events();
    return wait();
  }

  void publish_events() {
    while (sender_.next_event()) {
    }  // the report says all that the events changed
    publish();
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
  void serve(const modbus::Request& request, RegisterBus& bus, std::unique_lock<LineMutex>& lock) {
    std::array<std::uint16_t, modbus::kStatusAndMachine> image{};
    modbus::Mailbox mailbox{};
    std::ranges::copy(request.registers, mailbox.begin());
    const auto registers = std::span<const std::uint16_t>(mailbox).first(request.registers.size());
    const bool writes = request.kind == modbus::Request::Kind::write_mailbox;
    const auto into = std::span(image).first(writes ? watch_.registers_with_write() : watch_.registers());
    lock.unlock();
    const auto result =
        writes ? bus.exchange(kMailboxAddress, registers, kStatusAddress, into) : read_status(bus, into);
    lock.lock();
    if (!note(result, into)) {
      sender_.request_failed(clock_.now());
    } else if (!writes) {
      sender_.status_read(into.first(modbus::kStatusRegisters), clock_.now());
    } else if (*result) {
      sender_.exchanged(into.first(modbus::kStatusRegisters), clock_.now());
    } else {
      sender_.written(clock_.now());
    }
  }

  // No job makes requests: the machine is looked at all the same.
  void look(RegisterBus& bus, std::unique_lock<LineMutex>& lock) {
    std::array<std::uint16_t, modbus::kStatusAndMachine> image{};
    const auto into = std::span(image).first(watch_.registers());
    lock.unlock();
    const auto result = read_status(bus, into);
    lock.lock();
    static_cast<void>(note(result, into));
  }

  // What a request says of the link and the machine; whether it was answered.
  bool note(const std::expected<bool, BusFailure>& result, std::span<const std::uint16_t> image) {
    if (!result) {
      link_error_ = result.error().text;
      watch_.read_failed(!result.error().link_lost, clock_.now());
      return false;
    }
    link_error_.clear();
    if (*result) watch_.read(image, clock_.now());
    return true;
  }

  static std::expected<bool, BusFailure> read_status(RegisterBus& bus, std::span<std::uint16_t> into) {
    const auto read = bus.read(kStatusAddress, into);
    if (!read) return std::unexpected(read.error());
    return true;
  }

  // The answer's registers have nothing to do with the mailbox: a block that is outstanding stays so.
  void serve_bell(RegisterBus& bus, std::unique_lock<LineMutex>& lock) {
    const bool reads = watch_.bell().want() == modbus::Doorbell::Want::read_answer;
    modbus::AnswerImage image = watch_.bell().image();
    lock.unlock();
    const auto done = reads ? bus.read(kAnswerAddress, image) : bus.write(kAnswerAddress, image);
    lock.lock();
    bell_at_ = done ? clock_.now() : clock_.now() + idle_poll_;
    if (!done) link_error_ = done.error().text;
    if (reads && (done || !done.error().link_lost)) {
      watch_.bell().answer_read(done ? std::span<const std::uint16_t>(image) : std::span<const std::uint16_t>());
    } else if (!reads && done) {
      watch_.bell().answer_written();
      note_missed(image);
    }
  }

  // A ring that was answered "missed" is reported to no other person; it stays in sight until another one is answered.
  void note_missed(const modbus::AnswerImage& answer) {
    const bool missed = answer[2] == static_cast<std::uint16_t>(modbus::BellReason::missed);
    report_.link_note =
        missed ? fmt::format("doorbell {} was missed: the server did not see it come", answer[0]) : std::string();
  }

  // Until the next turn is wanted.
  [[nodiscard]] std::chrono::nanoseconds wait() {
    modbus::Time until =
        modbus::polls(sender_.state()) ? sender_.deadline().value_or(modbus::Time::max()) : watch_.next_look();
    if (is_armed() && !expired_) until = std::min(until, expires_at_);
    if (watch_.bell().want() != modbus::Doorbell::Want::nothing) until = std::min(until, bell_at_);
    return std::max(until - clock_.now(), modbus::Time(0));
  }

  // What holds the transfer up. Where it waits for the receiver, or does not wait at all, the machine's own word is the
  // better one.
  [[nodiscard]] std::string_view stall_name() const {
    const modbus::SenderStall stall = sender_.stall();
    const bool on = modbus::polls(sender_.state()) && !is_armed() && sender_.state() != modbus::SenderState::aborting;
    const bool machines = stall == modbus::SenderStall::none || stall == modbus::SenderStall::waiting_for_credit ||
                          stall == modbus::SenderStall::waiting_for_receiver;
    if (on && machines && !watch_.stall().empty()) return watch_.stall();
    return kStallNames[static_cast<std::size_t>(stall)];
  }

  void publish() {
    const StateRow& row = kStateRows[static_cast<std::size_t>(sender_.state())];
    // Whether the receiver heard the abort or not: no block of an expired job was handed.
    const JobEnd end = row.end != JobEnd::none && expired_ ? JobEnd::disarmed : row.end;
    const modbus::SenderCounters counters = sender_.counters();
    LineState state = left_torn_ || is_left_open() ? LineState::torn : line_state(row, counters.handed);
    if (state == LineState::idle && watch_.is_away()) state = LineState::disconnected;
    const bool rings = watch_.bell().state() == modbus::BellState::rung;
    const std::string_view stall = stall_name();
    const bool changed = state != report_.state || end != report_.end || stall != report_.stall ||
                         order_job_ != report_.job || session_ != report_.session ||
                         differs(report_.machine, watch_.report()) || (rings && !rings_);
    rings_ = rings;
    report_.job = order_job_;
    report_.session = session_;
    report_.state = state;
    report_.end = end;
    report_.stall = stall;
    report_.cause =
        sender_.stop_reason() == modbus::StopReason::none ? std::string_view() : modbus::name(sender_.stop_reason());
    if (expired_) report_.cause = feed::name(feed::Cause::expired);
    report_.stop_wanted = state == LineState::held;
    report_.link_error = link_error_;
    report_.machine = watch_.report();
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

  const Clock& clock_;
  LineChanged changed_;
  std::chrono::nanoseconds idle_poll_;
  MachineWatch watch_;
  bool left_torn_;          // by whoever had the line before
  bool rings_ = false;      // a person was informed that a ring waits
  modbus::Time bell_at_{};  // the answer's registers are not asked for before
  modbus::Sender sender_{modbus::SenderSettings{}};
  std::shared_ptr<tape_code::TextSource> source_;
  std::uint64_t order_job_ = 0;
  std::uint64_t session_ = 0;
  std::uint64_t total_ = 0;
  std::uint64_t reserve_ = 0;
  modbus::Time expires_at_{};
  bool expired_ = false;
  bool reset_confirmed_ = false;  // for the next session
  std::string link_error_;
  mutable LineMutex mutex_{"a mailbox"};
  LineReport report_;
  std::unique_ptr<BusSeat> seat_;  // last: its turns use all of the above
};

}  // namespace

std::expected<std::unique_ptr<Line>, std::string> make_modbus_line(const ModbusLineSettings& settings,
                                                                   BusSeatMaker take_seat, const Clock& clock,
                                                                   LineChanged changed) {
  auto line = std::make_unique<ModbusLine>(settings, clock, std::move(changed));
  if (auto seated = line->sit(settings.link, take_seat); !seated) return std::unexpected(seated.error());
  return line;
}

}  // namespace dripfeed::app
