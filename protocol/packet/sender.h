// One line's packet sender, for every protocol: arms a job, sends its text in frames, keeps what is known of them,
// names every stall and every end. Does no I/O; driven as protocol/feed says at its top. Not thread-safe; allocates
// only when it is made.
#pragma once

#include <array>
#include <expected>
#include <memory>
#include <optional>
#include <span>

#include "protocol/feed/feed.h"
#include "protocol/feed/line_clock.h"
#include "protocol/packet/event.h"
#include "protocol/packet/outbox.h"
#include "protocol/packet/send_rules.h"
#include "protocol/packet/settings.h"
#include "protocol/packet/state.h"

namespace dripfeed::packet {

class Sender {
 public:
  static constexpr std::size_t kMaxEvents = 64;
  // Characters that may lie unsent below: a frame is handed as the line takes it, so that an answer can only come
  // after its last character, and an abort stops what is left of it.
  static constexpr std::uint32_t kUnsent = 64;
  // An answer that takes longer is a stall, and shown.
  static constexpr Time kShownAfter = std::chrono::seconds(1);

  // As its line was left: nothing leaves on one that is torn before a person confirms the reset.
  static std::expected<Sender, SettingsFault> make(const Settings& settings, feed::LeftAs left = feed::LeftAs::whole);

  // A person arms one job. Nothing of the text goes out before the receiver asks (3964: at once). `name` is for
  // protocols that state it.
  std::expected<void, feed::Refusal> arm(const feed::Job& job, Time now, std::string_view name = {});
  std::expected<void, feed::Refusal> command(feed::Command command, Time now);
  // The ledger committed: text up to this offset may be handed. Never lowers the reserve.
  void extend_reserve(std::uint64_t offset, Time now);

  void receive(std::span<const std::byte> bytes, Time now);
  // The link begins as down.
  void link(bool up, Time now);
  void tick(Time now);

  std::span<const std::byte> pending_out() const;
  void mark_sent(std::size_t n, Time now);

  std::optional<Event> next_event();
  // What the partner sent when both had called, as it came; empty when there is none. Until it is taken the partner's
  // next call is refused, so that none is lost.
  std::span<const std::byte> telegram() const { return rules_->telegram(); }
  void take_telegram() { rules_->take_telegram(); }
  std::uint64_t events_dropped() const { return events_dropped_; }
  std::optional<Time> deadline() const;

  State state() const { return state_; }
  Stall stall() const { return stall_; }
  Cause end_cause() const { return end_cause_; }
  bool stop_wanted() const { return stop_wanted_ && is_on_the_line(state_); }
  // As of the last call with a time.
  Counters counters() const { return counters_; }
  // What the control may have; frozen once the job is over.
  feed::Interval interval() const;
  std::uint64_t total_bytes() const { return total_; }
  const Settings& settings() const { return settings_; }

  // For a test of the transition table.
  using CellTaken = void (*)(void* context, State state, Input input);
  void observe_cells(CellTaken taken, void* context) {
    cell_taken_ = taken;
    cell_context_ = context;
  }

 private:
  explicit Sender(const Settings& settings);

  void step_to(Time now);
  std::expected<void, feed::Refusal> react(Input input, Cause cause = Cause::none);
  void perform(Action action, Input input, Cause cause);
  void enter(State to, Cause cause);
  void heard(Heard heard, std::uint8_t byte);
  void hear_telegram();
  void update();
  bool advance();
  bool advance_ready();
  void call();
  void put_frame();
  void put_small(std::size_t size, bool awaited);
  void await_answer();
  void end_job(Action action, Cause cause);
  bool in_block() const;
  bool may_repeat();
  Stall present_stall() const;
  std::optional<Time> late_at() const;
  void emit(Event event);

  Settings settings_;
  std::unique_ptr<SendRules> rules_;
  feed::LineClock clock_;
  Outbox outbox_;
  std::optional<feed::Job> job_;
  std::string_view arming_name_;  // of the call of arm() that is on
  Time now_{};

  State state_ = State::idle;
  Stall stall_ = Stall::none;
  Cause end_cause_ = Cause::none;
  bool link_up_ = false;
  bool stop_wanted_ = false;
  bool cancel_wanted_ = false;
  bool asked_ = false;  // the receiver waits for the next frame (pulled protocols)

  // The present or last frame, kept for a receiver that asks for it again; and whatever else goes out.
  std::array<std::byte, kMaxFrame> frame_{};
  std::size_t frame_size_ = 0;
  std::array<std::byte, kMaxSmall> small_{};
  bool out_is_frame_ = false;
  std::size_t out_begin_ = 0;
  std::size_t out_end_ = 0;
  bool out_awaited_ = false;  // a frame, a call or an end: its last byte starts the wait
  std::uint32_t credit_ = 0;

  std::optional<Time> waits_since_{};  // the last byte of what is to be answered is out
  std::uint32_t attempts_ = 0;
  std::uint32_t calls_ = 0;
  std::uint64_t total_ = 0;
  std::uint64_t reserve_ = 0;
  Time expires_at_{};
  Time source_retry_at_{};
  bool text_missing_ = false;
  bool ledger_missing_ = false;
  Counters counters_;
  feed::Interval end_interval_;

  std::array<Event, kMaxEvents> events_{};
  std::size_t first_event_ = 0;
  std::size_t event_count_ = 0;
  std::uint64_t events_dropped_ = 0;

  CellTaken cell_taken_ = nullptr;
  void* cell_context_ = nullptr;
};

}  // namespace dripfeed::packet
