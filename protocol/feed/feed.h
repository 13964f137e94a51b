// feed: drip-feeding a program over a plain serial line, block by block, under the control's DC1 and DC3. Here live the
// state table, the pacing, the check of a text before it may be fed, and the machine itself. The machine does no I/O:
// it gets what came in and what time it is, and shows what may go out. Not here: ports, clocks, threads, the store,
// what a program means. This header brings all of the folder.
//
// A driver's loop, on one thread, `now` from a steady clock, never stepping back:
//   after every call: while pending_out() is not empty, write it without blocking and mark_sent() what was taken, at
//   once;
//                     drain next_event(); set a timer to deadline() and call tick(now) when it fires.
//   read before you write: receive() everything that came in, then look at pending_out();
//   write nothing that pending_out() does not show at that moment; a span from before another call is stale.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <span>

#include "protocol/feed/event.h"
#include "protocol/feed/line_clock.h"
#include "protocol/feed/line_code.h"
#include "protocol/feed/program_check.h"
#include "protocol/feed/settings.h"
#include "protocol/feed/state.h"
#include "protocol/tape_code/text_source.h"
#include "protocol/tape_code/wire_encoder.h"

namespace dripfeed::feed {

inline constexpr Time kArmingExpiry = std::chrono::minutes(10);
inline constexpr std::uint32_t kMaxRounds = 1'000'000;
inline constexpr std::uint64_t kNoReserve = UINT64_MAX;

struct Job {
  ProgramFacts facts;                       // from ProgramCheck over the same text
  tape_code::TextSource* source = nullptr;  // at the start of the text; must outlive the job
  Time expires_after = kArmingExpiry;       // also of the waiting between two rounds
  // So many times in all, 1 to kMaxRounds; each waits for the control's own start. The source then gives its text that
  // often, and no piece of it spans two rounds.
  std::uint32_t rounds = 1;
  std::uint64_t reserve = 0;  // wire bytes that the ledger reserved already; kNoReserve without a ledger
};

enum class Command : std::uint8_t {
  disarm,            // armed -> disarmed
  stop,              // at the next block end; resume goes on
  resume,            // takes back stop; a control that holds still holds
  cancel,            // at the next block end the job is over; no '%' is sent
  abort,             // now: nothing more goes out; inside a block the line is torn
  resume_as_if_dc1,  // only where DC3 holds: the control is believed to have sent DC1
  confirm_reset,     // only when torn: a person says that the control was reset
};

// How whoever fed this line before left it.
enum class LeftAs : std::uint8_t {
  whole,  // at a block end, or never used
  torn,   // inside a block, as far as the books know
};

enum class LineChange : std::uint8_t { link_up, link_down, cts_on, cts_off, dsr_on, dsr_off };

enum class Refusal : std::uint8_t {
  not_in_this_state,
  link_is_down,     // arm: the link was not reported up
  no_source,        // arm: the job has no source
  rounds,           // arm: none or too many
  reset_suspected,  // resume: the control asked again while the feed was stopped
};
std::string_view message(Refusal refusal);

// One line. Not thread-safe. Never allocates.
class Feed {
 public:
  // Events that wait to be read; beyond it the oldest is dropped and counted.
  static constexpr std::size_t kMaxEvents = 64;

  // A feed begins as its line was left: nothing leaves on one that is torn before a person confirms the reset.
  static std::expected<Feed, SettingsRefusal> make(const Settings& settings, LeftAs left = LeftAs::whole);

  // A person arms one job for this line. Sends nothing before DC1 (or at once, where the profile says so).
  std::expected<void, Refusal> arm(const Job& job, Time now);
  std::expected<void, Refusal> command(Command command, Time now);
  // The ledger committed: wire bytes up to this offset may be handed. Never lowers the reserve.
  void extend_reserve(std::uint64_t wire_offset, Time now);

  void receive(std::span<const std::byte> bytes, Time now);
  // The link begins as down; CTS and DSR begin as on. Report changes, also those below a lost link.
  void line(LineChange change, Time now);
  // Optional: characters still unsent below (TIOCOUTQ, RFC 2217). Only ever slows; a number that stands still is a
  // stall of its own.
  void report_queue(std::uint64_t unsent, Time now);
  // Optional: bytes that the network has not confirmed yet (a socket's SIOCOUTQ). They do not count as clocked,
  // whatever their line time says.
  void report_unconfirmed(std::uint64_t bytes, Time now);
  void tick(Time now);

  // What may be written now, at most kMaxUnsent bytes. Valid until the next call of a non-const member.
  std::span<const std::byte> pending_out() const;
  // The driver took the first n of pending_out(); 0: it takes nothing now.
  void mark_sent(std::size_t n, Time now);

