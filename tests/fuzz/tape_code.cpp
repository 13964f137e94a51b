// Wire bytes to text and text to wire bytes: what comes out does not depend on how the stream is cut, and each
// direction undoes the other. The first two bytes choose parity and EOB.
#include "protocol/tape_code/tape_code.h"

#include <algorithm>
#include <array>
#include <string>

#include "tests/fuzz/target.h"

using namespace dripfeed;
using tape_code::EighthBit;

namespace {

struct Decoded {
  std::string text;
  std::uint64_t kept = 0;
  std::uint64_t parity_errors = 0;
};

Decoded decoded(std::string_view wire, const tape_code::DecodeFormat& format, std::size_t piece) {
  tape_code::WireDecoder decoder(format);
  Decoded out;
  for (std::size_t at = 0; at < wire.size(); at += piece) {
    decoder.decode(std::as_bytes(std::span(wire.substr(at, piece))), out.text);
  }
  decoder.finish(out.text);
  fuzz::require(decoder.wire_bytes() == wire.size(), "every wire byte is counted");
  fuzz::require(decoder.appended() == out.text.size(), "every character is counted");
  fuzz::require(decoder.kept() <= decoder.appended(), "no more is kept than there is");
  fuzz::require(decoder.kept() == 0 ? !out.text.contains('%') : out.text.rfind('%') + 1 == decoder.kept(),
                "the text is kept up to its last '%'");
  fuzz::require(decoder.parity_errors() == 0 || decoder.first_parity_error(), "the first parity error has a place");
  out.kept = decoder.kept();
  out.parity_errors = decoder.parity_errors();
  return out;
}

std::string encoded(const std::string& text, const tape_code::WireFormat& format, std::size_t piece) {
  tape_code::SpanSource source(text);
  tape_code::WireEncoder encoder(format, source, text.size());
  std::string wire;
  for (;;) {
    std::array<std::byte, 64> out{};
    std::array<std::uint8_t, 64> ends{};
    const auto filled = encoder.fill(std::span(out).first(piece), std::span(ends).first(piece));
    for (std::size_t i = 0; i < filled.count; ++i) {
      wire.push_back(static_cast<char>(out[i]));
      const auto place = encoder.locate(encoder.produced() - filled.count + i + 1);
      fuzz::require(place.has_value(), "a byte just made can be located");
      fuzz::require(place->block_boundary == (ends[i] != 0), "both accounts of a block's end agree");
    }
    if (filled.status == tape_code::FillStatus::end) break;
    fuzz::require(filled.status == tape_code::FillStatus::more && filled.count > 0, "a clean text goes through");
  }
  fuzz::require(encoder.produced() == wire.size(), "every byte made is counted");
  return wire;
}

// A text as a control's memory has it: from '%', without fillers and the characters of EOBs.
std::string clean(const Decoded& decoded, const tape_code::WireFormat& format) {
  const tape_code::EncodeTable table(format.eighth_bit, format.eia);
  std::string out;
  for (const char c : decoded.text.substr(0, decoded.kept)) {
    const bool of_eob = c != '\n' && characters(format.eob).contains(c);
    if (table.has(c) && c != '\0' && c != '\r' && c != '\x7f' && !of_eob) out.push_back(c);
  }
  return out;
}

// The same with the blanks that the TV check asks for.
std::string padded(const std::string& text, bool pad, std::uint64_t& odd_blocks) {
  std::string out;
  std::size_t in_block = 0;
  for (const char c : text) {
    const bool odd = c == '\n' && in_block % 2 == 0;
    odd_blocks += odd ? 1 : 0;
    if (odd && pad) out += ' ';
    out += c;
    in_block = c == '\n' ? 0 : in_block + 1;
  }
  return out;
}

// Any bytes at all: the code is found without regard to how they are cut.
void find_code(std::string_view wire) {
  tape_code::AutoDecoder whole({});
  tape_code::AutoDecoder bytes({});
  std::string text;
  std::string other;
  whole.decode(std::as_bytes(std::span(wire)), text);
  for (const char& c : wire) bytes.decode(std::as_bytes(std::span(&c, 1)), other);
  whole.finish(text);
  bytes.finish(other);
  fuzz::require(whole.code() == bytes.code() && text == other, "the code does not depend on how the stream is cut");
  fuzz::require(whole.decoder()->wire_bytes() == wire.size(), "no byte is lost while the code is open");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Choices choices(data, size);
  constexpr std::array kBits = {EighthBit::data, EighthBit::clear, EighthBit::even, EighthBit::odd};
  const std::array kEobs = {tape_code::Eob::lf,
                            tape_code::Eob::cr_lf,
                            tape_code::Eob::lf_cr_cr,
                            tape_code::Eob::cr,
                            *tape_code::parse_eob("CR LF LF"),
                            *tape_code::parse_eob("1E LF")};
  const std::uint32_t code = choices.below(6);
  tape_code::WireFormat format{.eighth_bit = kBits[code % 4], .eob = kEobs[choices.below(6)]};
  if (code > 3) format.eia = tape_code::EiaSpecials{.codes = {0x4C, 0x5E}};
  if (format.eia) format.eighth_bit = EighthBit::data;
  format.pad_tv = code == 5;
  format.leader_chars = choices.below(5);
  format.trailer_chars = choices.below(5);
  const std::string_view wire = choices.text(size);
  find_code(wire);

  const tape_code::DecodeFormat from{.eighth_bit = format.eighth_bit, .eia = format.eia, .eob = format.eob};
  const Decoded whole = decoded(wire, from, wire.size() + 1);
  const Decoded bytes = decoded(wire, from, 1);
  fuzz::require(whole.text == bytes.text && whole.kept == bytes.kept && whole.parity_errors == bytes.parity_errors,
                "decoding does not depend on how the stream is cut");

  const std::string text = clean(whole, format);
  std::uint64_t odd_blocks = 0;
  const std::string expected = padded(text, format.pad_tv, odd_blocks);
  const std::string sent = encoded(text, format, 64);
  fuzz::require(encoded(text, format, 1) == sent, "encoding does not depend on the room that is given");
  const Decoded back = decoded(sent, from, 7);
  fuzz::require(back.text.substr(0, back.kept) == expected, "what was encoded decodes to itself");
  fuzz::require(back.parity_errors == 0, "what was encoded has right parity");
  fuzz::require(tape_code::wire_length(format, text.size(), static_cast<std::uint64_t>(std::ranges::count(text, '\n')),
                                       odd_blocks) == sent.size(),
                "the wire is as long as foretold");
  return 0;
}
