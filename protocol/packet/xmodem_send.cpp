// The sender's side of XMODEM. The receiver drives: it asks, acknowledges, refuses; the sender is late only where the
// profile gives the answer a time, and then gives up, because a machine that is held must not be sent a block twice
// for nothing.
#include <algorithm>
#include <charconv>

#include "protocol/packet/check_sums.h"
#include "protocol/packet/xmodem.h"
#include "protocol/tape_code/parity.h"

namespace dripfeed::packet {

using namespace xmodem;

namespace {

constexpr std::uint32_t kAttempts = 10;
constexpr Time kEndPatience = std::chrono::seconds(10);
constexpr std::uint32_t kRestartsBelieved = 3;
constexpr std::uint32_t kFarewells = 3;
constexpr std::string_view kNameless = "PROGRAM";

std::size_t put(std::span<std::byte> out, std::uint8_t byte, std::size_t count) {
  std::ranges::fill(out.first(count), std::byte{byte});
  return count;
}

// A name has no path, and no character that ends it.
char in_name(char c) { return c > ' ' && c < 0x7F ? c : '_'; }

}  // namespace

void XmodemSendRules::begin(const Announcement& announcement) {
  std::string_view name = announcement.name;
  name.remove_prefix(std::min(name.find_last_of("/\\:") + 1, name.size()));
  if (name.empty()) name = kNameless;
  name_size_ = std::min(name.size(), name_.size());
  std::ranges::transform(name.substr(0, name_size_), name_.begin(), in_name);
  bytes_ = announcement.bytes;
  part_ = settings_.protocol == Protocol::ymodem ? Part::header : Part::blocks;
  farewells_ = 0;
  answerable_ = false;
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
    case State::calling: return answerable_ ? hear_header(byte) : Heard{};
    // An answer cannot come before the frame has left.
    case State::sending:
    case State::receiving: return {};
    case State::waiting: return hear_answer(byte);
    // Stopped, or without text: a receiver that asks hears the last block again and stays.
    case State::ready: return {byte == kNak && !first_ ? Signal::again : Signal::none};
    case State::closing: return answerable_ ? hear_end(byte) : Heard{};
  }
  return {};
}

Heard XmodemSendRules::hear_start(std::uint8_t byte) {
  const bool wants_crc = byte == kWantCrc && settings_.protocol != Protocol::xmodem;
  if (!wants_crc && byte != kNak) return {byte == kWantCrc ? Signal::none : Signal::noise};
  crc_ = wants_crc;
  return {Signal::asked};
}

// Until the header is acknowledged C asks for it again; after that, for the first block.
Heard XmodemSendRules::hear_header(std::uint8_t byte) {
  const bool asks = byte == kWantCrc || byte == kNak;
  if (part_ == Part::header_taken) {
    if (!asks) return {byte == kAck ? Signal::none : Signal::noise};
    part_ = Part::blocks;
    return {Signal::granted};
  }
  if (asks) return {Signal::again};
  if (byte != kAck) return {Signal::noise};
  part_ = Part::header_taken;
  return {Signal::later};
}

// A receiver of YMODEM that asks before it acknowledged may have lost all: it gets the end of the file once more,
// which one that has the file acknowledges again.
Heard XmodemSendRules::hear_end(std::uint8_t byte) {
  const bool asks = byte == kNak || (byte == kWantCrc && settings_.protocol == Protocol::ymodem);
  if (part_ == Part::file_taken) {
    if (!asks) return {byte == kAck ? Signal::none : Signal::noise};
    part_ = Part::batch_end;
    return {.signal = Signal::again, .counts = false};
  }
  if (asks) return {Signal::again};
  if (byte != kAck) return {Signal::noise};
  if (settings_.protocol != Protocol::ymodem || part_ == Part::batch_end) return {Signal::accepted};
  part_ = Part::file_taken;
  return {Signal::later};
}

Heard XmodemSendRules::hear_answer(std::uint8_t byte) {
  if (byte == kAck) return {Signal::accepted};
  if (byte == kNak) return {Signal::again};
  if (byte != kWantCrc) return {Signal::noise};
  // Until the first block is accepted C asks for it; after that it is a receiver that began again.
  if (first_) return {crc_ ? Signal::again : Signal::none};
  if (++restarts_ == kRestartsBelieved) return {Signal::broken, Cause::peer_restarted};
  return {Signal::noise};
}

// The end of the file is acknowledged: a receiver that does not care for the end of the batch has it all the same.
Heard XmodemSendRules::late(State state) {
  if (part_ == Part::file_taken || (part_ == Part::batch_end && farewells_ >= kFarewells)) return {Signal::accepted};
  if (state == State::closing) return {Signal::again};
  return {Signal::broken, Cause::no_answer};
}

Patience XmodemSendRules::patience(State state) const {
  if (state == State::waiting || state == State::calling)
    return {.limit = settings_.answer_patience, .attempts = kAttempts};
  if (state == State::closing) return {.limit = kEndPatience, .attempts = kAttempts};
  return {.limit = {}, .attempts = kAttempts};
}

std::size_t XmodemSendRules::frame_size(std::size_t available, bool complete) const {
  const bool has_long = settings_.protocol == Protocol::xmodem_1k || settings_.protocol == Protocol::ymodem;
  const bool may_be_long = has_long && crc_;
  if (may_be_long && available >= kLong) return kLong;
  if (may_be_long && !complete) return 0;
  if (available >= kShort) return kShort;
  return complete ? available : 0;
}

std::size_t XmodemSendRules::call(std::span<std::byte> out) {
  answerable_ = false;
  return part_ == Part::header ? header(out, true) : 0;
}

std::size_t XmodemSendRules::compose(std::span<const std::byte> payload, std::span<std::byte> out) {
  answerable_ = false;
  const std::size_t size = payload.size() > kShort ? kLong : kShort;
  const auto data = out.subspan(kHead, size);
  std::ranges::copy(payload, data.begin());
  const std::uint8_t padding = tape_code::with_parity(kSub, settings_.wire.eighth_bit);
  std::ranges::fill(data.subspan(payload.size()), std::byte{padding});
  return seal(number_, size, out);
}

std::size_t XmodemSendRules::close(std::span<std::byte> out) {
  answerable_ = false;
  if (part_ != Part::batch_end) return put(out, kEot, 1);
  ++farewells_;
  return header(out, false);
}

// Name, length, and zeros for a time and a mode that are not known; all NUL where the batch ends.
std::size_t XmodemSendRules::header(std::span<std::byte> out, bool of_file) const {
  std::array<char, kShort> text{};
  if (of_file) {
    constexpr std::string_view kUnknown = " 0 0";
    char* end = std::ranges::copy(std::span(name_).first(name_size_), text.begin()).out;
    end = std::to_chars(end + 1, text.data() + text.size() - kUnknown.size(), bytes_).ptr;
    std::ranges::copy(kUnknown, end);
  }
  std::ranges::copy(std::as_bytes(std::span(text)), out.subspan(kHead).begin());
  return seal(0, kShort, out);
}

// Head and check around the data of a block that is in its place.
std::size_t XmodemSendRules::seal(std::uint8_t number, std::size_t size, std::span<std::byte> out) const {
  out[0] = std::byte{size == kLong ? kStx : kSoh};
  out[1] = std::byte{number};
  out[2] = ~out[1];
  const auto data = out.subspan(kHead, size);
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

std::size_t XmodemSendRules::part(std::span<std::byte> out) { return put(out, kCan, kCansSent); }

void XmodemSendRules::accepted() {
  ++number_;
  first_ = false;
  restarts_ = 0;
}

}  // namespace dripfeed::packet
