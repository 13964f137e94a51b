// Wire to text: the extent of the text, parity errors and their offsets, fillers.
#include "protocol/tape_code/wire_decoder.h"

#include <random>

#include <gtest/gtest.h>

#include "protocol/tape_code/parity.h"

namespace dripfeed::tape_code {
namespace {

std::string with(EighthBit eighth, std::string_view text) {
  std::string wire;
  for (const char c : text) wire += static_cast<char>(with_parity(static_cast<std::uint8_t>(c), eighth));
  return wire;
}

struct Text {
  std::string all;
  std::string kept;
};

Text decode(WireDecoder& decoder, const std::string& wire, std::size_t step) {
  std::string out;
  for (std::size_t at = 0; at < wire.size(); at += step) {
    decoder.decode(std::as_bytes(std::span(wire)).subspan(at, std::min(step, wire.size() - at)), out);
  }
  decoder.finish(out);
  EXPECT_EQ(decoder.appended(), out.size());
  return {.all = out, .kept = out.substr(0, decoder.kept())};
}

TEST(WireDecoder, TakesTheTextFromTheFirstToTheLastPercent) {
  using namespace std::string_view_literals;
  const std::string_view tape = "\0\0junk\n%\r\nO1\r\nM30\r\n%\r\n\0\0\0"sv;
  for (const EighthBit eighth : {EighthBit::data, EighthBit::clear, EighthBit::even, EighthBit::odd}) {
    for (std::size_t step = 1; step < 30; ++step) {
      WireDecoder decoder(eighth);
      const Text text = decode(decoder, with(eighth, tape), step);
      EXPECT_EQ(text.kept, "%\nO1\nM30\n%");
      EXPECT_EQ(decoder.parity_errors(), 0U);
      EXPECT_EQ(decoder.wire_bytes(), tape.size());
      EXPECT_EQ(decoder.fillers_inside(), 0U);
    }
  }
}

TEST(WireDecoder, SeveralFilesGoToTheLastPercent) {
  WireDecoder decoder(EighthBit::data);
  EXPECT_EQ(decode(decoder, "%A\nG1\n%B\nG2\n%\n", 3).kept, "%A\nG1\n%B\nG2\n%");
}

TEST(WireDecoder, WithoutPercentThereIsNoText) {
  WireDecoder decoder(EighthBit::even);
  const Text text = decode(decoder, with(EighthBit::even, "O1\nM30\n"), 2);
  EXPECT_EQ(text.all, "");
  EXPECT_EQ(decoder.kept(), 0U);
}

TEST(WireDecoder, FindsAParityErrorAndItsOffset) {
  const std::string good = with(EighthBit::even, "%\nG1X1\nM30\n%");
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string bad = good;
      bad[at] = static_cast<char>(static_cast<std::uint8_t>(bad[at]) ^ (1U << bit));
      WireDecoder decoder(EighthBit::even);
      decode(decoder, bad, 4);
      ASSERT_EQ(decoder.parity_errors(), 1U);
      EXPECT_EQ(decoder.first_parity_error()->wire_offset, at);
      EXPECT_EQ(decoder.first_parity_error()->byte, static_cast<std::uint8_t>(bad[at]));
    }
  }
  WireDecoder odd(EighthBit::odd);
  decode(odd, good, 5);
  EXPECT_EQ(odd.parity_errors(), good.size());
}

TEST(WireDecoder, NulAndDelInsideAreCountedAndDropped) {
  WireDecoder decoder(EighthBit::clear);
  const std::string wire(
      "%\nG\0"
      "1\x7F\n%\0\0",
      10);
  EXPECT_EQ(decode(decoder, wire, 1).kept, "%\nG1\n%");
  EXPECT_EQ(decoder.fillers_inside(), 2U);
}

TEST(WireDecoder, AnEighthBitThatIsDataStays) {
  WireDecoder decoder(EighthBit::data);
  EXPECT_EQ(decode(decoder, "%(\xC4)\n%", 1).kept, "%(\xC4)\n%");
}

}  // namespace
}  // namespace dripfeed::tape_code
