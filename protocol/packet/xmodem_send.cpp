// The sender's side of XMODEM. The receiver drives: it asks, acknowledges, refuses; the sender is late only where the
// profile gives the answer a time, and then gives up, because a machine that is held must not be sent a block twice
// for nothing.
#include <algorithm>

#include "protocol/packet/check_sums.h"
#include "protocol/packet/xmodem.h"
#include "protocol/tape_code/parity.h"

namespace dripfeed::packet {

using namespace xmodem;

namespace {

constexpr std::uint32_t kAttempts = 10;
constexpr Time kEndPatience = std::chrono::seconds(10);
constexpr std::uint32_t kRestartsBelieved = 3;

std::size_t put(std::span<std::byte> out, std::uint8_t byte, std::size_t count) {
  std::ranges::fill(out.first(count), std::byte{byte});
  return count;
}

}  // namespace

void XmodemSendRules::begin() {
  number_ = 1;
  first_ = true;
  cans_ = 0;
  restarts_ = 0;
}

Heard XmodemSendRules::hear(std::uint8_t byte, State state) {
  cans_ = byte == kCan ? cans_ + 1 : 0;
  if (cans_ == 2) return {Signal::broken, Cause::peer_cancelled};
  if (cans_ == 1) return {};
  switch (state) {
    case State::idle:
    case State::done:
    case State::failed:
    case State::torn:
    case State::cancelled:
    case State::disarmed:
    case State::armed: return hear_start(byte);
    // An answer cannot come before the frame has left.
    case State::calling:
    case State::sending: return {};
    case State::waiting: return hear_answer(byte);
    // Stopped, or without text: a receiver that asks hears the last block again and stays.
    case State::ready: return {byte == kNak && !first_ ? Signal::again : Signal::none};
    case State::closing:
      if (byte == kAck) return {Signal::accepted};
      return {byte == kNak ? Signal::again : Signal::noise};
  }
  return {};
}

Heard XmodemSendRules::hear_start(std::uint8_t byte) {
  const bool wants_crc = byte == kWantCrc && settings_.protocol != Protocol::xmodem;
  if (!wants_crc && byte != kNak) return {byte == kWantCrc ? Signal::none : Signal::noise};
  crc_ = wants_crc;
  return {Signal::asked};
}

Heard XmodemSendRules::hear_answer(std::uint8_t byte) {
  if (byte == kAck) return {Signal::accepted};
  if (byte == kNak) return {Signal::again};
  if (byte != kWantCrc) return {Signal::noise};
  // Until the first block is accepted C asks for it; behind that it is a receiver that began anew.
  if (first_) return {crc_ ? Signal::again : Signal::none};
  if (++restarts_ == kRestartsBelieved) return {Signal::broken, Cause::peer_restarted};
  return {Signal::noise};
}

Heard XmodemSendRules::late(State state) {
  if (state == State::closing) return {Signal::again};
  return {Signal::broken, Cause::no_answer};
}

Patience XmodemSendRules::patience(State state) const {
  if (state == State::waiting) return {.limit = settings_.answer_patience, .attempts = kAttempts};
  if (state == State::closing) return {.limit = kEndPatience, .attempts = kAttempts};
  return {.limit = {}, .attempts = kAttempts};
}

std::size_t XmodemSendRules::frame_size(std::size_t available, bool complete) const {
  const bool may_be_long = settings_.protocol == Protocol::xmodem_1k && crc_;
  if (may_be_long && available >= kLong) return kLong;
  if (may_be_long && !complete) return 0;
  if (available >= kShort) return kShort;
  return complete ? available : 0;
}

std::size_t XmodemSendRules::compose(std::span<const std::byte> payload, std::span<std::byte> out) {
  const std::size_t size = payload.size() > kShort ? kLong : kShort;
  out[0] = std::byte{size == kLong ? kStx : kSoh};
  out[1] = std::byte{number_};
  out[2] = ~out[1];
  const auto data = out.subspan(kHead, size);
  std::ranges::copy(payload, data.begin());
  const std::uint8_t padding = tape_code::with_parity(kSub, settings_.wire.eighth_bit);
  std::ranges::fill(data.subspan(payload.size()), std::byte{padding});
  std::size_t used = kHead + size;
  if (crc_) {
    const std::uint16_t crc = crc16(data);
    out[used++] = static_cast<std::byte>(crc >> 8U);
    out[used++] = static_cast<std::byte>(crc & 0xFFU);
  } else {
    out[used++] = std::byte{sum8(data)};
  }
  return used;
}

std::size_t XmodemSendRules::close(std::span<std::byte> out) { return put(out, kEot, 1); }
std::size_t XmodemSendRules::part(std::span<std::byte> out) { return put(out, kCan, kCansSent); }

void XmodemSendRules::accepted() {
  ++number_;
  first_ = false;
  restarts_ = 0;
}

}  // namespace dripfeed::packet
