// The sending side of the block mailbox. One block is outstanding; whether it was appended is decided from the status
// image alone, never from the answer to the write. After a restart of either side the session is continued only where
// the status proves that the receiver holds exactly the first bytes of this text.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <span>

#include "protocol/modbus/mailbox.h"
#include "protocol/modbus/sender_state.h"
#include "protocol/tape_code/text_source.h"

namespace dripfeed::modbus {

using Time = std::chrono::nanoseconds;  // as feed's: since an epoch of the driver's choice, never stepping back

struct SenderSettings {
  Time poll = std::chrono::milliseconds(20);             // between two readings of the status
  Time rewrite_after = std::chrono::milliseconds(1000);  // a block that is not seen appended is written again
  Time gone_after = std::chrono::seconds(10);            // no status for so long: stopped, a person must decide
  std::uint32_t max_payload = kMaxPayload;               // 1 .. kMaxPayload
};

struct SenderJob {
  tape_code::TextSource* source = nullptr;  // at the start of the text, also when a session is resumed
  std::uint64_t text_bytes = 0;             // below 4 GiB
  std::uint32_t session = 0;                // random, not 0, new for every job
  std::uint64_t reserve = 0;                // text bytes that the ledger reserved already; UINT64_MAX without a ledger
  bool take_over = false;  // start: a person says that the receiver was reset, so a session still on there may go
};

enum class SenderRefusal : std::uint8_t { not_in_this_state, no_source, no_session, text_too_long, no_text };
std::string_view message(SenderRefusal refusal);

struct SenderEvent {
  SenderEventKind kind = SenderEventKind::state_changed;
  Time at{};
  SenderState from = SenderState::idle;
  SenderState to = SenderState::idle;
  StopReason reason = StopReason::none;
  SenderStall stall = SenderStall::none;
  Nak nak = Nak::none;
  std::uint16_t boot_counter = 0;  // opened: to be journaled with the session
  std::uint16_t seq = 0;
  std::uint64_t confirmed = 0;
};

// Text bytes. handed: written to the mailbox at least once; confirmed: read back as appended; consumed: taken by the
// interpreter, by its own word. Line time has no meaning here, so clocked is confirmed.
struct SenderCounters {
  std::uint64_t handed = 0;
  std::uint64_t clocked = 0;
  std::uint64_t confirmed = 0;
  std::uint64_t consumed = 0;
  std::uint64_t rewrites = 0;
  std::uint64_t failed_requests = 0;
};

// What the driver must do next: read the status image, or write these registers from the start of the mailbox.
struct Request {
  enum class Kind : std::uint8_t { read_status, write_mailbox };
  Kind kind = Kind::read_status;
  std::span<const std::uint16_t> registers{};  // write only; stays valid until the request is answered
};

// A driver's loop: take next_request(); do it; answer with exactly one of written(), status_read() or request_failed()
// (time-out, exception, lost connection: all the same; after one the connection must be made again, so that no late
// answer is taken for another). Nothing else is asked until then. Set a timer to deadline() and call tick().
class Sender {
 public:
  static constexpr std::size_t kMaxEvents = 64;  // beyond it the oldest is dropped and counted

  explicit Sender(const SenderSettings& settings);

  // A new session: opens the mailbox, whatever session it held before, unless that one is still running.
  std::expected<void, SenderRefusal> start(const SenderJob& job, Time now);
  // After a restart of the host: goes on after the last block appended, if the receiver still has this session and the
  // same boot counter (both from the journal); else stops and names why.
  std::expected<void, SenderRefusal> resume(const SenderJob& job, std::uint16_t boot_counter, Time now);
  // hold: at a block end of the text; release: goes on; abort: ends the session; proceed: a person decides that a
  // stopped session goes on, the receiver's present boot counter being accepted.
  std::expected<void, SenderRefusal> command(SenderCommand command, Time now);
  void extend_reserve(std::uint64_t text_offset, Time now);

  std::optional<Request> next_request(Time now);
  void written(Time now);
  void status_read(std::span<const std::uint16_t> registers, Time now);
  // The write was answered together with the status as it stood after it (one FC23): written() and status_read() in
  // one.
  void exchanged(std::span<const std::uint16_t> registers, Time now);
  void request_failed(Time now);
  void tick(Time now);
  std::optional<Time> deadline() const;
  std::optional<SenderEvent> next_event();
  std::uint64_t events_dropped() const { return events_dropped_; }

