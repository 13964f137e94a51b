// RS-244: odd parity and uniqueness of every code, the values of a printed table, the specials.
#include "protocol/tape_code/eia.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "protocol/tape_code/character_set.h"
#include "protocol/tape_code/code_table.h"
#include "protocol/tape_code/parity.h"

namespace dripfeed::tape_code {
namespace {

const EiaSpecials kNone;

TEST(Eia, EveryCodeIsOddAndOfOneCharacter) {
  std::set<int> codes;
  std::size_t characters = 0;
  for (int c = 0; c < 256; ++c) {
    const std::uint8_t code = eia_code(static_cast<char>(c), kNone);
    if (code == 0) continue;
    ++characters;
    EXPECT_TRUE(odd_ones(code)) << c;
    EXPECT_TRUE(codes.insert(code).second) << c;
  }
  EXPECT_EQ(characters,
            10U + 26U + 6U + 2U + 2U + 2U);  // digits, letters, . , / + - &, ( ), blank and TAB, EOB and EOR
}

// Channels 1 to 4 are the digit, 6 and 7 the row of letters, 5 the parity: the rule of the standard, worked out.
TEST(Eia, LettersAndDigitsFollowTheTracks) {
  const auto with_channel_5 = [](int tracks) {
    return odd_ones(static_cast<std::uint8_t>(tracks)) ? tracks : (tracks | 0x10);
  };
  for (int digit = 1; digit <= 9; ++digit) {
    EXPECT_EQ(eia_code(static_cast<char>('0' + digit), kNone), with_channel_5(digit));
    EXPECT_EQ(eia_code(static_cast<char>('A' + digit - 1), kNone), with_channel_5(0x60 | digit));
    EXPECT_EQ(eia_code(static_cast<char>('J' + digit - 1), kNone), with_channel_5(0x40 | digit));
    if (digit > 1) {
      EXPECT_EQ(eia_code(static_cast<char>('S' + digit - 2), kNone), with_channel_5(0x20 | digit));
    }
  }
  EXPECT_EQ(eia_code('0', kNone), 0x20);
  EXPECT_EQ(eia_code('\n', kNone), 0x80);
  EXPECT_EQ(eia_code('%', kNone), 0x0B);
  EXPECT_EQ(eia_code('3', kNone), 0x13);  // a DC3 to whoever reads it by value
}

TEST(Eia, SpecialsAreTheMachinesOwn) {
  for (const char c : kEiaSpecials) EXPECT_EQ(eia_code(c, kNone), 0) << c;
  EiaSpecials specials;
  EXPECT_FALSE(validate(specials));
  specials.codes[0] = 0x4C;
  specials.codes[2] = 0x5E;
  EXPECT_FALSE(validate(specials));
  EXPECT_EQ(eia_code('[', specials), 0x4C);
  EXPECT_EQ(eia_code('#', specials), 0x5E);
  EXPECT_EQ(eia_code(']', specials), 0);
  specials.codes[1] = 0x4C;
  ASSERT_TRUE(validate(specials));
  EXPECT_EQ(validate(specials)->fault, EiaFault::taken);
  EXPECT_EQ(validate(specials)->character, ']');
  for (const int standard : {0x61, 0x80, 0x0B, 0x7F, 0x7C}) {
    specials.codes[1] = static_cast<std::uint8_t>(standard);
    EXPECT_EQ(validate(specials)->fault, EiaFault::taken) << standard;
  }
  specials.codes[1] = 0x4D;
  EXPECT_EQ(validate(specials)->fault, EiaFault::parity);
}

TEST(Eia, TablesUndoEachOther) {
  const EiaSpecials specials{.codes = {0x4C, 0x5E, 0x5B, 0x6D, 0x2F, 0x3D}};
  ASSERT_FALSE(validate(specials));
  const EncodeTable encode(EighthBit::data, specials);
  const DecodeTable decode(EighthBit::data, specials);
  for (int c = 0; c < 256; ++c) {
    const char character = static_cast<char>(c);
    ASSERT_EQ(encode.has(character), eia_code(character, specials) != 0);
    if (!encode.has(character)) continue;
    EXPECT_EQ(decode.kind(encode.code(character)), ByteKind::character);
    EXPECT_EQ(decode.character(encode.code(character)), character);
  }
  EXPECT_TRUE(characters_of(encode).has('#'));
  EXPECT_FALSE(characters_of(encode).has('g'));
  for (int byte = 1; byte < 256; ++byte) {
    const auto code = static_cast<std::uint8_t>(byte);
    if (!odd_ones(code)) {
      EXPECT_EQ(decode.kind(code), ByteKind::wrong_nothing) << byte;
    }
  }
  EXPECT_EQ(decode.kind(0x00), ByteKind::blank);
  EXPECT_EQ(decode.kind(0x7F), ByteKind::filler);
}

}  // namespace
}  // namespace dripfeed::tape_code
