// One state a byte.
#include "protocol/telnet/decoder.h"

namespace dripfeed::telnet {

namespace {
constexpr std::byte kCr{'\r'};
constexpr std::byte kNul{0};
}  // namespace

Decoder::State Decoder::on_command(std::uint8_t byte, std::span<std::byte> data, std::size_t& count) {
  if (byte == kIac) {  // a doubled FF is one FF of data
    data[count++] = std::byte{kIac};
    after_cr_ = false;
    return State::data;
  }
  if (byte == kSubBegin) {
    sub_length_ = 0;
    too_long_ = false;
    return State::sub;
  }
  if (byte < static_cast<std::uint8_t>(Verb::will)) return State::data;
  verb_ = static_cast<Verb>(byte);
  return State::verb;
}

void Decoder::end_subnegotiation(DecoderSink& sink) {
  if (too_long_) {
    ++dropped_;
  } else if (sub_length_ > 0) {
    sink.on_subnegotiation(sub_[0], std::span(sub_).subspan(1, sub_length_ - 1));
  }
}

std::size_t Decoder::decode(std::span<const std::byte> wire, std::span<std::byte> data, DecoderSink& sink) {
  std::size_t count = 0;
  for (const std::byte byte : wire) {
    const auto code = static_cast<std::uint8_t>(byte);
    switch (state_) {
      case State::data:
        if (code == kIac) {
          state_ = State::iac;
        } else if (!(after_cr_ && byte == kNul && !binary_)) {
          data[count++] = byte;
          after_cr_ = byte == kCr;
        } else {
          after_cr_ = false;
        }
        break;
      case State::iac: state_ = on_command(code, data, count); break;
      case State::verb:
        state_ = State::data;
        sink.on_negotiation(verb_, code);
        break;
      case State::sub:
        if (code == kIac) {
          state_ = State::sub_iac;
        } else if (sub_length_ < sub_.size()) {
          sub_[sub_length_++] = code;
        } else {
          too_long_ = true;
        }
        break;
      case State::sub_iac:
        if (code == kSubEnd) {
          state_ = State::data;
          end_subnegotiation(sink);
        } else if (code == kIac) {
          state_ = State::sub;
          if (sub_length_ < sub_.size()) {
            sub_[sub_length_++] = code;
          } else {
            too_long_ = true;
          }
        } else {
          // The sub-negotiation was never ended: RFC 855 leaves this open; what follows IAC is read as a command.
          ++dropped_;
          state_ = on_command(code, data, count);
        }
        break;
    }
  }
  return count;
}

}  // namespace dripfeed::telnet