  SenderState state() const { return state_; }
  SenderStall stall() const { return stall_; }
  StopReason stop_reason() const { return reason_; }
  Nak stop_nak() const { return nak_; }
  SenderCounters counters() const { return counters_; }
  // Does what is confirmed end with a whole block of the text?
  bool at_block_end() const { return at_block_end_; }

  // For a test of the transition table: called with (state, input) of every cell taken.
  using CellTaken = void (*)(void* context, SenderState state, SenderInput input);
  void observe_cells(CellTaken taken, void* context) {
    cell_taken_ = taken;
    cell_context_ = context;
  }

 private:
  // The receiver's account of the text at some block.
  struct Account {
    std::uint16_t seq = 0;
    std::uint32_t appended = 0;
    std::uint32_t text_crc = 0;
  };
  enum class Skip : std::uint8_t { done, pending, lost, differs };

  std::expected<void, SenderRefusal> begin(const SenderJob& job, SenderInput input, Time now);
  std::expected<void, SenderRefusal> react(SenderInput input);
  void perform(SenderAction action);
  void enter(SenderState to);
  void update(Time now);
  void look_for_work();
  void read_again();
  void write_again();
  void confirm();
  void accept_session();
  void compose(MailboxCommand command);

  // Reading the status.
  SenderInput judge(const Status& status);
  SenderInput judge_vacancy(const Status& status);
  SenderInput judge_session(const Status& status);
  SenderInput judge_opening(const Status& status);
  SenderInput judge_message(const Status& status);
  SenderInput judge_block(const Status& status);
  SenderInput contradict(StopReason reason);
  std::optional<StopReason> session_trouble(const Status& status) const;
  bool shows(const Status& status, const Account& account) const;
  StopReason mismatch(const Status& status) const;

  // The text.
  Skip skip_confirmed(const Status& status);
  tape_code::SourceStatus next_piece();
  void gather();
  void drop_payload(std::size_t count);

  void refresh_stall();
  SenderStall present_stall() const;
  void emit(SenderEvent event);

  SenderSettings settings_;
  SenderJob job_;
  SenderState state_ = SenderState::idle;
  SenderStall stall_ = SenderStall::none;
  StopReason reason_ = StopReason::none;
  Nak nak_ = Nak::none;
  SenderCounters counters_;
  Time now_{};

  // The message in the mailbox and the request that is not answered yet.
  Mailbox mailbox_{};
  std::size_t mailbox_used_ = 0;
  std::uint64_t mailbox_text_end_ = 0;  // text bytes up to the end of its payload
  bool must_write_ = false;
  bool write_uncertain_ = false;  // the last write was not answered
  bool in_flight_ = false;
  bool flight_is_stale_ = false;  // it was made for an earlier job
  Request::Kind flight_kind_ = Request::Kind::read_status;
  bool peer_silent_ = false;
  Time next_poll_{};
  Time write_at_{};  // the message is to be written, not before then
  Time composed_at_{};
  Time written_at_{};
  Time answered_at_{};

  // The session. before_ and after_: the receiver's account before and after the outstanding message.
  Account before_;
  Account after_;
  Status last_;
  std::optional<std::uint16_t> boot_;
  std::uint32_t session_before_ = 0;
  bool opened_ = false;
  bool take_over_ = false;
  bool hold_wanted_ = false;
  bool at_block_end_ = true;

  // Text taken from the source: the confirmed part, then payload_, then the rest of the piece.
  std::span<const char> piece_;
  std::size_t piece_used_ = 0;
  std::uint64_t taken_ = 0;
  std::array<std::byte, kMaxPayload> payload_{};
  std::size_t payload_size_ = 0;
  std::size_t payload_cut_ = 0;  // so much of it is the next block
  bool text_not_ready_ = false;
  bool text_lost_ = false;

  std::array<SenderEvent, kMaxEvents> events_{};
  std::size_t first_event_ = 0;
  std::size_t event_count_ = 0;
  std::uint64_t events_dropped_ = 0;

  CellTaken cell_taken_ = nullptr;
  void* cell_context_ = nullptr;
};

}  // namespace dripfeed::modbus
