// Wire to text where the code is not known: ISO, EIA or ASCII is found out from the first EOB, as a control does, and
// the parity of all bytes up to it. Works on a channel of 8 bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "protocol/tape_code/framing.h"
#include "protocol/tape_code/wire_decoder.h"

namespace dripfeed::tape_code {

// Rule. 80h is the EOB of EIA and no character of the others; 8Dh is the CR of ISO, 0Dh that of ASCII. 0Ah is LF in ISO
// and ASCII: parity decides, an eighth bit that is right against a character that should have one. Where the bytes so
// far say nothing, the next EOB is waited for.
class AutoDecoder {
 public:
  // Bytes that are held back while the code is open; a longer beginning is judged by parity alone.
  static constexpr std::size_t kLookAhead = 4096;

  // eighth_bit is found out; eia holds the specials that an EIA tape would have.
  explicit AutoDecoder(const DecodeFormat& format) : format_(format) {}

  // As WireDecoder's: nothing is appended until the code is found, then all of it.
  void decode(std::span<const std::byte> wire, std::string& out);
  void finish(std::string& out);

  // Nothing while the code is open.
  std::optional<Code> code() const { return code_; }
  // The decoder with its counts, once the code is found.
  const WireDecoder* decoder() const { return decoder_ ? &*decoder_ : nullptr; }

 private:
  void look(std::uint8_t byte);
  Code by_parity() const;
  void decode_held_as(Code code, std::string& out);

  DecodeFormat format_;
  std::optional<Code> code_;
  std::optional<WireDecoder> decoder_;
  std::array<std::byte, kLookAhead> held_{};
  std::size_t held_count_ = 0;
  std::uint32_t even_high_ = 0;  // bytes above 7Fh with even parity: ISO alone
  std::uint32_t even_low_ = 0;   // ISO or ASCII
  std::uint32_t odd_low_ = 0;    // ASCII or EIA
};

}  // namespace dripfeed::tape_code
