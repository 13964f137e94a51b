// The streaming converter from text to wire and its map of places.
#include "protocol/tape_code/wire_encoder.h"

#include <algorithm>

#include "protocol/tape_code/parity.h"

namespace dripfeed::tape_code {
namespace {

constexpr std::uint8_t kDel = 0x7F;

// A filler is a character like others: with odd parity a NUL's eighth bit is set. In EIA it is no hole or all but one.
std::byte filler_of(const WireFormat& format) {
  const std::uint8_t character = format.filler == Filler::nul ? std::uint8_t{0} : kDel;
  return std::byte{format.eia ? character : with_parity(character, format.eighth_bit)};
}

// Is the number of characters odd, the EOB counted as one?
bool is_odd_block(std::uint64_t characters_before_eob) { return characters_before_eob % 2 == 0; }

}  // namespace

WireEncoder::WireEncoder(const WireFormat& format, TextSource& source, std::uint64_t text_bytes)
    : format_(format),
      table_(format.eighth_bit, format.eia),
      source_(&source),
      text_bytes_(text_bytes),
      text_end_wire_(format.leader_chars) {
  starts_[0] = {.wire = format.leader_chars, .text = 0};
}

// Makes sure that a character of the text stands at piece_used_.
FillStatus WireEncoder::ready() {
  while (piece_used_ == piece_.size()) {
    const TextPiece piece = source_->next();
    switch (piece.status) {
      case SourceStatus::text: break;
      case SourceStatus::not_ready: return FillStatus::not_ready;
      case SourceStatus::end: return FillStatus::text_short;
      case SourceStatus::failed: return FillStatus::source_failed;
    }
    piece_ = piece.text;
    piece_used_ = 0;
  }
  return table_.has(piece_[piece_used_]) ? FillStatus::more : FillStatus::no_code;
}

void WireEncoder::remember_block() {
  ++blocks_;
  starts_[blocks_ % kRememberedBlocks] = {.wire = wire_, .text = text_};
}

void WireEncoder::put_eob(std::byte& out, std::uint8_t& ends) {
  ++wire_;
  if (format_.pad_tv && !padded_ && eob_done_ == 0 && is_odd_block(text_ - block(blocks_).text)) {
    padded_ = true;
    out = std::byte{table_.code(' ')};
    return;
  }
  const std::string_view all = eob();
  out = std::byte{table_.code(all[eob_done_])};
  if (++eob_done_ < all.size()) return;
  eob_done_ = 0;
  padded_ = false;
  ++piece_used_;
  ++text_;
  ends = 1;
  remember_block();
}

void WireEncoder::put_character(char character, std::byte& out, std::uint8_t& ends) {
  if (character == '\n') return put_eob(out, ends);
  out = std::byte{table_.code(character)};
  ++wire_;
  ++piece_used_;
  ++text_;
  ends = text_ == text_bytes_ ? 1 : 0;
}

WireEncoder::Filled WireEncoder::fill(std::span<std::byte> out, std::span<std::uint8_t> ends_block) {
  Filled filled;
  const std::byte filler = filler_of(format_);
  for (; filled.count < out.size(); ++filled.count) {
    std::byte& byte = out[filled.count];
    std::uint8_t& ends = ends_block[filled.count];
    ends = 0;
    if (wire_ < format_.leader_chars) {
      byte = filler;
      ends = 1;
      ++wire_;
    } else if (text_ < text_bytes_) {
      filled.status = ready();
      if (filled.status != FillStatus::more) return filled;
      put_character(piece_[piece_used_], byte, ends);
      if (text_ == text_bytes_) text_end_wire_ = wire_;
    } else if (wire_ - text_end_wire_ < format_.trailer_chars) {
      byte = filler;
      ends = 1;
      ++wire_;
    } else {
      filled.status = FillStatus::end;
      return filled;
    }
  }
  return filled;
}

std::optional<WirePosition> WireEncoder::locate(std::uint64_t wire_offset) const {
  if (wire_offset > wire_) return std::nullopt;
  WirePosition position{.wire_offset = wire_offset};
  if (wire_offset <= format_.leader_chars) {
    position.part = wire_offset < format_.leader_chars ? WirePart::leader : WirePart::text;
    return position;
  }
  if (text_ == text_bytes_ && wire_offset >= text_end_wire_) {
    position.text_offset = text_;
    position.line = blocks_ + 1;
    position.part = wire_offset > text_end_wire_ ? WirePart::trailer : WirePart::text;
    return position;
  }
  const std::uint64_t oldest = blocks_ + 1 > kRememberedBlocks ? blocks_ + 1 - kRememberedBlocks : 0;
  if (wire_offset < block(oldest).wire) return std::nullopt;
  // The last block that begins at or before the offset, by halving.
  std::uint64_t low = oldest;
  std::uint64_t high = blocks_;
  while (low < high) {
    const std::uint64_t middle = low + (high - low + 1) / 2;
    if (block(middle).wire <= wire_offset) {
      low = middle;
    } else {
      high = middle - 1;
    }
  }
  // Inside an EOB of several characters, or after the blank before it, the LF of the text is not complete yet.
  const std::uint64_t complete = low == blocks_ ? text_ : block(low + 1).text - 1;
  position.text_offset = std::min(block(low).text + (wire_offset - block(low).wire), complete);
  position.line = low + 1;
  position.part = WirePart::text;
  position.block_boundary = wire_offset == block(low).wire;
  return position;
}

std::uint64_t wire_length(const WireFormat& format, std::uint64_t text_bytes, std::uint64_t eobs,
                          std::uint64_t odd_blocks) {
  const std::uint64_t eob_growth = format.eia ? 0 : characters(format.eob).size() - 1;
  const std::uint64_t blanks = format.pad_tv ? odd_blocks : 0;
  return format.leader_chars + text_bytes + eobs * eob_growth + blanks + format.trailer_chars;
}

std::expected<WirePosition, FillStatus> locate(const WireFormat& format, TextSource& source, std::uint64_t text_bytes,
                                               std::uint64_t wire_offset) {
  WireEncoder encoder(format, source, text_bytes);
  std::array<std::byte, 256> bytes{};
  std::array<std::uint8_t, 256> ends{};
  while (encoder.produced() < wire_offset) {
    const std::size_t count = std::min<std::uint64_t>(bytes.size(), wire_offset - encoder.produced());
    const WireEncoder::Filled filled = encoder.fill({bytes.data(), count}, ends);
    if (filled.status != FillStatus::more) return std::unexpected(filled.status);
  }
  const std::optional<WirePosition> position = encoder.locate(wire_offset);
  if (!position) return std::unexpected(FillStatus::end);
  return *position;
}

}  // namespace dripfeed::tape_code
