// Text to wire, streaming: leader, characters in their code, EOBs as the machine wants them, trailer. Knows for
// every wire offset of late at which block and text offset it is and whether it lies between two blocks. It does not
// judge the characters (character_set does) nor when a byte may go out (the feed does).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <span>
#include <string_view>

#include "protocol/tape_code/code_table.h"
#include "protocol/tape_code/eia.h"
#include "protocol/tape_code/eob.h"
#include "protocol/tape_code/framing.h"
#include "protocol/tape_code/text_source.h"

namespace dripfeed::tape_code {

// What leader and trailer are made of.
enum class Filler : std::uint8_t { nul, del };

struct WireFormat {
  EighthBit eighth_bit = EighthBit::even;
  Eob eob = Eob::lf;  // EIA has its own: one 80h, whatever stands here
  std::uint32_t leader_chars = 0;
  std::uint32_t trailer_chars = 0;
  std::optional<EiaSpecials> eia{};  // EIA, with these specials; eighth_bit then describes the control's DC codes alone
  Filler filler = Filler::nul;
  // A blank before the EOB of a block that has, its EOB counted as one, an odd number of characters (for controls whose
  // TV check is on; CR, NUL and DEL do not count there).
  bool pad_tv = false;
};

enum class WirePart : std::uint8_t { leader, text, trailer };

// Where a wire offset lies. The offset counts wire bytes from the first of the leader; it names the gap before that
// byte, so 0 is "nothing sent".
struct WirePosition {
  std::uint64_t wire_offset = 0;
  std::uint64_t text_offset = 0;  // characters of the text that are complete on the wire before this offset
  std::uint64_t line = 1;         // EOBs complete before this offset, plus 1
  WirePart part = WirePart::leader;
  bool block_boundary = true;  // no block is begun and unfinished here
  friend bool operator==(const WirePosition&, const WirePosition&) = default;
};

// What fill() came to.
enum class FillStatus : std::uint8_t {
  more,           // the output is full, or more may follow
  not_ready,      // the source has nothing yet
  end,            // leader, text and trailer are complete
  source_failed,  // the source cannot be read
  text_short,     // the source ended before the length that was promised
  no_code,        // a character that the code does not have: the encoder stands before it
};

class WireEncoder {
 public:
  // Blocks whose place is remembered; locate() answers for offsets in these.
  static constexpr std::size_t kRememberedBlocks = 1024;

  // text_bytes: length of the text; what the source gives beyond it is never sent. The source must outlive the calls of
  // fill(), not the encoder.
  WireEncoder(const WireFormat& format, TextSource& source, std::uint64_t text_bytes);

  struct Filled {
    std::size_t count = 0;
    FillStatus status = FillStatus::more;
  };
  // Writes the next wire bytes. ends_block has out's size; [i] is nonzero where out[i] is the last byte of a block (or
  // one of leader or trailer), so that stopping after it leaves no block unfinished.
  Filled fill(std::span<std::byte> out, std::span<std::uint8_t> ends_block);

  // Wire bytes produced so far.
  std::uint64_t produced() const { return wire_; }
  // Where an offset lies, 0 ..= produced(); nothing when it is ahead or older than the remembered blocks.
  std::optional<WirePosition> locate(std::uint64_t wire_offset) const;

 private:
  struct BlockStart {
    std::uint64_t wire = 0;
    std::uint64_t text = 0;
  };

  FillStatus ready();
  void put_character(char character, std::byte& out, std::uint8_t& ends);
  void put_eob(std::byte& out, std::uint8_t& ends);
  std::string_view eob() const { return format_.eia ? std::string_view("\n") : characters(format_.eob); }
  void remember_block();
  const BlockStart& block(std::uint64_t index) const { return starts_[index % kRememberedBlocks]; }

  WireFormat format_;
  EncodeTable table_;
  TextSource* source_;
  std::uint64_t text_bytes_;
  std::span<const char> piece_;
  std::size_t piece_used_ = 0;
  std::uint64_t wire_ = 0;
  std::uint64_t text_ = 0;           // characters complete on the wire
  std::uint64_t blocks_ = 0;         // EOBs complete on the wire
  std::size_t eob_done_ = 0;         // characters of the present EOB already put
  bool padded_ = false;              // the present block got its blank
  std::uint64_t text_end_wire_ = 0;  // wire offset where the text ended, valid once text_ == text_bytes_
  std::array<BlockStart, kRememberedBlocks> starts_{};
};

// Wire length of a text with this many bytes and EOBs, and this many blocks that pad_tv asks a blank of.
std::uint64_t wire_length(const WireFormat& format, std::uint64_t text_bytes, std::uint64_t eobs,
                          std::uint64_t odd_blocks = 0);

// Where a wire offset of any age lies, by reading the text from its start (for a ledger after a restart). The source
// must have its text ready. Fails with the encoder's status; an offset beyond the end gives `end`.
std::expected<WirePosition, FillStatus> locate(const WireFormat& format, TextSource& source, std::uint64_t text_bytes,
                                               std::uint64_t wire_offset);

}  // namespace dripfeed::tape_code
