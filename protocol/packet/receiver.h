// One line's packet receiver, for every protocol: takes frames, gives their text to a sink once each and in order,
// delays its acknowledgement while the sink has no room, names every end. Does no I/O; driven as protocol/feed says at
// its top. Not thread-safe; allocates only when it is made.
#pragma once

#include <array>
#include <expected>
#include <memory>
#include <optional>
#include <span>

#include "protocol/feed/feed.h"
#include "protocol/packet/receive_rules.h"

namespace dripfeed::packet {

// Where the text goes. XMODEM fills its last block with SUB (1A) after the text; a program's final '%' shows where
// that begins, so the sink gets it as it came.
class Sink {
 public:
  virtual ~Sink() = default;
  // Bytes that it takes now. A frame is asked for, and the last one acknowledged, while this is as much as a frame of
  // the protocol has; a sender that sends longer ones unasked (1024 bytes of XMODEM for 128) is not refused.
  virtual std::size_t room() const noexcept = 0;
  virtual void append(std::span<const std::byte> bytes) noexcept = 0;
};

struct ReceiveEvent {
  ReceiveEventKind kind = ReceiveEventKind::state_changed;
  Time at{};
  ReceiveState from = ReceiveState::idle;
  ReceiveState to = ReceiveState::idle;
  Cause cause = Cause::none;
  std::uint32_t count = 0;
};

struct ReceiveCounters {
  std::uint64_t bytes = 0;  // appended
  std::uint64_t frames = 0;
  std::uint64_t repeated = 0;
  std::uint64_t bad = 0;
};

class Receiver {
 public:
  static constexpr std::size_t kMaxEvents = 64;
  static constexpr std::size_t kMaxAnswer = 96;

  // The sink must outlive the receiver.
  static std::expected<Receiver, SettingsFault> make(const Settings& settings, Sink& sink);

  std::expected<void, feed::Refusal> start(Time now);
  std::expected<void, feed::Refusal> stop(Time now);
  // 3964 has no end of a text: who reads it says, between two blocks, that it is whole.
  std::expected<void, feed::Refusal> conclude(Time now);
  void link(bool up, Time now);
  void receive(std::span<const std::byte> bytes, Time now);
  // Also after the sink got room.
  void tick(Time now);

  std::span<const std::byte> pending_out() const { return std::span(out_).subspan(out_begin_, out_end_ - out_begin_); }
  void mark_sent(std::size_t n, Time now);

  std::optional<ReceiveEvent> next_event();
  std::optional<Time> deadline() const;
  ReceiveState state() const { return state_; }
  Cause end_cause() const { return end_cause_; }
  ReceiveCounters counters() const { return counters_; }

  using CellTaken = void (*)(void* context, ReceiveState state, ReceiveInput input);
  void observe_cells(CellTaken taken, void* context) {
    cell_taken_ = taken;
    cell_context_ = context;
  }

 private:
  Receiver(const Settings& settings, Sink& sink);

  void step_to(Time now);
  std::expected<void, feed::Refusal> react(ReceiveInput input, Cause cause = Cause::none);
  void perform(ReceiveAction action, Cause cause);
  void update();
  void listen();
  void emit(ReceiveEvent event);
  void answer(std::size_t size);
  bool has_room() const { return sink_->room() >= rules_->usual_payload(); }

  std::unique_ptr<ReceiveRules> rules_;
  Sink* sink_;
  Time now_{};
  ReceiveState state_ = ReceiveState::idle;
  Cause end_cause_ = Cause::none;
  Time quiet_since_{};
  Time purge_until_{};
  std::uint32_t silences_ = 0;  // in a row
  bool uninvited_ = false;      // the first invitation waits for room
  std::array<std::byte, kMaxAnswer> out_{};
  std::size_t out_begin_ = 0;
  std::size_t out_end_ = 0;
  ReceiveCounters counters_;

  std::array<ReceiveEvent, kMaxEvents> events_{};
  std::size_t first_event_ = 0;
  std::size_t event_count_ = 0;

  CellTaken cell_taken_ = nullptr;
  void* cell_context_ = nullptr;
};

}  // namespace dripfeed::packet
