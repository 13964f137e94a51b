// What one packet protocol adds to the sender: the form of its frames, what a byte from the receiver means, its times.
// The rules keep what only they need (a block number, half of a message) and never change the sender's state.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "protocol/packet/event.h"
#include "protocol/packet/settings.h"
#include "protocol/packet/state.h"

namespace dripfeed::packet {

enum class Signal : std::uint8_t {
  none,   // part of something longer, or without effect
  noise,  // means nothing here
  asked,
  granted,
  accepted,
  again,
  later,     // the wait begins again: the receiver is not ready, or what is awaited has come in part
  yielded,   // both called, and this side yields
  telegram,  // the partner's is whole
  broken,    // with a cause
};

struct Heard {
  Signal signal = Signal::none;
  Cause cause = Cause::none;
  bool counts = true;  // `again` is one of the attempts that patience() limits
};

// Limit of what goes out between frames.
inline constexpr std::size_t kMaxSmall = 136;

// What a protocol with headers states of the text. The name may be anything, also none.
struct Announcement {
  std::string_view name{};
  std::uint64_t bytes = 0;  // as coded
};

// How long the sender waits in a state, and how often it repeats there.
struct Patience {
  std::optional<Time> limit{};  // none: without limit
  std::uint32_t attempts = 1;   // the first included
};

class SendRules {
 public:
  SendRules() = default;
  SendRules(const SendRules&) = delete;
  SendRules& operator=(const SendRules&) = delete;
  virtual ~SendRules() = default;

  // The link came up, or a job begins.
  virtual void link_up() {}
  virtual void begin(const Announcement& announcement) = 0;
  virtual Heard hear(std::uint8_t byte, State state) = 0;
  // The patience of the state is over.
  virtual Heard late(State state) = 0;
  virtual Patience patience(State state) const = 0;

  // Bytes of the next frame; 0: not enough text yet. `complete`: nothing follows what is available.
  virtual std::size_t frame_size(std::size_t available, bool complete) const = 0;
  // Each of these writes into `out` (kMaxSmall, compose() kMaxFrame) and says how much; 0: the protocol has no such
  // thing.
  virtual std::size_t call(std::span<std::byte>) { return 0; }
  virtual std::size_t compose(std::span<const std::byte> payload, std::span<std::byte> out) = 0;
  virtual std::size_t close(std::span<std::byte>) { return 0; }
  // Called when a job is over between two blocks and the receiver still waits.
  virtual std::size_t part(std::span<std::byte>) { return 0; }
  // What the receiver was just promised an answer to, apart from frames.
  virtual std::size_t reply(std::span<std::byte>) { return 0; }
  // Called when a person aborts inside a block of the program, between two frames: that what came is no whole text.
  virtual std::size_t abort(std::span<std::byte>) { return 0; }
  // The last byte of a call, a frame or an end is sent: an answer may come.
  virtual void sent() {}
  // The receiver has the present frame.
  virtual void accepted() = 0;

  // The receiver asks for each frame; where none can go out, it gets that.
  virtual bool is_pulled() const { return false; }
  virtual std::size_t nothing_now(std::span<std::byte>) { return 0; }
  // The sender begins by itself, the receiver never asks.
  virtual bool starts_itself() const { return false; }

  // What the partner sent when this side had yielded; empty when nothing came, or it was taken.
  virtual std::span<const std::byte> telegram() const { return {}; }
  virtual void take_telegram() {}
};

std::unique_ptr<SendRules> make_send_rules(const Settings& settings);

}  // namespace dripfeed::packet
