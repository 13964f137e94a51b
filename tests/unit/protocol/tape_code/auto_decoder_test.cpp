// Finding out a stream's code, and every form of writing a text read back: all codes, EOBs, fillers and cuts.
#include "protocol/tape_code/auto_decoder.h"

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "protocol/tape_code/wire_encoder.h"

namespace dripfeed::tape_code {
namespace {

std::string encoded(const WireFormat& format, const std::string& text) {
  SpanSource source(text);
  WireEncoder encoder(format, source, text.size());
  std::string wire;
  std::array<std::byte, 64> out{};
  std::array<std::uint8_t, 64> ends{};
  for (;;) {
    const auto filled = encoder.fill(out, ends);
    for (std::size_t i = 0; i < filled.count; ++i) wire += static_cast<char>(out[i]);
    if (filled.status == FillStatus::end) return wire;
    if (filled.status != FillStatus::more) return "not coded";
  }
}

template <class Decoder>
std::string decoded(Decoder& decoder, std::string_view wire, std::mt19937& random) {
  std::string text;
  while (!wire.empty()) {
    const std::size_t count = std::min<std::size_t>(1 + random() % 9, wire.size());
    decoder.decode(std::as_bytes(std::span(wire.substr(0, count))), text);
    wire.remove_prefix(count);
  }
  decoder.finish(text);
  return text;
}

// A program of characters that every code has.
std::string program(std::mt19937& random) {
  constexpr std::string_view kBody = "GXYZFMNO0123456789.-/(),+ ";
  std::string text = "%\n";
  const std::size_t lines = 1 + random() % 12;
  for (std::size_t i = 0; i < lines; ++i) {
    const std::size_t length = random() % 12;
    for (std::size_t j = 0; j < length; ++j) text += kBody[random() % kBody.size()];
    text += '\n';
  }
  return text + "M30\n%";
}

std::vector<WireFormat> formats(unsigned seed) {
  std::vector<WireFormat> all;
  for (const Eob eob : {Eob::lf, Eob::cr_lf, Eob::lf_cr_cr, Eob::cr, *parse_eob("CR LF LF"), *parse_eob("1E 03")}) {
    for (const EighthBit eighth : {EighthBit::data, EighthBit::clear, EighthBit::even, EighthBit::odd}) {
      all.push_back({.eighth_bit = eighth, .eob = eob});
    }
  }
  all.push_back({.eighth_bit = EighthBit::data, .eia = EiaSpecials{}});
  for (WireFormat& format : all) {
    format.leader_chars = seed % 4 * 7;
    format.trailer_chars = seed % 3 * 5;
    format.filler = seed % 2 == 0 ? Filler::nul : Filler::del;
  }
  return all;
}

TEST(WireDecoder, ReadsBackWhatWasWrittenInEveryCode) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    const std::string text = program(random);
    for (const WireFormat& format : formats(seed)) {
      WireDecoder decoder({.eighth_bit = format.eighth_bit, .eia = format.eia, .eob = format.eob});
      const std::string back = decoded(decoder, encoded(format, text), random);
      ASSERT_EQ(back.substr(0, decoder.kept()), text) << "seed " << seed << ", EOB " << name(format.eob);
      EXPECT_EQ(decoder.parity_errors(), 0U);
      EXPECT_EQ(decoder.blanks_inside(), 0U);
    }
  }
}

TEST(WireDecoder, ABlankMakesEveryBlockEven) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    const std::string text = program(random) + "\n";
    for (WireFormat format : formats(seed)) {
      format.pad_tv = true;
      WireDecoder decoder({.eighth_bit = format.eighth_bit, .eia = format.eia, .eob = format.eob});
      std::string back = decoded(decoder, encoded(format, text), random);
      EXPECT_EQ(decoder.odd_blocks(), 0U) << "seed " << seed;
      back.resize(decoder.kept());
      std::string without;
      for (std::size_t i = 0; i < back.size(); ++i) {
        const bool added =
            back[i] == ' ' && back[i + 1] == '\n' && without.size() < text.size() && text[without.size()] == '\n';
        if (!added) without += back[i];
      }
      ASSERT_EQ(without + "\n", text);
    }
  }
}

TEST(WireDecoder, CountsOddBlocksWithTheirLine) {
  std::mt19937 random(1);
  WireDecoder decoder(EighthBit::data);
  decoded(decoder, "%ABC\nAB\nABC\nA\n\n%", random);  // 3, 4, 2, 1 characters after the label
  EXPECT_EQ(decoder.odd_blocks(), 2U);
  EXPECT_EQ(decoder.first_odd_line(), 2U);
  WireDecoder cr_lf(EighthBit::data);
  decoded(cr_lf, "%\r\nABC\r\nAB\r\nM30\r\n%", random);  // CR does not count
  EXPECT_EQ(cr_lf.odd_blocks(), 1U);
  EXPECT_EQ(cr_lf.first_odd_line(), 3U);
}

