// What a byte from the control is taken for, and that no single flipped bit makes a stop into a start.
#include "protocol/feed/line_code.h"

#include <gtest/gtest.h>

namespace dripfeed::feed {
namespace {

using tape_code::EighthBit;

Signal of(int byte, EighthBit eighth, std::optional<std::uint8_t> eot = {}, const FlowCharacters& flow = {}) {
  return classify(static_cast<std::uint8_t>(byte), eighth, flow, eot);
}

TEST(LineCode, WhatStopsIsBelievedWithOrWithoutParity) {
  for (const EighthBit eighth : {EighthBit::data, EighthBit::clear, EighthBit::even, EighthBit::odd}) {
    EXPECT_EQ(of(0x13, eighth), Signal::dc3);
    EXPECT_EQ(of(0x93, eighth), Signal::dc3);
    EXPECT_EQ(of(0x16, eighth), Signal::syn);
    EXPECT_EQ(of(0x96, eighth), Signal::syn);
    EXPECT_EQ(of(0x15, eighth), Signal::nak);
    EXPECT_EQ(of(0x95, eighth), Signal::nak);
  }
}

TEST(LineCode, WhatGoesOnMustHaveTheRightBit) {
  EXPECT_EQ(of(0x11, EighthBit::even), Signal::dc1);
  EXPECT_EQ(of(0x91, EighthBit::even), Signal::unexpected);
  EXPECT_EQ(of(0x11, EighthBit::odd), Signal::unexpected);
  EXPECT_EQ(of(0x91, EighthBit::odd), Signal::dc1);
  EXPECT_EQ(of(0x11, EighthBit::data), Signal::dc1);
  EXPECT_EQ(of(0x91, EighthBit::data), Signal::unexpected);
  EXPECT_EQ(of(0x91, EighthBit::clear), Signal::dc1);
  EXPECT_EQ(of(0x12, EighthBit::even), Signal::dc2);
  EXPECT_EQ(of(0x92, EighthBit::even), Signal::unexpected);
  EXPECT_EQ(of(0x14, EighthBit::even), Signal::dc4);
}

TEST(LineCode, NoSingleFlippedBitMakesADc3WithParityIntoAStart) {
  for (int bit = 0; bit < 8; ++bit) {
    EXPECT_NE(of(0x93 ^ (1 << bit), EighthBit::even), Signal::dc1) << bit;
    EXPECT_NE(of(0x13 ^ (1 << bit), EighthBit::odd), Signal::dc1) << bit;
  }
}

TEST(LineCode, TheEndCharacterIsTheProfiles) {
  EXPECT_EQ(of(0x84, EighthBit::even), Signal::unexpected);
  EXPECT_EQ(of(0x84, EighthBit::even, 0x04), Signal::eot);
  EXPECT_EQ(of(0x04, EighthBit::even, 0x04), Signal::unexpected);
  EXPECT_EQ(of(0x1A, EighthBit::data, 0x1A), Signal::eot);
  EXPECT_EQ(of(0x9A, EighthBit::data, 0x1A), Signal::eot);
}

// XON 0E has three ones, XOFF 0F four: with even parity they go as 8E and 0F.
TEST(LineCode, AProfileHasItsOwnFlowCharacters) {
  const FlowCharacters own{.xon = 0x0E, .xoff = 0x0F};
  EXPECT_EQ(of(0x8E, EighthBit::even, {}, own), Signal::dc1);
  EXPECT_EQ(of(0x0E, EighthBit::even, {}, own), Signal::unexpected) << "a start needs its parity";
  EXPECT_EQ(of(0x0E, EighthBit::data, {}, own), Signal::dc1);
  EXPECT_EQ(of(0x8E, EighthBit::data, {}, own), Signal::dc1) << "a control may send it with parity on 8 data bits";
  EXPECT_EQ(of(0x0F, EighthBit::even, {}, own), Signal::dc3);
  EXPECT_EQ(of(0x8F, EighthBit::even, {}, own), Signal::dc3) << "a stop is believed with both parities";
  EXPECT_EQ(of(0x11, EighthBit::even, {}, own), Signal::unexpected);
  EXPECT_EQ(of(0x93, EighthBit::even, {}, own), Signal::unexpected);
}

TEST(LineCode, TheRestIsUnexpected) {
  for (int byte = 0; byte < 256; ++byte) {
    const int low = byte & 0x7F;
    if (low >= 0x11 && low <= 0x16) continue;
    EXPECT_EQ(of(byte, EighthBit::data), Signal::unexpected) << byte;
  }
}

}  // namespace
}  // namespace dripfeed::feed
