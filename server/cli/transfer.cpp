// The ledger is kept ahead of the feed by a loop that looks at the line twenty times a second.
#include "server/cli/transfer.h"

#include <chrono>
#include <memory>
#include <thread>

#include <fmt/format.h>

#include "protocol/receive/transfer.h"
#include "server/app/jobs/ledger_writer.h"
#include "server/app/lines/lines.h"
#include "server/app/receive/read_back.h"
#include "server/cli/claimed_line.h"
#include "server/cli/logging.h"
#include "server/io/io.h"

namespace dripfeed::cli {

namespace {

using Possible = std::expected<void, std::string>;

constexpr std::chrono::milliseconds kRound{50};
constexpr std::uint64_t kJob = 1;
constexpr std::chrono::seconds kToOpen{5};
// A protocol's leave-taking is let out before the link is closed, which drops what is unsent.
constexpr std::chrono::milliseconds kLeaveTaking{200};

bool over(const app::LineReport& report) { return report.job == kJob && report.end != app::JobEnd::none; }

class Following {
 public:
  // `begun`: the line's record says "sending" already, and `reserve` is open.
  Following(app::Line& line, FileLedger& ledger, app::LineClaim& claim, const std::string& name,
            const app::Clock& clock, const Stops& stops, std::uint64_t reserve)
      : line_(line),
        ledger_(ledger),
        claim_(claim),
        name_(name),
        clock_(clock),
        stops_(stops),
        reserve_(reserve),
        begun_(reserve > 0) {}

  app::LineReport to_the_end() {
    for (;;) {
      app::LineReport report = line_.report();
      const bool ended = over(report);
      if (!begun_ && !ended && has_asked(report)) begin(report);
      if (fault_.empty()) book(report, ended);
      last_ = report;
      if (ended) return report;
      stop_if_wanted(report);
      std::this_thread::sleep_for(kRound);
    }
  }
  [[nodiscard]] const std::string& fault() const { return fault_; }

 private:
  // The control wants the first byte, and nothing is reserved yet.
  static bool has_asked(const app::LineReport& report) {
    return report.state != app::LineState::armed || report.stall == app::name_of(feed::Stall::waiting_for_ledger);
  }

  void begin(const app::LineReport& report) {
    last_.stall = report.stall;  // the wait for this record is no news
    if (auto begun = claim_.begin(name_); !begun) {
      fault_ = std::move(begun.error());
    } else {
      begun_ = true;
    }
  }

  // A job that is over hands nothing more: what it had left of its window is given back.
  [[nodiscard]] std::uint64_t reserve_for(const app::LineReport& report, bool ended) const {
    if (ended) return report.handed;
    const std::uint64_t window = app::reserve_window(report);
    return !begun_ || reserve_ >= report.handed + window / 2 ? reserve_ : report.handed + window;
  }

  void book(const app::LineReport& report, bool ended) {
    const std::uint64_t wanted = reserve_for(report, ended);
    if (report.changes == last_.changes && report.handed == last_.handed && report.clocked == last_.clocked &&
        wanted == reserve_ && !ended)
      return;
    const std::string alarm = report.machine ? app::alarm_text(*report.machine) : std::string();
    std::string note = ended ? std::string(report.cause) : std::string(report.stall);
    if (!alarm.empty()) note += note.empty() ? alarm : "; " + alarm;
    if (auto written = ledger_.write(clock_.wall_ms(), report, wanted, note); !written) {
      fault_ = std::move(written.error());
      return;
    }
    if (report.stall != last_.stall && !report.stall.empty()) say(report.stall);
    if (!alarm.empty() && (!last_.machine || last_.machine->alarm != report.machine->alarm)) say(alarm);
    reserve_ = wanted;
    line_.extend_reserve(kJob, reserve_);
  }

  // Without a ledger nothing more may leave, and the end of the block may lie beyond what is reserved.
  void stop_if_wanted(const app::LineReport& report) {
    const bool waits = report.state == app::LineState::armed;
    if (!fault_.empty() && !aborted_) {
      aborted_ = cancelled_ = true;
      command(waits ? feed::Command::disarm : feed::Command::abort, fault_ + ": stopping at once");
    }
    if (stops_.first.stop_requested() && !cancelled_) {
      cancelled_ = true;
      command(waits ? feed::Command::disarm : feed::Command::cancel,
              "stopping at the end of the block; one more signal stops at once");
    }
    if (stops_.second.stop_requested() && !aborted_) {
      aborted_ = true;
      command(feed::Command::abort, "stopping at once");
    }
  }

  void command(feed::Command command, std::string_view sentence) {
    say(sentence);
    if (const auto done = line_.command(command); !done) say(done.error());
  }

