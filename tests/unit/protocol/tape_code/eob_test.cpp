// The four forms of an end of block, written and read back.
#include "protocol/tape_code/eob.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace dripfeed::tape_code {
namespace {

std::string read(std::string_view wire) {
  EobReader reader;
  std::string text;
  for (const char c : wire) reader.put(c, text);
  reader.finish(text);
  return text;
}

TEST(Eob, HasFourForms) {
  EXPECT_EQ(characters(Eob::lf), "\n");
  EXPECT_EQ(characters(Eob::cr_lf), "\r\n");
  EXPECT_EQ(characters(Eob::lf_cr_cr), "\n\r\r");
  EXPECT_EQ(characters(Eob::cr), "\r");
  for (const Eob eob : {Eob::lf, Eob::cr_lf, Eob::lf_cr_cr, Eob::cr}) EXPECT_EQ(parse_eob(name(eob)), eob);
  for (const std::string_view own : {"CR LF LF", "1E", "LF 03", "CR CR CR CR", "0C LF"}) {
    ASSERT_TRUE(parse_eob(own)) << own;
    EXPECT_EQ(name(*parse_eob(own)), own);
  }
  EXPECT_EQ(*parse_eob("0D 0A"), Eob::cr_lf);
  // Too long, no control character, or one that means something on a line.
  for (const std::string_view wrong :
       {"", " ", "LF ", " LF", "CR LF CR LF CR", "41", "00", "11", "13", "16", "7F", "A"}) {
    EXPECT_EQ(parse_eob(wrong), std::nullopt) << wrong;
  }
  EXPECT_EQ(parse_eob("LFCRCR"), std::nullopt);
  EXPECT_EQ(parse_eob("lf"), std::nullopt);
}

TEST(Eob, EachFormCountsOnce) {
  EXPECT_EQ(read("A\nB"), "A\nB");
  EXPECT_EQ(read("A\r\nB"), "A\nB");
  EXPECT_EQ(read("A\n\r\rB"), "A\nB");
  EXPECT_EQ(read("A\rB"), "A\nB");
  EXPECT_EQ(read("A\r"), "A\n");
  EXPECT_EQ(read("A\n\r"), "A\n\n");
}

TEST(Eob, BlankBlocksStay) {
  EXPECT_EQ(read("\n\n\n"), "\n\n\n");
  EXPECT_EQ(read("\r\n\r\n\r\n"), "\n\n\n");
  EXPECT_EQ(read("\n\r\r\n\r\r\n\r\r"), "\n\n\n");
  EXPECT_EQ(read("\r\r\r"), "\n\n\n");
  EXPECT_EQ(read("\n\r\n"), "\n\n");
  EXPECT_EQ(read("\n\r\n\r\r"), "\n\n\n\n");  // LF, CR LF, CR, CR
}

TEST(Eob, WhatIsWrittenIsReadInEveryForm) {
  std::mt19937 random(7);
  for (int round = 0; round < 500; ++round) {
    std::string text;
    for (std::size_t i = random() % 30; i > 0; --i) text += random() % 3 == 0 ? '\n' : 'X';
    for (const Eob eob : {Eob::lf, Eob::cr_lf, Eob::lf_cr_cr, Eob::cr}) {
      std::string wire;
      for (const char c : text) wire += c == '\n' ? std::string(characters(eob)) : std::string(1, c);
      EXPECT_EQ(read(wire), text) << name(eob);
    }
  }
}

}  // namespace
}  // namespace dripfeed::tape_code
