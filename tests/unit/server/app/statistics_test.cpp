// What a text amounts to, by tools.
#include "server/app/checks/statistics.h"

#include <numeric>

#include <gtest/gtest.h>

#include "tests/unit/server/app/whole_shop.h"

namespace dripfeed::app {
namespace {

const std::string kTwoTools =
    "%\nO1\nG21 G90 G94 G17 G54\nT1 M6\nG0 X0 Y0 Z5.\nG1 Z-1. F100.\nX10. F200.\nG0 Z5.\n"
    "T2 M6\nG1 X20. F100.\nT1 M6\nG0 X0.\nM30\n%\n";

TEST(Statistics, ByToolsInTheOrderOfTheProgram) {
  const auto done = statistics_of({.dialect = "fanuc", .text = kTwoTools}, test::PlainDocuments(), {});
  ASSERT_TRUE(done);
  EXPECT_EQ(done->lines, 14U);
  EXPECT_EQ(done->bytes, kTwoTools.size());
  EXPECT_FALSE(done->time_s);
  EXPECT_NE(done->why_no_time, "");
  ASSERT_EQ(done->path.tools.size(), 3U);
  EXPECT_EQ(done->path.tools[1].name, "T1");
  EXPECT_EQ(done->path.tools[1].first_line, 4U);
  EXPECT_DOUBLE_EQ(done->path.tools[1].cut_mm, 16.0);
  EXPECT_EQ(done->path.tools[2].name, "T2");
  EXPECT_DOUBLE_EQ(done->path.tools[2].cut_mm, 10.0);
  EXPECT_DOUBLE_EQ(done->path.tools[1].cut_mm + done->path.tools[2].cut_mm, done->path.cut_mm);
  EXPECT_DOUBLE_EQ(done->path.tools[1].rapid_mm, done->path.rapid_mm);
}

TEST(Statistics, ATextOfNothing) {
  const auto done = statistics_of({.dialect = "fanuc", .text = ""}, test::PlainDocuments(), {});
  ASSERT_TRUE(done);
  EXPECT_EQ(done->lines, 0U);
  EXPECT_EQ(done->path.cut_mm, 0.0);
}

}  // namespace
}  // namespace dripfeed::app
