// What one packet protocol adds to the receiver: how a frame is read and judged, what is answered, its times.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "protocol/packet/event.h"
#include "protocol/packet/receive_state.h"
#include "protocol/packet/settings.h"

namespace dripfeed::packet {

// What a byte, or the silence, came to; nothing: it is part of something longer, or means nothing.
struct Received {
  std::optional<ReceiveInput> input{};
  Cause cause = Cause::none;
};

class ReceiveRules {
 public:
  ReceiveRules() = default;
  ReceiveRules(const ReceiveRules&) = delete;
  ReceiveRules& operator=(const ReceiveRules&) = delete;
  virtual ~ReceiveRules() = default;

  virtual void begin() = 0;
  virtual Received hear(std::uint8_t byte, ReceiveState state) = 0;
  // How long nothing may come in this state; none: without limit.
  virtual std::optional<Time> silence(ReceiveState state) const = 0;
  // How often in a row; 0: without limit.
  virtual std::uint32_t attempts(ReceiveState state) const = 0;
  // Bytes of text that a frame has at most, by what was agreed; the sink has room for so many before one is asked for.
  virtual std::size_t usual_payload() const = 0;
  // The text of the frame that `good` reported. Valid until the next byte.
  virtual std::span<const std::byte> payload() const = 0;

  // Each writes into `out` (kMaxAnswer) and says how much.
  virtual std::size_t invite(std::span<std::byte> out) = 0;
  virtual std::size_t begin_frame(std::span<std::byte>) { return 0; }
  virtual std::size_t acknowledge(std::span<std::byte> out) = 0;
  virtual std::size_t refuse(std::span<std::byte> out) = 0;
  virtual std::size_t finish(std::span<std::byte> out) { return acknowledge(out); }
  virtual std::size_t cancel(std::span<std::byte> out) = 0;
  // An answer to what came that is none of the above.
  virtual std::size_t reply(std::span<std::byte>) { return 0; }
  // The text is whole although its sender has more to say; when it does not, that is the end.
  virtual bool is_whole() const { return false; }
  // A frame is acknowledged although there is no room for another: the sender gets that at its next call.
  virtual bool acknowledges_at_once() const { return false; }
};

std::unique_ptr<ReceiveRules> make_receive_rules(const Settings& settings);

}  // namespace dripfeed::packet
