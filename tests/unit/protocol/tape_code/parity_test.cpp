// Oracle: the published table of ISO 840 (RS-358) byte values, typed in here value by value.
#include "protocol/tape_code/parity.h"

#include <array>
#include <utility>

#include <gtest/gtest.h>

namespace dripfeed::tape_code {
namespace {

constexpr std::array<std::pair<int, int>, 83> kIso840{{
    {'0', 0x30},  {'1', 0xB1},  {'2', 0xB2},  {'3', 0x33},  {'4', 0xB4},  {'5', 0x35},  {'6', 0x36},  {'7', 0xB7},
    {'8', 0xB8},  {'9', 0x39},  {'A', 0x41},  {'B', 0x42},  {'C', 0xC3},  {'D', 0x44},  {'E', 0xC5},  {'F', 0xC6},
    {'G', 0x47},  {'H', 0x48},  {'I', 0xC9},  {'J', 0xCA},  {'K', 0x4B},  {'L', 0xCC},  {'M', 0x4D},  {'N', 0x4E},
    {'O', 0xCF},  {'P', 0x50},  {'Q', 0xD1},  {'R', 0xD2},  {'S', 0x53},  {'T', 0xD4},  {'U', 0x55},  {'V', 0x56},
    {'W', 0xD7},  {'X', 0xD8},  {'Y', 0x59},  {'Z', 0x5A},  {0x00, 0x00}, {0x08, 0x88}, {0x09, 0x09}, {0x0A, 0x0A},
    {0x0D, 0x8D}, {' ', 0xA0},  {'%', 0xA5},  {'(', 0x28},  {')', 0xA9},  {'+', 0x2B},  {'-', 0x2D},  {':', 0x3A},
    {'/', 0xAF},  {'.', 0x2E},  {'#', 0xA3},  {'$', 0x24},  {'&', 0xA6},  {'\'', 0x27}, {'*', 0xAA},  {',', 0xAC},
    {';', 0xBB},  {'<', 0x3C},  {'=', 0xBD},  {'>', 0xBE},  {'?', 0x3F},  {'@', 0xC0},  {'"', 0x22},  {'!', 0x21},
    {'[', 0xDB},  {']', 0xDD},  {'_', 0x5F},  {0x7F, 0xFF}, {0x11, 0x11}, {0x12, 0x12}, {0x13, 0x93}, {0x14, 0x14},
    {0x02, 0x82}, {0x03, 0x03}, {0x04, 0x84}, {0x06, 0x06}, {0x15, 0x95}, {0x16, 0x96}, {'0', 0x30},  {'1', 0xB1},
    {'Z', 0x5A},  {'%', 0xA5},  {0x0A, 0x0A},
}};

TEST(Parity, GivesTheBytesOfIso840) {
  for (const auto& [character, wire] : kIso840) {
    EXPECT_EQ(with_parity(static_cast<std::uint8_t>(character), EighthBit::even), wire) << character;
    EXPECT_TRUE(parity_holds(static_cast<std::uint8_t>(wire), EighthBit::even));
    EXPECT_EQ(without_parity(static_cast<std::uint8_t>(wire), EighthBit::even), character);
  }
}

TEST(Parity, OfEveryByteInEveryMode) {
  for (int value = 0; value < 256; ++value) {
    const auto byte = static_cast<std::uint8_t>(value);
    const auto low = static_cast<std::uint8_t>(value & 0x7F);
    int ones = 0;
    for (int bit = 0; bit < 8; ++bit) ones += (value >> bit) & 1;
    EXPECT_EQ(parity_holds(byte, EighthBit::even), ones % 2 == 0);
    EXPECT_EQ(parity_holds(byte, EighthBit::odd), ones % 2 == 1);
    EXPECT_TRUE(parity_holds(byte, EighthBit::data));
    EXPECT_TRUE(parity_holds(byte, EighthBit::clear));
    EXPECT_EQ(with_parity(byte, EighthBit::data), byte);
    EXPECT_EQ(with_parity(byte, EighthBit::clear), low);
    EXPECT_TRUE(parity_holds(with_parity(byte, EighthBit::even), EighthBit::even));
    EXPECT_TRUE(parity_holds(with_parity(byte, EighthBit::odd), EighthBit::odd));
    EXPECT_NE(with_parity(byte, EighthBit::even), with_parity(byte, EighthBit::odd));
    EXPECT_EQ(without_parity(byte, EighthBit::data), byte);
    for (const EighthBit eighth : {EighthBit::clear, EighthBit::even, EighthBit::odd}) {
      EXPECT_EQ(without_parity(byte, eighth), low);
      EXPECT_EQ(without_parity(with_parity(low, eighth), eighth), low);
    }
    // One flipped bit is always seen.
    for (int bit = 0; bit < 8; ++bit) {
      const auto flipped = static_cast<std::uint8_t>(with_parity(byte, EighthBit::even) ^ (1U << bit));
      EXPECT_FALSE(parity_holds(flipped, EighthBit::even));
    }
  }
}

}  // namespace
}  // namespace dripfeed::tape_code
