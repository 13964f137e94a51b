// The sender's side of 3964(R): it calls with STX before each block. A receiver that says NAK to the call is not ready,
// and is called again for as long as the profile lets an answer take; one that says nothing is called six times.
#include <utility>

#include "protocol/packet/check_sums.h"
#include "protocol/packet/s3964.h"

namespace dripfeed::packet {

using namespace s3964;

namespace {

constexpr Time kAnswerTime = std::chrono::milliseconds(2000);
constexpr Time kAnswerTimeWithoutCheck = std::chrono::milliseconds(550);
constexpr Time kPause = std::chrono::milliseconds(400);
constexpr Time kCharacterTime = std::chrono::milliseconds(220);
constexpr std::uint32_t kAttempts = 6;

// The partner numbers for itself, or not at all: what it sends is kept as it comes.
Settings of_partner(Settings settings) {
  settings.counted = false;
  return settings;
}

}  // namespace

S3964SendRules::S3964SendRules(const Settings& settings) : settings_(settings), partner_(of_partner(settings)) {}

void S3964SendRules::begin(const Announcement&) {
  number_ = 1;
  pauses_ = 0;
  not_ready_ = spoiled_ = false;
  owed_.reset();
}

Heard S3964SendRules::hear(std::uint8_t byte, State state) {
  switch (state) {
    case State::calling: return hear_call(byte);
    case State::receiving: return hear_telegram(byte);
    // A receiver that sees the block go wrong says so at once.
    case State::sending: return {byte == kNak ? Signal::again : Signal::none};
    case State::waiting: return {byte == kDle ? Signal::accepted : Signal::again};
    case State::idle:
    case State::armed:
    case State::ready:
    case State::closing:
    case State::done:
    case State::failed:
    case State::torn:
    case State::cancelled:
    case State::disarmed: break;
  }
  // The other side wants to send, and no one here receives.
  if (byte == kStx) owed_ = kNak;
  return {Signal::noise};
}

Heard S3964SendRules::hear_call(std::uint8_t byte) {
  if (byte == kDle) {
    not_ready_ = false;
    pauses_ = 0;
    return {Signal::granted};
  }
  if (byte == kNak) {
    not_ready_ = true;
    return {Signal::later};
  }
  if (byte != kStx) return {Signal::noise};
  // Both called. The side with priority goes on waiting for its DLE, the other withdraws and receives first.
  if (!settings_.yields_on_collision) return {};
  if (has_telegram_) {
    owed_ = kNak;
    not_ready_ = true;
    return {Signal::later};
  }
  static_cast<void>(partner_.hear(byte, ReceiveState::waiting));
  owed_ = kDle;
  spoiled_ = not_ready_ = false;
  return {Signal::yielded};
}

// The partner's block, its STX answered. What is wrong with it is stated when it has run out.
Heard S3964SendRules::hear_telegram(std::uint8_t byte) {
  const auto came = spoiled_ ? std::nullopt : partner_.hear(byte, ReceiveState::framing).input;
  if (came != ReceiveInput::good) {
    spoiled_ = spoiled_ || came.has_value();
    return {Signal::later};
  }
  owed_ = kDle;
  has_telegram_ = !partner_.payload().empty();
  return {Signal::telegram};
}

std::span<const std::byte> S3964SendRules::telegram() const {
  return has_telegram_ ? partner_.payload() : std::span<const std::byte>();
}

Heard S3964SendRules::late(State state) {
  if (state == State::receiving) {
    owed_ = kNak;
    return {Signal::again};
  }
  const bool waits_for_readiness = state == State::calling && std::exchange(not_ready_, false);
  if (!waits_for_readiness) return {Signal::again, Cause::no_answer};
  if (settings_.answer_patience && ++pauses_ * kPause >= *settings_.answer_patience)
    return {Signal::broken, Cause::no_answer};
  return {.signal = Signal::again, .counts = false};
}

Patience S3964SendRules::patience(State state) const {
  const Time answer = settings_.protocol == Protocol::s3964r ? kAnswerTime : kAnswerTimeWithoutCheck;
  if (state == State::calling) return {.limit = not_ready_ ? kPause : answer, .attempts = kAttempts};
  if (state == State::receiving) return {.limit = kCharacterTime, .attempts = kAttempts};
  if (state == State::waiting) return {.limit = answer, .attempts = kAttempts};
  return {.limit = {}, .attempts = kAttempts};
}

std::size_t S3964SendRules::frame_size(std::size_t available, bool complete) const {
  if (available >= settings_.payload) return settings_.payload;
  return complete ? available : 0;
}

std::size_t S3964SendRules::call(std::span<std::byte> out) {
  const std::size_t owed = reply(out);
  out[owed] = std::byte{kStx};
  return owed + 1;
}

std::size_t S3964SendRules::reply(std::span<std::byte> out) {
  if (!owed_) return 0;
  out[0] = std::byte{*std::exchange(owed_, std::nullopt)};
  return 1;
}

std::size_t S3964SendRules::compose(std::span<const std::byte> payload, std::span<std::byte> out) {
  std::size_t used = 0;
  const auto put = [&](std::byte byte) {
    out[used++] = byte;
    if (byte == std::byte{kDle}) out[used++] = byte;
  };
  if (settings_.counted) {
    put(static_cast<std::byte>(number_ >> 8U));
    put(static_cast<std::byte>(number_ & 0xFFU));
  }
  for (const std::byte byte : payload) put(byte);
  out[used++] = std::byte{kDle};
  out[used++] = std::byte{kEtx};
  if (settings_.protocol == Protocol::s3964r) {
    const std::uint8_t check = xor8(out.first(used));
    out[used++] = std::byte{check};
  }
  return used;
}

}  // namespace dripfeed::packet
