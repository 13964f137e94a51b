// Names of received programs by the controls' methods, and the parts of a punch.
#include "protocol/receive/program_name.h"

#include <gtest/gtest.h>

namespace dripfeed::receive {
namespace {

struct Case {
  std::string_view text;
  std::string_view style;
  std::string_view name;
};

TEST(ProgramName, FollowsTheTableOfControls) {
  const Case cases[] = {
      {"%\nO1234(SHAFT)\nM30\n%\n", "number", "O1234"},
      {"%\n:0042\nM30\n%\n", "number", "O0042"},
      {"%\nO12345678\n", "number", "O12345678"},
      {"$O1234.MIN%\nG0\n%\n", "okuma", "O1234"},
      {"$SHAFT.MIN%\nG0\n%\n", "okuma", "SHAFT"},
      {"%_N_SHAFT1_MPF\n;$PATH=/_N_MPF_DIR\n", "sinumerik", "SHAFT1_MPF"},
      {"%PART7,MX,\nG0\n", "fagor", "PART7"},
      {"0 BEGIN PGM 4711 MM\n1 L X+1\n", "heidenhain", "4711"},
      {"%MPF123\nG0\nM30\n", "header", "MPF123"},
      {"%1234\nG0\nM30\n", "header", "1234"},
      {"%\n<SHAFT-A>\nG0\n%\n", "angle", "SHAFT-A"},
      {"%\n(HOUSING LEFT)\nG0\n%\n", "comment", "HOUSING LEFT"},
      {"; flange\nG0 X1\n", "comment", "flange"},
      {"G0 X1 (MOVE)\n", "comment", "MOVE"},
  };
  for (const Case& one : cases) {
    const auto found = find_name(one.text);
    ASSERT_TRUE(found) << one.text;
    EXPECT_EQ(name(found->style), one.style) << one.text;
    EXPECT_EQ(found->name, one.name) << one.text;
  }
  EXPECT_FALSE(find_name("%\nG0 X1\nM30\n%\n"));
  EXPECT_FALSE(find_name("%\nOFF\nM30\n%\n")) << "O without a number";
  EXPECT_FALSE(find_name(""));
  EXPECT_EQ(find_name("%_N_A_MPF\n;$PATH=/_N_WKS_DIR/_N_B_WPD\n")->path, "/_N_WKS_DIR/_N_B_WPD");
}

TEST(ProgramName, IsLookedForInTheFirstLinesOnly) {
  std::string text = "%\n";
  for (int i = 0; i < 12; ++i) text += "G0X1\n";
  EXPECT_FALSE(find_name(text + "O77\nM30\n%\n"));
}

TEST(SplitPrograms, PartsAtNumbersAndHeaders) {
  EXPECT_EQ(split_programs("%\nO1\nM30\n%\n"), (std::vector<std::string>{"%\nO1\nM30\n%\n"}));
  EXPECT_EQ(split_programs("%\nO1(A)\nM98P2\nM30\nO2\nM99\n%\n"),
            (std::vector<std::string>{"%\nO1(A)\nM98P2\nM30\n%\n", "%\nO2\nM99\n%\n"}));
  EXPECT_EQ(split_programs("%\n(BATCH)\nO1\nM30\n:2\nM99\n%\n"),
            (std::vector<std::string>{"%\n(BATCH)\nO1\nM30\n%\n", "%\n:2\nM99\n%\n"}));
  EXPECT_EQ(split_programs("%_N_A_MPF\nM30\n%_N_B_SPF\nM17\n"),
            (std::vector<std::string>{"%_N_A_MPF\nM30\n", "%_N_B_SPF\nM17\n"}));
  EXPECT_EQ(split_programs("G0 X1\n"), (std::vector<std::string>{"G0 X1\n"}));
  EXPECT_EQ(split_programs("%\nO1\nM30\n%\n\n%\nO2\nM30\n%\n"),
            (std::vector<std::string>{"%\nO1\nM30\n%\n", "%\nO2\nM30\n%\n"}));
  const std::string with_more = "%\nO1\nM30\nO2\nM30\n%\nTOOL LIST\n";
  EXPECT_EQ(split_programs(with_more), (std::vector<std::string>{with_more}));
  std::string marks;  // each is looked at once
  for (int i = 0; i < 1'000'000; ++i) marks += "%\n";
  EXPECT_EQ(split_programs(marks).size(), 1U);
}

}  // namespace
}  // namespace dripfeed::receive
