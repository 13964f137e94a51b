// The receiver's side of XMODEM: it asks with C three times, then with NAK; reads a packet by its first byte; lets what
// is left of a bad one run out before it says NAK; believes an end only when it comes twice.
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
constexpr std::uint32_t kAsksForFile = 3;
constexpr std::uint64_t kLongestFile = std::uint64_t{1} << 50U;

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
  ended_ = asks_again_ = headed_ = file_over_ = false;
  left_.reset();
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
  if (cans_ == 2 && file_over_) return {ReceiveInput::end};
  if (cans_ == 2) return {ReceiveInput::cancelled, Cause::peer_cancelled};
  if (state == ReceiveState::full) return {};
  if (byte == kEot) return hear_end();
  if (byte != kSoh && byte != kStx) return {};
  ended_ = false;
  have_ = 1;
  frame_[0] = std::byte{byte};
  size_ = byte == kStx ? kLong : kShort;
  return {ReceiveInput::header};
}

// The first end is doubted. Of YMODEM the batch goes on after it.
Received XmodemReceiveRules::hear_end() {
  if (!file_over_ && !std::exchange(ended_, true)) return {ReceiveInput::first_end};
  // The end of a text whose beginning never came: this side began again meanwhile. Or of one that is not all here.
  const bool begun = headed_ || !first_;
  if (!begun || left_.value_or(0) > 0) return {ReceiveInput::out_of_step, Cause::broken_off};
  if (!headed_) return {ReceiveInput::end};
  file_over_ = asks_again_ = true;
  return {ReceiveInput::aside};
}

Received XmodemReceiveRules::judge() {
  const auto number = static_cast<std::uint8_t>(frame_[1]);
  if (frame_[1] != ~frame_[2]) return {ReceiveInput::bad};
  const auto data = std::span<const std::byte>(frame_).subspan(kHead, size_);
  const auto check = std::span<const std::byte>(frame_).subspan(kHead + size_);
  const bool holds = crc_ ? crc16(data) == (static_cast<unsigned>(check[0]) << 8U | static_cast<unsigned>(check[1]))
                          : std::byte{sum8(data)} == check[0];
  if (!holds) return {ReceiveInput::bad};
  if (number == 0 && (first_ || file_over_)) return judge_header();
  if (file_over_) return {ReceiveInput::out_of_step, Cause::out_of_step};
  if (number == expected_) {
    first_ = false;
    ++expected_;
    kept_ = left_ ? static_cast<std::size_t>(std::min<std::uint64_t>(size_, *left_)) : size_;
    if (left_) *left_ -= kept_;
    return {ReceiveInput::good};
  }
  const auto before = static_cast<std::uint8_t>(expected_ - 1);
  if (!first_ && number == before) return {ReceiveInput::repeated};
  return {ReceiveInput::out_of_step, Cause::out_of_step};
}

// The header that YMODEM sends before the first block: name and length. XMODEM did not ask for it and takes no notice.
Received XmodemReceiveRules::judge_header() {
  asks_again_ = true;
  if (!is_batch()) return {ReceiveInput::aside};
  const auto data = std::span<const std::byte>(frame_).subspan(kHead, size_);
  if (data.front() == std::byte{0}) {
    asks_again_ = false;
    return {ReceiveInput::end};
  }
  if (file_over_) return {ReceiveInput::out_of_step, Cause::second_file};
  headed_ = true;
  left_.reset();
  const auto name_end = std::ranges::find(data, std::byte{0});
  std::uint64_t length = 0;
  bool has_length = false;
  for (auto at = name_end == data.end() ? name_end : name_end + 1; at != data.end(); ++at) {
    const auto digit = static_cast<std::uint8_t>(*at);
    if (digit < '0' || digit > '9' || length > kLongestFile) break;
    length = length * 10 + (digit - '0');
    has_length = true;
  }
  if (has_length) left_ = length;
  return {ReceiveInput::aside};
}

std::optional<Time> XmodemReceiveRules::silence(ReceiveState state) const {
  if (file_over_ && state == ReceiveState::waiting) return kCrcInvitationEvery;
  if (state == ReceiveState::inviting) return crc_ ? kCrcInvitationEvery : kPacketTime;
  if (state == ReceiveState::framing || state == ReceiveState::purging) return kCharacterTime;
  return kPacketTime;
}

std::uint32_t XmodemReceiveRules::attempts(ReceiveState state) const {
  if (file_over_) return kAsksForFile;
  return state == ReceiveState::inviting ? 0 : kAttempts;  // an operator may take long to start
}

std::span<const std::byte> XmodemReceiveRules::payload() const {
  return std::span<const std::byte>(frame_).subspan(kHead, kept_);
}

// After a header of YMODEM, and after the end of a file, the sender waits to be asked once more.
std::size_t XmodemReceiveRules::acknowledge(std::span<std::byte> out) {
  put(out, kAck);
  if (!std::exchange(asks_again_, false)) return 1;
  return 1 + put(out.subspan(1), crc_ ? kWantCrc : kNak);
}

// A sender that has not sent its first block goes by C or NAK whether it is to use CRC.
std::size_t XmodemReceiveRules::refuse(std::span<std::byte> out) {
  return put(out, (first_ || file_over_) && crc_ ? kWantCrc : kNak);
}

std::size_t XmodemReceiveRules::cancel(std::span<std::byte> out) { return put(out, kCan, kCansSent); }

}  // namespace dripfeed::packet
