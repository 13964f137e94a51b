// Finding out the code of a stream.
#include "protocol/tape_code/auto_decoder.h"

#include "protocol/tape_code/parity.h"

namespace dripfeed::tape_code {
namespace {

constexpr std::uint8_t kLf = 0x0A;
constexpr std::uint8_t kCr = 0x0D;
constexpr std::uint8_t kIsoCr = 0x8D;

bool is_filler(std::uint8_t byte) { return byte == 0x00 || byte == 0x7F || byte == 0xFF; }

}  // namespace

void AutoDecoder::look(std::uint8_t byte) {
  if (is_filler(byte)) return;
  const bool odd = odd_ones(byte);
  const bool high = byte > kLowSevenBits;
  if (!odd && high) ++even_high_;
  if (!odd && !high) ++even_low_;
  if (odd && !high) ++odd_low_;
  switch (byte) {
    case kEiaEob: code_ = Code::eia; break;
    case kIsoCr: code_ = Code::iso; break;
    case kCr: code_ = Code::ascii; break;
    case kLf:
      if (even_high_ != odd_low_) code_ = even_high_ > odd_low_ ? Code::iso : Code::ascii;
      break;
    default: break;
  }
}

// Without an EOB that decides: EIA has odd bytes only, ISO even ones only, ASCII both and none above 7Fh.
Code AutoDecoder::by_parity() const {
  if (even_high_ > odd_low_) return Code::iso;
  if (odd_low_ == 0) return Code::iso;
  return even_low_ == 0 ? Code::eia : Code::ascii;
}

void AutoDecoder::decode(std::span<const std::byte> wire, std::string& out) {
  while (!wire.empty() && !code_) {
    held_[held_count_++] = wire.front();
    look(std::to_integer<std::uint8_t>(wire.front()));
    wire = wire.subspan(1);
    if (code_) {
      decode_held_as(*code_, out);
    } else if (held_count_ == held_.size()) {
      decode_held_as(by_parity(), out);
    }
  }
  if (decoder_) decoder_->decode(wire, out);
}

void AutoDecoder::finish(std::string& out) {
  if (!code_) decode_held_as(by_parity(), out);
  decoder_->finish(out);
}

void AutoDecoder::decode_held_as(Code code, std::string& out) {
  code_ = code;
  DecodeFormat format = format_;
  format.eighth_bit = code == Code::iso ? EighthBit::even : EighthBit::data;
  if (code != Code::eia) {
    format.eia.reset();
  } else if (!format.eia) {
    format.eia = EiaSpecials{};
  }
  decoder_.emplace(format);
  decoder_->decode(std::span(held_).first(held_count_), out);
}

}  // namespace dripfeed::tape_code
