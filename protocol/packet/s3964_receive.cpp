// The receiver's side of 3964(R): it answers a call, reads to DLE ETX, acknowledges at once, and says NAK to the next
// call while there is no room. The protocol has no end of a text: whoever reads the text says when it is whole.
#include <utility>

#include "protocol/packet/s3964.h"

namespace dripfeed::packet {

using namespace s3964;

namespace {

constexpr Time kCharacterTime = std::chrono::milliseconds(220);

}  // namespace

void S3964ReceiveRules::begin() {
  expected_ = 1;
  first_ = true;
  refuses_ = false;
}

Received S3964ReceiveRules::hear(std::uint8_t byte, ReceiveState state) {
  if (state == ReceiveState::framing) return hear_frame(byte);
  const bool listens = state == ReceiveState::inviting || state == ReceiveState::waiting;
  refuses_ = !listens && state != ReceiveState::purging && byte == kStx;
  if (!listens || byte != kStx) return {};
  size_ = 0;
  xor_ = 0;
  part_ = Part::text;
  return {ReceiveInput::header};
}

Received S3964ReceiveRules::hear_frame(std::uint8_t byte) {
  if (part_ == Part::check) return byte == xor_ ? judge() : Received{ReceiveInput::bad};
  xor_ ^= byte;
  if (part_ == Part::text) {
    if (byte != kDle) return keep(byte);
    part_ = Part::after_dle;
    return {};
  }
  part_ = Part::text;
  if (byte == kDle) return keep(byte);
  if (byte != kEtx) return {ReceiveInput::bad};
  if (settings_.protocol == Protocol::s3964) return judge();
  part_ = Part::check;
  return {};
}

Received S3964ReceiveRules::keep(std::uint8_t byte) {
  if (size_ == text_.size()) return {ReceiveInput::bad};
  text_[size_++] = std::byte{byte};
  return {};
}

Received S3964ReceiveRules::judge() {
  if (!settings_.counted) return {ReceiveInput::good};
  if (size_ < kNumberBytes) return {ReceiveInput::bad};
  const auto number =
      static_cast<std::uint16_t>(static_cast<unsigned>(text_[0]) << 8U | static_cast<unsigned>(text_[1]));
  if (number == expected_) {
    ++expected_;
    first_ = false;
    return {ReceiveInput::good};
  }
  const auto before = static_cast<std::uint16_t>(expected_ - 1);
  if (!first_ && number == before) return {ReceiveInput::repeated};
  return {ReceiveInput::out_of_step, Cause::out_of_step};
}

std::optional<Time> S3964ReceiveRules::silence(ReceiveState state) const {
  if (state == ReceiveState::framing || state == ReceiveState::purging) return kCharacterTime;
  return std::nullopt;
}

std::span<const std::byte> S3964ReceiveRules::payload() const {
  const std::size_t skipped = settings_.counted ? kNumberBytes : 0;
  return std::span<const std::byte>(text_).subspan(skipped, size_ - skipped);
}

std::size_t S3964ReceiveRules::begin_frame(std::span<std::byte> out) { return acknowledge(out); }

std::size_t S3964ReceiveRules::acknowledge(std::span<std::byte> out) {
  out[0] = std::byte{kDle};
  return 1;
}

std::size_t S3964ReceiveRules::refuse(std::span<std::byte> out) {
  out[0] = std::byte{kNak};
  return 1;
}

std::size_t S3964ReceiveRules::reply(std::span<std::byte> out) {
  return std::exchange(refuses_, false) ? refuse(out) : 0;
}

}  // namespace dripfeed::packet
