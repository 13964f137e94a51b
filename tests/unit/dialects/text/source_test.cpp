// Lines as the controls count them, and columns in bytes and in characters.
#include "dialects/text/source.h"

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace dripfeed::text {
namespace {

TEST(Source, CountsEachKindOfEobOnce) {
  const Source source("a.nc", "N1\nN2\r\nN3\rN4\n\r\rN5");
  EXPECT_EQ(source.line_count(), 5U);
  EXPECT_EQ(source.line(1), "N1");
  EXPECT_EQ(source.line(2), "N2");
  EXPECT_EQ(source.line(3), "N3");
  EXPECT_EQ(source.line(4), "N4");
  EXPECT_EQ(source.line(5), "N5");
}

TEST(Source, KnowsTheLengthOfAnEob) {
  EXPECT_EQ(eob_length("\n\r\r", 0), 3U);
  EXPECT_EQ(eob_length("\n\r", 0), 1U);  // LF, then a CR of its own
  EXPECT_EQ(eob_length("\r\n", 0), 2U);
  EXPECT_EQ(eob_length("\r\r", 0), 1U);
  EXPECT_EQ(eob_length("X", 0), 0U);
  EXPECT_EQ(eob_length("X", 1), 0U);
  EXPECT_EQ(eob_length("X", 9), 0U);
}

TEST(Source, OpensNoLineAfterTheLastEob) {
  EXPECT_EQ(Source("a", "N1\nN2\n").line_count(), 2U);
  EXPECT_EQ(Source("a", "N1\n\n").line_count(), 2U);
  EXPECT_EQ(Source("a", "").line_count(), 1U);
  EXPECT_EQ(Source("a", "\n").line_count(), 1U);
}

// Each line of a longer text, by the lines themselves.
TEST(Source, FindsEachOfManyLines) {
  constexpr std::string_view kEnds[] = {"\n", "\r\n", "\r", "\n\r\r"};
  for (const std::uint32_t lines : {15U, 16U, 17U, 32U, 33U, 200U}) {
    std::string all;
    std::vector<std::uint32_t> starts;
    for (std::uint32_t n = 1; n <= lines; ++n) {
      starts.push_back(static_cast<std::uint32_t>(all.size()));
      // A CR after an LF ends a line of its own, and two of them belong to it: X keeps ends apart.
      all += "X" + std::to_string(n) + std::string(kEnds[n % 4]);
    }
    const Source source("a", all);
    EXPECT_EQ(source.line_count(), lines);
    for (std::uint32_t n = 1; n <= lines; ++n) {
      EXPECT_EQ(source.line(n), "X" + std::to_string(n));
      for (std::uint32_t k = starts[n - 1]; k < (n < lines ? starts[n] : all.size()); ++k) {
        EXPECT_EQ(source.position(k).line, n) << k;
        EXPECT_EQ(source.position(k).column, k - starts[n - 1] + 1) << k;
      }
    }
    EXPECT_EQ(source.line(lines + 1), "");
    EXPECT_EQ(source.line(lines + 100), "");
  }
}

TEST(Source, GivesNoTextForALineThatIsNotThere) {
  const Source source("a", "N1\nN2");
  EXPECT_EQ(source.line(0), "");
  EXPECT_EQ(source.line(3), "");
}

TEST(Source, CountsColumnsInBytesAndCharacters) {
  const Source source("a",
                      "G1\n\xD0\x9C"
                      "30 X1");  // a Cyrillic letter of two bytes
  const Position after = source.position(5);
  EXPECT_EQ(after.line, 2U);
  EXPECT_EQ(after.column, 3U);
  EXPECT_EQ(after.column_chars, 2U);
  const Position start = source.position(0);
  EXPECT_EQ(start.line, 1U);
  EXPECT_EQ(start.column, 1U);
}

TEST(Source, PlacesAnOffsetAfterTheEndInTheLastLine) {
  const Source source("a", "G1\nX1");
  const Position end = source.position(5);
  EXPECT_EQ(end.line, 2U);
  EXPECT_EQ(end.column, 3U);
}

TEST(Source, KeepsItsTextWhenItIsCopiedAndMoved) {
  Source source("a", std::string(100, 'X'));
  const Source copy = source;
  const char* const before = source.text().data();
  const Source moved = std::move(source);
  EXPECT_EQ(copy.text().data(), before);
  EXPECT_EQ(moved.text().data(), before);
}

}  // namespace
}  // namespace dripfeed::text
