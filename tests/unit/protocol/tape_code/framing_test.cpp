// Framings as text, their bits, and what the eighth bit carries.
#include "protocol/tape_code/framing.h"

#include <gtest/gtest.h>

namespace dripfeed::tape_code {
namespace {

TEST(Framing, ReadsAndWritesEveryOne) {
  for (const char* text : {"7E1", "7E2", "7O1", "7O2", "7N1", "7N2", "8N1", "8N2", "8E1", "8E2", "8O1", "8O2"}) {
    const auto framing = parse_framing(text);
    ASSERT_TRUE(framing) << text;
    EXPECT_EQ(format_framing(*framing), text);
  }
  EXPECT_EQ(parse_framing("7e2"), parse_framing("7E2"));
}

TEST(Framing, CountsTheBitsOfACharacter) {
  EXPECT_EQ(parse_framing("7E2")->bits_per_char(), 11);
  EXPECT_EQ(parse_framing("7E1")->bits_per_char(), 10);
  EXPECT_EQ(parse_framing("7N1")->bits_per_char(), 9);
  EXPECT_EQ(parse_framing("8N1")->bits_per_char(), 10);
  EXPECT_EQ(parse_framing("8N2")->bits_per_char(), 11);
  EXPECT_EQ(parse_framing("8E1")->bits_per_char(), 11);
}

TEST(Framing, RefusesTheRestByName) {
  EXPECT_EQ(parse_framing("").error(), FramingError::length);
  EXPECT_EQ(parse_framing("8N").error(), FramingError::length);
  EXPECT_EQ(parse_framing("8N15").error(), FramingError::length);
  EXPECT_EQ(parse_framing("6N1").error(), FramingError::data_bits);
  EXPECT_EQ(parse_framing("8X1").error(), FramingError::parity);
  EXPECT_EQ(parse_framing("8N0").error(), FramingError::stop_bits);
  EXPECT_EQ(parse_framing("8N3").error(), FramingError::stop_bits);
  EXPECT_FALSE(message(FramingError::stop_bits).empty());
}

TEST(Framing, SaysWhatTheEighthBitCarries) {
  const auto software = [](const char* text, Code code = Code::ascii) {
    return eighth_bit(*parse_framing(text), code, ParityBy::software);
  };
  EXPECT_EQ(software("7E2"), EighthBit::even);
  EXPECT_EQ(software("7O1"), EighthBit::odd);
  EXPECT_EQ(software("7N1"), EighthBit::clear);
  EXPECT_EQ(software("8N1"), EighthBit::data);
  EXPECT_EQ(software("8N1", Code::iso), EighthBit::even);
  EXPECT_EQ(eighth_bit(*parse_framing("7E2"), Code::ascii, ParityBy::uart), EighthBit::clear);
  EXPECT_EQ(eighth_bit(*parse_framing("8N1"), Code::iso, ParityBy::uart), EighthBit::even);
}

}  // namespace
}  // namespace dripfeed::tape_code
