// The streaming converter from wire to text.
#include "protocol/tape_code/wire_decoder.h"

namespace dripfeed::tape_code {

WireDecoder::WireDecoder(const DecodeFormat& format)
    : table_(format.eighth_bit, format.eia),
      eobs_(format.eia ? Eob::lf : format.eob),
      label_(format.label),
      in_label_(format.label == Label::skip) {}

void WireDecoder::decode(std::span<const std::byte> wire, std::string& out) {
  for (const std::byte raw : wire) {
    const auto byte = std::to_integer<std::uint8_t>(raw);
    switch (table_.kind(byte)) {
      case ByteKind::character: take(table_.character(byte), out); break;
      case ByteKind::wrong:
        count_wrong(byte);
        take(table_.character(byte), out);
        break;
      case ByteKind::wrong_nothing: count_wrong(byte); break;
      case ByteKind::filler: fillers_ += begun_ ? 1 : 0; break;
      case ByteKind::blank:
        fillers_ += begun_ ? 1 : 0;
        blanks_ += begun_ ? 1 : 0;
        break;
    }
    ++wire_bytes_;
  }
}

void WireDecoder::count_wrong(std::uint8_t byte) {
  ++parity_errors_;
  if (!first_parity_error_) first_parity_error_ = ParityError{.wire_offset = wire_bytes_, .byte = byte};
}

void WireDecoder::take(char character, std::string& out) {
  begun_ = begun_ || label_ != Label::from_percent || character == '%';
  if (!begun_) return;
  const std::size_t before = out.size();
  eobs_.put(character, out);
  count(out, before);
}

void WireDecoder::finish(std::string& out) {
  const std::size_t before = out.size();
  eobs_.finish(out);
  count(out, before);
}

// Takes account of what was appended since `before`.
void WireDecoder::count(std::string& out, std::size_t before) {
  if (in_label_) skip_label(out, before);
  for (std::size_t i = before; i < out.size(); ++i) {
    ++appended_;
    ++in_block_;
    if (out[i] == '%') {
      kept_ = appended_;
      fillers_kept_ = fillers_;
      blanks_kept_ = blanks_;
    }
    if (out[i] != '\n') continue;
    if (in_block_ % 2 != 0 && line_ > 1 && odd_blocks_++ == 0) first_odd_line_ = line_;
    in_block_ = 0;
    ++line_;
  }
}

// Of the label a '%' stays, with the EOB after it.
void WireDecoder::skip_label(std::string& out, std::size_t before) {
  std::size_t end = before;
  while (end < out.size() && out[end] != '\n') percent_in_label_ = out[end++] == '%' || percent_in_label_;
  in_label_ = end == out.size();
  if (in_label_) return out.resize(before);
  out.erase(before, percent_in_label_ ? end - before : end - before + 1);
  if (percent_in_label_) out.insert(before, 1, '%');
}

}  // namespace dripfeed::tape_code
