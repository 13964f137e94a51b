// The streaming converter from wire to text.
#include "protocol/tape_code/wire_decoder.h"

#include "protocol/tape_code/parity.h"

namespace dripfeed::tape_code {
namespace {

constexpr std::uint8_t kNul = 0x00;
constexpr std::uint8_t kDel = 0x7F;

}  // namespace

void WireDecoder::decode(std::span<const std::byte> wire, std::string& out) {
  for (const std::byte raw : wire) {
    const auto byte = std::to_integer<std::uint8_t>(raw);
    if (!parity_holds(byte, eighth_bit_)) {
      ++parity_errors_;
      if (!first_parity_error_) first_parity_error_ = ParityError{.wire_offset = wire_bytes_, .byte = byte};
    }
    ++wire_bytes_;
    const std::uint8_t character = without_parity(byte, eighth_bit_);
    const bool percent = character == '%';
    begun_ = begun_ || percent;
    if (!begun_) continue;
    if (character == kNul || character == kDel) {
      ++fillers_;
      continue;
    }
    const std::size_t before = out.size();
    eobs_.put(static_cast<char>(character), out);
    appended_ += out.size() - before;
    if (!percent) continue;
    kept_ = appended_;
    fillers_kept_ = fillers_;
  }
}

void WireDecoder::finish(std::string& out) {
  const std::size_t before = out.size();
  eobs_.finish(out);
  appended_ += out.size() - before;
}

}  // namespace dripfeed::tape_code
