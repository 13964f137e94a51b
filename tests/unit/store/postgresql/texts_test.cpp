// Texts of any bytes go to a UTF-8 database and come back.
#include "store/postgresql/texts.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace dripfeed::postgresql {
namespace {

std::string there_and_back(const std::string& text) {
  const std::string there = to_database(text).value_or(text);
  return from_database(there).value_or(there);
}

TEST(Texts, WholeUtf8GoesAsItIs) {
  for (const char* text : {"", "mill-1", "Schräge", "\xE2\x82\xAC", "\xF0\x9F\x94\xA9", "\xF4\x8F\xBB\xBF"})
    EXPECT_EQ(to_database(text), std::nullopt) << text;
}

TEST(Texts, OtherBytesStandApart) {
  EXPECT_EQ(to_database("a\xff"), "a\xF4\x8F\xBF\xBF");
  EXPECT_EQ(to_database(std::string("\0", 1)), "\xF4\x8F\xBC\x80");
  for (const char* text : {"\x80", "\xC3", "\xC0\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x82", "\xF5"}) {
    EXPECT_TRUE(to_database(text)) << "no UTF-8";
    EXPECT_EQ(there_and_back(text), text);
  }
}

TEST(Texts, AStandInOfTheTextItselfComesBack) {
  const std::string text = "\xF4\x8F\xBF\xBF and \xff";
  EXPECT_TRUE(to_database(text));
  EXPECT_EQ(there_and_back(text), text);
}

TEST(Texts, RandomBytesComeBackAndDiffer) {
  std::minstd_rand random(7);
  constexpr std::string_view kBytes("\0a\x80\xBF\xC3\xE2\x82\xAC\xF4\x8F\xBC\xFF", 12);
  for (int run = 0; run < 20'000; ++run) {
    std::string text(random() % 9, ' ');
    std::ranges::generate(text, [&] { return kBytes[random() % kBytes.size()]; });
    ASSERT_EQ(there_and_back(text), text);
  }
}

}  // namespace
}  // namespace dripfeed::postgresql
