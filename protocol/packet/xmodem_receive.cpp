// The receiver's side of XMODEM: it asks with C three times, then with NAK; reads a packet by its first byte; lets what
// is left of a bad one run out before it says NAK; believes an end only when it is told twice.
#include <algorithm>
#include <utility>

#include "protocol/packet/check_sums.h"
#include "protocol/packet/xmodem.h"

namespace dripfeed::packet {

using namespace xmodem;

namespace {

constexpr std::uint32_t kCrcInvitations = 4;
constexpr Time kCrcInvitationEvery = std::chrono::seconds(3);
constexpr Time kPacketTime = std::chrono::seconds(10);
constexpr Time kCharacterTime = std::chrono::seconds(1);
constexpr std::uint32_t kAttempts = 10;

std::size_t put(std::span<std::byte> out, std::uint8_t byte, std::size_t count = 1) {
  std::ranges::fill(out.first(count), std::byte{byte});
  return count;
}

}  // namespace

void XmodemReceiveRules::begin() {
  invitations_ = 0;
  crc_ = settings_.protocol != Protocol::xmodem;
  expected_ = 1;
  first_ = true;
  header_ = false;
  ended_ = false;
  cans_ = 0;
}

std::size_t XmodemReceiveRules::invite(std::span<std::byte> out) {
  crc_ = settings_.protocol != Protocol::xmodem && invitations_ < kCrcInvitations;
  ++invitations_;
  return put(out, crc_ ? kWantCrc : kNak);
}

Received XmodemReceiveRules::hear(std::uint8_t byte, ReceiveState state) {
  switch (state) {
    case ReceiveState::idle:
    case ReceiveState::done:
    case ReceiveState::failed:
    case ReceiveState::purging: return {};
    case ReceiveState::framing:
      frame_[have_++] = std::byte{byte};
      return have_ == kHead + size_ + (crc_ ? 2 : 1) ? judge() : Received{};
    case ReceiveState::full:
    case ReceiveState::inviting:
    case ReceiveState::waiting: break;
  }
  cans_ = byte == kCan ? cans_ + 1 : 0;
  if (cans_ == 2) return {ReceiveInput::cancelled, Cause::peer_cancelled};
  if (state == ReceiveState::full) return {};
  if (byte == kEot) {
    if (!std::exchange(ended_, true)) return {ReceiveInput::told_end};
    // The end of a text whose beginning never came: this side began anew meanwhile.
    return first_ ? Received{ReceiveInput::out_of_step, Cause::broken_off} : Received{ReceiveInput::end};
  }
  if (byte != kSoh && byte != kStx) return {};
  ended_ = false;
  have_ = 1;
  frame_[0] = std::byte{byte};
  size_ = byte == kStx ? kLong : kShort;
  return {ReceiveInput::header};
}

Received XmodemReceiveRules::judge() {
  const auto number = static_cast<std::uint8_t>(frame_[1]);
  if (frame_[1] != ~frame_[2]) return {ReceiveInput::bad};
  const auto data = std::span<const std::byte>(frame_).subspan(kHead, size_);
  const auto check = std::span<const std::byte>(frame_).subspan(kHead + size_);
  const bool holds = crc_ ? crc16(data) == (static_cast<unsigned>(check[0]) << 8U | static_cast<unsigned>(check[1]))
                          : std::byte{sum8(data)} == check[0];
  if (!holds) return {ReceiveInput::bad};
  // The header that YMODEM sends before the first block: name and length, which nobody asked for.
  header_ = first_ && number == 0;
  if (header_) return {ReceiveInput::repeated};
  if (number == expected_) {
    first_ = false;
    ++expected_;
    return {ReceiveInput::good};
  }
  const auto before = static_cast<std::uint8_t>(expected_ - 1);
  if (!first_ && number == before) return {ReceiveInput::repeated};
  return {ReceiveInput::out_of_step, Cause::out_of_step};
}

std::optional<Time> XmodemReceiveRules::silence(ReceiveState state) const {
  if (state == ReceiveState::inviting) return crc_ ? kCrcInvitationEvery : kPacketTime;
  if (state == ReceiveState::framing || state == ReceiveState::purging) return kCharacterTime;
  return kPacketTime;
}

std::uint32_t XmodemReceiveRules::attempts(ReceiveState state) const {
  return state == ReceiveState::inviting ? 0 : kAttempts;  // an operator may take his time to start
}

std::span<const std::byte> XmodemReceiveRules::payload() const {
  return std::span<const std::byte>(frame_).subspan(kHead, size_);
}

// Behind a header of YMODEM the sender waits to be asked once more.
std::size_t XmodemReceiveRules::acknowledge(std::span<std::byte> out) {
  put(out, kAck);
  if (!std::exchange(header_, false)) return 1;
  return 1 + put(out.subspan(1), crc_ ? kWantCrc : kNak);
}

// A sender that has not sent its first block goes by C or NAK whether it is to use CRC.
std::size_t XmodemReceiveRules::refuse(std::span<std::byte> out) { return put(out, first_ && crc_ ? kWantCrc : kNak); }

std::size_t XmodemReceiveRules::cancel(std::span<std::byte> out) { return put(out, kCan, kCansSent); }

}  // namespace dripfeed::packet
