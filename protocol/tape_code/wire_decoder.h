// Wire to text, streaming: codes checked and taken off, fillers dropped, EOBs read as LF, the label before the program
// skipped or kept. Counts what is wrong with where it stands; what to do about it is the caller's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "protocol/tape_code/code_table.h"
#include "protocol/tape_code/eia.h"
#include "protocol/tape_code/eob.h"
#include "protocol/tape_code/framing.h"

namespace dripfeed::tape_code {

// A byte that the code does not have: wrong parity, or no character of EIA.
struct ParityError {
  std::uint64_t wire_offset = 0;
  std::uint8_t byte = 0;
};

// What becomes of the characters before the program and of those that follow its '%' up to the first EOB. A control
// skips all of them ("label skip").
enum class Label : std::uint8_t {
  from_percent,  // the text begins with the first '%' and keeps what stands after it
  keep,          // the text begins with the first character that is no filler
  skip,          // of all up to the first EOB only a '%' stays, with its EOB
};

struct DecodeFormat {
  EighthBit eighth_bit = EighthBit::even;
  std::optional<EiaSpecials> eia{};  // EIA, with these specials
  Eob eob = Eob::lf;                 // read besides the usual ones, which are read whatever stands here
  Label label = Label::from_percent;
};

class WireDecoder {
 public:
  explicit WireDecoder(const DecodeFormat& format);
  explicit WireDecoder(EighthBit eighth_bit) : WireDecoder(DecodeFormat{.eighth_bit = eighth_bit}) {}

  // Appends the text of these bytes to out. A byte with wrong parity is counted, and decoded by its low 7 bits in ISO
  // and ASCII, to nothing in EIA.
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
  // NUL and DEL seen between the first and the last '%', where a tape has none. ISO disregards both.
  std::uint64_t fillers_inside() const { return fillers_kept_; }
  // Of these, blanks (00h) of an EIA tape: an error there.
  std::uint64_t blanks_inside() const { return blanks_kept_; }
  // TV check: blocks with an odd number of characters, EOB counted as one, CR and fillers not at all. The first block
  // is label and not looked at. Line of the first such block, 1-based count of EOBs of the text.
  std::uint64_t odd_blocks() const { return odd_blocks_; }
  std::uint64_t first_odd_line() const { return first_odd_line_; }

 private:
  void take(char character, std::string& out);
  void count(std::string& out, std::size_t before);
  void count_wrong(std::uint8_t byte);
  void skip_label(std::string& out, std::size_t before);

  DecodeTable table_;
  EobReader eobs_;
  Label label_;
  bool begun_ = false;
  bool in_label_ = false;
  bool percent_in_label_ = false;
  std::uint64_t appended_ = 0;
  std::uint64_t kept_ = 0;
  std::uint64_t wire_bytes_ = 0;
  std::uint64_t parity_errors_ = 0;
  std::uint64_t fillers_ = 0;
  std::uint64_t fillers_kept_ = 0;
  std::uint64_t blanks_ = 0;
  std::uint64_t blanks_kept_ = 0;
  std::uint64_t line_ = 1;
  std::uint64_t in_block_ = 0;
  std::uint64_t odd_blocks_ = 0;
  std::uint64_t first_odd_line_ = 0;
  std::optional<ParityError> first_parity_error_;
};

}  // namespace dripfeed::tape_code