TEST(WireDecoder, KeepsOrSkipsTheLabel) {
  std::mt19937 random(2);
  const auto read = [&](Label label, std::string_view wire) {
    WireDecoder decoder({.eighth_bit = EighthBit::data, .label = label});
    return decoded(decoder, wire, random);
  };
  const std::string_view tape("\0\0LABEL%ROLL\r\nO1\r\n%", 19);
  EXPECT_EQ(read(Label::from_percent, tape), "%ROLL\nO1\n%");
  EXPECT_EQ(read(Label::keep, tape), "LABEL%ROLL\nO1\n%");
  EXPECT_EQ(read(Label::skip, tape), "%\nO1\n%");
  EXPECT_EQ(read(Label::skip, "LABEL\nO1\n%"), "O1\n%");
  EXPECT_EQ(read(Label::keep, "O1\nM30\n"), "O1\nM30\n");
  EXPECT_EQ(read(Label::skip, "no EOB"), "");
}

TEST(WireDecoder, ABlankInsideAnEiaTapeIsCounted) {
  std::mt19937 random(3);
  const WireFormat format{.leader_chars = 3, .trailer_chars = 2, .eia = EiaSpecials{}};
  std::string wire = encoded(format, "%\nO1\nM30\n%");
  wire.insert(6, 1, '\0');
  wire.insert(6, 1, '\x7F');  // a rub-out is none
  WireDecoder decoder({.eia = EiaSpecials{}});
  EXPECT_EQ(decoded(decoder, wire, random).substr(0, decoder.kept()), "%\nO1\nM30\n%");
  EXPECT_EQ(decoder.blanks_inside(), 1U);
  EXPECT_EQ(decoder.fillers_inside(), 2U);
  EXPECT_EQ(decoder.parity_errors(), 0U);
  wire[6] = 0x11;  // even: no code of EIA
  WireDecoder other({.eia = EiaSpecials{}});
  decoded(other, wire, random);
  EXPECT_EQ(other.parity_errors(), 1U);
  EXPECT_EQ(other.first_parity_error()->wire_offset, 6U);
}

TEST(AutoDecoder, FindsTheCode) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 random(seed);
    const std::string text = program(random);
    for (const WireFormat& format : formats(seed)) {
      const bool custom = characters(format.eob).size() > 1 && characters(format.eob).front() == 0x1E;
      if (format.eighth_bit == EighthBit::odd || custom) continue;  // neither ISO nor ASCII nor EIA
      AutoDecoder decoder({.eob = format.eob});
      const std::string back = decoded(decoder, encoded(format, text), random);
      ASSERT_TRUE(decoder.code());
      const Code code = format.eia ? Code::eia : format.eighth_bit == EighthBit::even ? Code::iso : Code::ascii;
      EXPECT_EQ(*decoder.code(), code) << "seed " << seed << ", EOB " << name(format.eob);
      EXPECT_EQ(back.substr(0, decoder.decoder()->kept()), text);
      EXPECT_EQ(decoder.decoder()->parity_errors(), 0U);
    }
  }
}

TEST(AutoDecoder, AWrongBitIsCountedAndChangesNoCode) {
  std::mt19937 random(4);
  const std::string text = "%\nO1234\nG1X1.5\nM30\n%";
  for (const bool is_eia : {false, true}) {
    WireFormat format{.leader_chars = 4};
    if (is_eia) format.eia = EiaSpecials{};
    const std::string good = encoded(format, text);
    for (std::size_t at = 7; at < good.size(); ++at) {  // after the leader, '%' and the first EOB
      std::string bad = good;
      bad[at] = static_cast<char>(bad[at] ^ 0x04);
      if (bad[at] == '\0') continue;  // a blank, and counted as one
      AutoDecoder decoder({});
      decoded(decoder, bad, random);
      EXPECT_EQ(*decoder.code(), is_eia ? Code::eia : Code::iso);
      EXPECT_EQ(decoder.decoder()->parity_errors(), 1U) << at;
      EXPECT_EQ(decoder.decoder()->first_parity_error()->wire_offset, at);
    }
  }
}

TEST(AutoDecoder, ALongBeginningWithoutEobIsJudgedByParity) {
  std::mt19937 random(5);
  const std::string text = "%" + std::string(2 * AutoDecoder::kLookAhead, 'G') + "1X2";
  for (const bool is_eia : {false, true}) {
    WireFormat format;
    if (is_eia) format.eia = EiaSpecials{};
    AutoDecoder decoder({});
    EXPECT_EQ(decoded(decoder, encoded(format, text), random), text);
    EXPECT_EQ(*decoder.code(), is_eia ? Code::eia : Code::iso);
  }
  AutoDecoder ascii({});
  EXPECT_EQ(decoded(ascii, text, random), text);
  EXPECT_EQ(*ascii.code(), Code::ascii);
  AutoDecoder nothing({});
  EXPECT_EQ(decoded(nothing, "", random), "");
}

}  // namespace
}  // namespace dripfeed::tape_code