  app::Line& line_;
  FileLedger& ledger_;
  app::LineClaim& claim_;
  const std::string& name_;
  const app::Clock& clock_;
  const Stops& stops_;
  std::uint64_t reserve_;
  bool begun_;
  app::LineReport last_;
  bool cancelled_ = false;
  bool aborted_ = false;
  std::string fault_;  // of the ledger, or of the line's record
};

// The operator punches what was loaded; the first program that comes is compared. What comes broken is punched again.
std::string read_back(app::Line& line, const std::string& sent, double minutes, const std::stop_token& stop) {
  say(fmt::format("{}: punch the program at the control", app::kReadBackWaits));
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(minutes * 60.0);
  while (!stop.stop_requested() && std::chrono::steady_clock::now() < until) {
    for (const app::Reception& one : line.take_receptions()) {
      const receive::Transfer transfer = receive::judge(one.raw, one.ending, one.settings);
      if (transfer.fault == receive::Fault::none) return app::read_back_result(sent, transfer.text);
      if (transfer.fault != receive::Fault::empty)
        say(fmt::format("what came is not a program: {}", receive::message(transfer.fault)));
    }
    std::this_thread::sleep_for(kRound);
  }
  return std::string(app::kReadBackExpired);
}

app::Result<void> wait_until_up(app::Line& line, const std::string& link, const Stops& stops) {
  const auto patience = std::chrono::steady_clock::now() + kToOpen;
  while (line.report().state == app::LineState::disconnected && !stops.first.stop_requested()) {
    if (std::chrono::steady_clock::now() > patience)
      return app::fail(app::ErrorCode::unavailable, fmt::format("{}: {}", link, line.report().link_error));
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return {};
}

app::Result<void> arm(app::Line& line, const TransferOrder& order, const app::Clock& clock, std::uint64_t reserve) {
  const auto session = static_cast<std::uint64_t>(clock.wall_ms()) & 0xFFFFFFFFU;
  const auto armed = line.arm({.job = kJob,
                               .facts = order.facts,
                               .source = std::make_shared<tape_code::SpanSource>(order.text, order.rounds),
                               .expires_after = feed::kArmingExpiry,
                               .reserve = reserve,
                               .rounds = order.rounds,
                               .session = session | 1U,
                               .file_name = order.file_name});
  if (armed) return {};
  return app::fail(app::ErrorCode::refused, armed.error());
}

}  // namespace

app::Result<Transferred> transfer(const TransferOrder& order, FileLedger& ledger, app::LineClaim& claim,
                                  const Stops& stops) {
  const auto thread = io::start_link_thread();
  auto line = app::make_line(order.profile.line, *thread, io::take_modbus_seat, [] {});
  if (!line) return std::unexpected(line.error());
  if (const auto up = wait_until_up(**line, order.profile.line.link.text, stops); !up)
    return std::unexpected(up.error());
  // Where the control asks for the first byte itself, nothing is reserved and the record stays clean until it does: who
  // dies while it waits has torn nothing. A folder or a mailbox begins at once.
  const bool waits = machine::feeds_characters(order.profile.line.link.kind);
  const std::uint64_t reserve = waits ? 0 : app::reserve_window((*line)->report());
  const auto first = ledger.write(thread->clock().wall_ms(), {}, reserve, "armed");
  if (!first) return app::fail(app::ErrorCode::unavailable, first.error());
  const auto begun = waits ? Possible() : claim.begin(order.name);
  if (!begun) return app::fail(app::ErrorCode::refused, begun.error());
  if (const auto armed = arm(**line, order, thread->clock(), reserve); !armed) {
    if (const auto ended = claim.end(); !ended) say(ended.error());
    return std::unexpected(armed.error());
  }
  Following following(**line, ledger, claim, order.name, thread->clock(), stops, reserve);
  Transferred done{.report = following.to_the_end(), .read_back = {}, .fault = following.fault()};
  if (const std::string fault = record_end(claim, done.report); !fault.empty())
    done.fault += done.fault.empty() ? fault : "; " + fault;
  done.torn = !claim.torn().empty();
  if (done.report.end != app::JobEnd::done) std::this_thread::sleep_for(kLeaveTaking);
  if (done.report.end != app::JobEnd::done || !order.read_back || !done.fault.empty()) return done;
  done.read_back = read_back(**line, order.text, order.profile.line.receive.read_back_minutes, stops.first);
  const auto noted =
      ledger.write(thread->clock().wall_ms(), done.report, done.report.handed, "read-back " + done.read_back);
  if (!noted) done.fault = noted.error();
  return done;
}

}  // namespace dripfeed::cli
