// A machine's line as the application sees it, whatever runs below: one job at most, commands of a person, and a
// report. All members may be called from any thread.
#pragma once

#include <cstdint>
#include <expected>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/feed/feed.h"
#include "protocol/modbus/doorbell.h"
#include "protocol/receive/receiver.h"
#include "protocol/tape_code/text_source.h"
#include "server/app/lines/wire_tap.h"
#include "server/app/ports/link.h"

namespace dripfeed::app {

enum class LineState : std::uint8_t {
  disconnected,  // the link is not up; nothing was torn by that
  idle,
  armed,  // waiting for the control's DC1 (or for the PLC)
  feeding,
  held,       // by the control, or stopped at a block end by a person
  draining,   // all is handed, the end is not seen yet
  torn,       // broken off inside a block: a person must confirm that the control was reset
  receiving,  // the control punches
  answering,  // what its operator asked for waits for the control, or goes out
};
std::string_view name_of(LineState state);
// A person stopped the feed, and then the control asked for a program: it may have been reset. Only cancel is left.
inline constexpr std::string_view kResetSuspected = "stopped, and the control asked again: it may have been reset";
// "" for none; "waiting for DC1", "held by DC3", …
std::string_view name_of(feed::Stall stall);

// How the last job ended, once it did.
enum class JobEnd : std::uint8_t { none, done, failed, cancelled, disarmed };

// Wire offsets and lines between which the truth lies. Never a claim that something was executed.
struct KnownInterval {
  std::uint64_t from = 0;
  std::uint64_t to = 0;
  std::uint64_t from_line = 0;  // 0: unknown
  std::uint64_t to_line = 0;
  std::uint64_t to_text = 0;  // characters of the text before `to`
  friend bool operator==(const KnownInterval&, const KnownInterval&) = default;
};

// What a machine says of itself by the words of its PLC.
struct MachineReport {
  std::string_view state;     // "idle", "running", "held", "alarm", …
  std::uint32_t program = 0;  // 0: none, or not known
  std::uint32_t line = 0;     // being executed, from 1; 0: not known
  std::uint32_t alarm = 0;    // the control's own number; 0: none
  friend bool operator==(const MachineReport&, const MachineReport&) = default;
};

// "machine alarm 1010 (program 42, line 17)"; "" where it has none.
std::string alarm_text(const MachineReport& machine);

// Where the last answer to an operator stands. It is no job, but its bytes are booked as a job's are.
enum class AnswerStage : std::uint8_t {
  none,     // no answer since the start
  waiting,  // for the control's start; nothing left
  sending,  // it may leave as far as its booking allows
  whole,    // it ended between two blocks, or nothing left
  torn,     // it broke off inside a block
};
struct AnswerReport {
  std::uint64_t serial = 0;  // 1, 2, 3, … since the start; distinguishes one answer from the next
  AnswerStage stage = AnswerStage::none;
  std::uint64_t total = 0;  // wire bytes
  std::string_view cause;   // why it ended, "" while it is on
  friend bool operator==(const AnswerReport&, const AnswerReport&) = default;
};

struct LineReport {
  std::uint64_t job = 0;      // 0: none since the start
  std::uint64_t session = 0;  // of its order: distinguishes one arming of a job from the next
  LineState state = LineState::disconnected;
  JobEnd end = JobEnd::none;
  std::string_view stall;    // "" or a name: "waiting for DC1", "held by DC3", "CTS off", "peer gone", …
  bool stop_wanted = false;  // a person's stop is in force, reached or waiting for the block end
  std::string_view cause;    // why the job ended, "" while it runs
  std::string link_error;    // why the link is down
  std::string link_note;     // of a link that is up: what its device server did not confirm
  LineErrors line_errors;    // that the UART counted since the link is up
  std::uint64_t total = 0;   // wire bytes of the job
  std::uint64_t handed = 0;
  std::uint64_t clocked = 0;
  std::uint64_t confirmed = 0;
  bool confirms = false;      // the protocol acknowledges; otherwise `confirmed` stays 0
  bool estimated = false;     // blind link: the budget is kept by estimate
  std::uint64_t reserve = 0;  // the feed hands nothing beyond it
  KnownInterval known;
  std::uint64_t holds = 0;
  double hold_s = 0.0;
  double line_s = 0.0;                // that its characters took on the line; 0 where that is not known
  double line_use = 0.0;              // share of line time used while not held, 0..1
  double char_s = 0.0;                // time of one character on the line; 0 where there is none
  std::uint64_t unarmed_starts = 0;   // DC1 that came with nothing armed: nothing was sent
  std::uint64_t received = 0;         // receptions that ended since the start
  std::uint64_t receptions_lost = 0;  // ... and that were not taken in time
  AnswerReport answer;
  std::optional<MachineReport> machine;  // nothing where the link brings no such words
  std::uint64_t changes = 0;             // grows with every change of state, stall, end, machine's state or alarm
  friend bool operator==(const LineReport&, const LineReport&) = default;
};

struct LineOrder {
  std::uint64_t job = 0;
  feed::ProgramFacts facts;                       // from feed::ProgramCheck over the same text
  std::shared_ptr<tape_code::TextSource> source;  // at the start of the text
  feed::Time expires_after = feed::kArmingExpiry;
  std::uint64_t reserve = 0;  // already committed in the ledger
  std::uint32_t rounds = 1;   // the text is sent so often, and the source gives it so often
  std::uint64_t session = 0;  // new for each arming; 32 bits of it identify a block transfer at the PLC
  std::string file_name{};    // the name under which the control fetches it from a folder, or that YMODEM states
};

// What a control punched, as it came.
struct Reception {
  std::vector<std::byte> raw;
  receive::Ending ending;
  receive::Settings settings;
};

// A short program that answers an operator: no job, nothing released. Nothing of it leaves before it is booked.
struct Answer {
  feed::ProgramFacts facts;
  std::shared_ptr<tape_code::TextSource> source;
  feed::Time expires_after = feed::kArmingExpiry;
};

// What the link itself reports, into the report. Cheap while nothing changes.
void report_link(const Link& link, LineReport& report);

class Line {
 public:
  Line() = default;
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;
  virtual ~Line() = default;
  // Or one sentence that says why not: busy, torn, link down.
  virtual std::expected<void, std::string> arm(LineOrder order) = 0;
  virtual std::expected<void, std::string> command(feed::Command command) = 0;
  // The ledger committed a window up to this wire offset.
  virtual void extend_reserve(std::uint64_t job, std::uint64_t wire_offset) = 0;
  // The books have this answer: all of it may leave.
  virtual void answer_booked(std::uint64_t /*serial*/) {}
  [[nodiscard]] virtual LineReport report() const = 0;
  // What passes on it, for who looks; none where the line carries no characters.
  [[nodiscard]] virtual std::shared_ptr<WireTap> tap() const { return nullptr; }
  // Receptions that ended since the last call, oldest first. A line that cannot receive has none.
  virtual std::vector<Reception> take_receptions() { return {}; }
  // A ring of the machine's doorbell, reported once, and its answer. A line without a doorbell has none.
  virtual std::optional<modbus::Ring> take_ring() { return std::nullopt; }
  virtual void answer_ring(const modbus::BellAnswer& /*answer*/) {}
  // Arms an answer; it takes the place of one that waits. Or one sentence that says why not.
  // NOLINTNEXTLINE(performance-unnecessary-value-param): the lines that answer keep it
  virtual std::expected<void, std::string> answer(Answer /*answer*/) {
    return std::unexpected("this line gives no answers");
  }
};

// Called after each change of LineReport::changes, on the line's own thread: it must only wake a thread.
using LineChanged = std::function<void()>;

}  // namespace dripfeed::app
