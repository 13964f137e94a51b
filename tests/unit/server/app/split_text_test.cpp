// Files with several programs, as controls and editors write them.
#include "server/app/library/split_text.h"

#include <gtest/gtest.h>

namespace dripfeed::app {
namespace {

TEST(SplitText, KeepsTheLineEndsOfTheFile) {
  const auto programs = split_text("%\r\nO0001(HOUSING)\r\nM98P2\r\nM30\r\nO0002\r\nM99\r\n%\r\n");
  ASSERT_EQ(programs.size(), 2U);
  EXPECT_EQ(programs[0].name, "O0001");
  EXPECT_EQ(programs[0].comment, "HOUSING");
  EXPECT_EQ(programs[0].text, "%\r\nO0001(HOUSING)\r\nM98P2\r\nM30\r\n%\r\n");
  EXPECT_EQ(programs[1].name, "O0002");
  EXPECT_EQ(programs[1].comment, "");
  EXPECT_EQ(programs[1].text, "%\r\nO0002\r\nM99\r\n%\r\n");
}

TEST(SplitText, LeavesOneProgramAsItIs) {
  for (const char* text : {"", "M30", "%\nO1\nM30\n%\n", "%\n\rO1\r\nM30\n%", "%\nO1\nM30\nO2\nM99\n%\nof 1998\n"}) {
    const auto programs = split_text(text);
    ASSERT_EQ(programs.size(), 1U) << text;
    EXPECT_EQ(programs[0].text, text);
  }
}

TEST(SplitText, PartsAnArchiveAtItsHeaders) {
  const auto programs = split_text("%_N_SHAFT_MPF\n;$PATH=/_N_MPF_DIR\nM30\n%_N_GROOVE_SPF\nM17\n");
  ASSERT_EQ(programs.size(), 2U);
  EXPECT_EQ(programs[1].name, "GROOVE_SPF");
  EXPECT_EQ(programs[1].text, "%_N_GROOVE_SPF\nM17\n");
}

}  // namespace
}  // namespace dripfeed::app
