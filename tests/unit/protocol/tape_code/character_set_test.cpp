// The sets of the controls, and line and column of an illegal character.
#include "protocol/tape_code/character_set.h"

#include <string>

#include <gtest/gtest.h>

namespace dripfeed::tape_code {
namespace {

TEST(CharacterSet, ListsMembersAndRanges) {
  constexpr CharacterSet set("A-C9-");
  for (int c = 0; c < 256; ++c) {
    const bool member = c == 'A' || c == 'B' || c == 'C' || c == '9' || c == '-';
    EXPECT_EQ(set.has(static_cast<std::uint8_t>(c)), member) << c;
  }
  EXPECT_FALSE(CharacterSet().has('A'));
  EXPECT_TRUE(CharacterSet("\xFF").has(0xFF));
}

TEST(CharacterSet, EveryNamedSetTakesAProgramAndNoControlCharacter) {
  for (const NamedCharacterSet& row : character_sets()) {
    for (const char c : std::string("%\nO1234 G1X-1.5Y+2(NOTE),#1=[2]*3/4:")) {
      EXPECT_TRUE(row.set.has(static_cast<std::uint8_t>(c))) << row.name << " " << c;
    }
    for (const int c : {0x00, 0x0D, 0x11, 0x12, 0x13, 0x14, 0x7F, 0x80, 0xE4, 0xFF}) {
      EXPECT_FALSE(row.set.has(static_cast<std::uint8_t>(c))) << row.name << " " << c;
    }
    EXPECT_FALSE(row.source.empty());
  }
  EXPECT_FALSE(find_character_set("fanuc-iso")->has('g'));
  EXPECT_TRUE(find_character_set("fanuc-iso")->has('@'));
  EXPECT_FALSE(find_character_set("iso-core")->has('@'));
  EXPECT_TRUE(find_character_set("sinumerik")->has('g'));
  EXPECT_FALSE(find_character_set("eia"));
}

TEST(CharacterCheck, NamesLineAndColumnAcrossPieces) {
  CharacterCheck check(*find_character_set("fanuc-iso"));
  check.append(std::string("%\nO1(a)\nG"));
  check.append(std::string("1\xC3\n"));
  ASSERT_EQ(check.count(), 2U);
  EXPECT_EQ(check.found()[0].line, 2U);
  EXPECT_EQ(check.found()[0].column, 4U);
  EXPECT_EQ(check.found()[0].byte, 'a');
  EXPECT_EQ(check.found()[1].line, 3U);
  EXPECT_EQ(check.found()[1].column, 3U);
  EXPECT_EQ(check.found()[1].text_offset, 10U);
  EXPECT_EQ(check.found()[1].byte, 0xC3);
}

TEST(CharacterCheck, KeepsTheFirstAndCountsAll) {
  CharacterCheck check(*find_character_set("iso-core"));
  check.append(std::string(1000, 'a'));
  EXPECT_EQ(check.count(), 1000U);
  ASSERT_EQ(check.found().size(), CharacterCheck::kMaxReported);
  EXPECT_EQ(check.found().back().column, CharacterCheck::kMaxReported);
}

}  // namespace
}  // namespace dripfeed::tape_code