  std::optional<Event> next_event();
  std::uint64_t events_dropped() const { return events_dropped_; }
  // When tick() must be called at the latest; nothing when only an input can move it.
  std::optional<Time> deadline() const;

  State state() const { return state_; }
  Stall stall() const { return stall_; }
  // Why the last job ended, once it did.
  Cause end_cause() const { return end_cause_; }
  // As of the last call with a time.
  Counters counters() const;
  // What the control may have; frozen once the feed is torn, failed, done or cancelled.
  Interval interval() const;
  // The round that is on, from 1.
  std::uint32_t round() const { return round_; }
  // Characters of the job's wire, leader and trailer included, of all rounds; and the time one takes.
  std::uint64_t wire_bytes() const { return wire_bytes_; }
  Time paced_char_time() const { return char_time_; }
  // Share of line time used while not stalled, 0..1, up to the last call with a time.
  double line_use() const;
  const Settings& settings() const { return settings_; }

  // For a test of the transition table: called with the row's index whenever a row is taken. Tables in order:
  // reactions, then progress.
  using RowTaken = void (*)(void* context, std::size_t row);
  void observe_rows(RowTaken taken, void* context) {
    row_taken_ = taken;
    row_context_ = context;
  }

 private:
  explicit Feed(const Settings& settings);

  struct Trigger {
    Cause cause = Cause::none;
    std::uint8_t byte = 0;
  };

  void step_to(Time now);
  void update_progress();
  bool holds(Condition condition) const;
  bool holds(Guard guard) const;
  std::expected<void, Refusal> react(Input input, Trigger trigger);
  void perform(Action action, Trigger trigger, State to);
  void enter(State to, Cause cause);
  void fill();
  void advance();
  void take_job();
  void take_round();
  void end_job(Action action, Cause cause);
  Time drains_at() const;
  Time quiet_at() const;
  Stall present_stall() const;
  void emit(Event event);
  void note_input(Trigger trigger);
  std::optional<tape_code::WirePosition> locate(std::uint64_t offset) const;
  bool in_block() const;
  bool line_is_drained() const;
  bool cts_holds() const { return settings_.watch_cts || cts_is_flow(settings_.flow); }
  bool flow_stopped() const { return (cts_holds() && !cts_on_) || (dsr_is_flow(settings_.flow) && !dsr_on_); }
  bool starts_by_itself() const;
  bool is_shut_after_the_end() const;
  void change_line(LineChange change, bool on);
  bool hears_trigger(Signal signal, std::uint8_t byte);
  void moved_below();
  bool stands_below() const;
  Stall line_stall() const;
  std::uint64_t left_by_now();
  std::uint64_t certain_by_now();
  std::size_t allowed() const;

  Settings settings_;
  Time char_time_;
  LineClock clock_;
  std::optional<tape_code::WireEncoder> encoder_;
  std::optional<Job> job_;
  Time now_{};

  State state_ = State::idle;
  Stall stall_ = Stall::none;
  Cause end_cause_ = Cause::none;
  bool link_up_ = false;
  bool cts_on_ = true;
  bool dsr_on_ = true;
  bool control_holds_ = false;                     // DC3 came after the last DC1
  std::array<std::uint8_t, kMaxTrigger> heard_{};  // the last characters while armed, the newest at the end
  bool triggered_ = false;
  bool after_trigger_ = false;  // an EOB after the start text belongs to it

  std::array<std::byte, kMaxUnsent> out_{};
  std::array<std::uint8_t, kMaxUnsent> out_ends_block_{};
  std::size_t out_begin_ = 0;
  std::size_t out_end_ = 0;
  std::uint32_t credit_ = 0;
  tape_code::FillStatus source_ = tape_code::FillStatus::end;
  bool at_block_end_ = true;
  std::optional<std::uint64_t> network_has_;  // wire bytes that the network confirmed, where it is known
  std::uint64_t last_queue_ = 0;              // reported last
  std::optional<Time> stands_since_;          // nothing moves below since then
  Time rested_{};                             // all line delays so far
  Time flow_off_at_{};                        // when a flow line went off last

  std::uint32_t round_ = 0;
  std::uint64_t round_begin_ = 0;  // wire offset; all offsets count from the first round's
  std::uint64_t round_length_ = 0;
  std::uint64_t wire_bytes_ = 0;
  std::uint64_t program_end_wire_ = 0;
  std::uint64_t reserve_ = 0;
  Time expires_at_{};
  Time last_input_{};
  Time source_retry_at_{};
  Counters counters_;
  Interval end_interval_;

  std::array<Event, kMaxEvents> events_{};
  std::size_t first_event_ = 0;
  std::size_t event_count_ = 0;
  std::uint64_t events_dropped_ = 0;

  RowTaken row_taken_ = nullptr;
  void* row_context_ = nullptr;
};

}  // namespace dripfeed::feed
