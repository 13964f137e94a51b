// Wire to text, streaming: parity checked and taken off, NUL and DEL dropped, EOBs read as LF, text from the first '%'.
// What to do about an error is the caller's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "protocol/tape_code/eob.h"
#include "protocol/tape_code/framing.h"

namespace dripfeed::tape_code {

struct ParityError {
  std::uint64_t wire_offset = 0;
  std::uint8_t byte = 0;
};

class WireDecoder {
 public:
  explicit WireDecoder(EighthBit eighth_bit) : eighth_bit_(eighth_bit) {}

  // Appends the text of these bytes to out. Nothing is appended before the first '%'. A byte with wrong parity is
  // counted and decoded by its low 7 bits.
  void decode(std::span<const std::byte> wire, std::string& out);
  // The stream is over: appends an EOB that was still open.
  void finish(std::string& out);

  // Characters appended so far, and how many of them lead up to and include the last '%'. The text of a transfer is the
  // first kept() of them: what follows the last '%' is trailer. 0 while no '%' was seen.
  std::uint64_t appended() const { return appended_; }
  std::uint64_t kept() const { return kept_; }

  std::uint64_t wire_bytes() const { return wire_bytes_; }
  std::uint64_t parity_errors() const { return parity_errors_; }
  const std::optional<ParityError>& first_parity_error() const { return first_parity_error_; }
  // NUL and DEL seen between the first and the last '%', where a tape has none.
  std::uint64_t fillers_inside() const { return fillers_kept_; }

 private:
  EighthBit eighth_bit_;
  EobReader eobs_;
  bool begun_ = false;
  std::uint64_t appended_ = 0;
  std::uint64_t kept_ = 0;
  std::uint64_t wire_bytes_ = 0;
  std::uint64_t parity_errors_ = 0;
  std::uint64_t fillers_ = 0;
  std::uint64_t fillers_kept_ = 0;
  std::optional<ParityError> first_parity_error_;
};

}  // namespace dripfeed::tape_code
