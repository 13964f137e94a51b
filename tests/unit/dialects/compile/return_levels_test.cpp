// RET over several programs. Oracle: the places that the programs name.
#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/sinumerik_run.h"

namespace dripfeed::compile::test {
namespace {

std::vector<double> places(const Result& played) {
  std::vector<double> out;
  for (const ir::Motion& m : moves_of(played.motions)) out.push_back(m.end[0]);
  return out;
}

const Texts kPrograms = {{"SUB1", "PROC SUB1\nSUB2\nG0 X5\nM17\n"}};

Texts with(std::string end) {
  Texts programs = kPrograms;
  programs["SUB2"] = "PROC SUB2\nG0 X3\n" + end + "\n";
  return programs;
}

const std::string kMain = "G17 G71 G90 G94\nG0 X0 Y0 Z0\nSUB1\nG0 X9\nLATER: G0 X11\nM30\n";

TEST(ReturnLevels, OneIsTheCaller) {
  EXPECT_EQ(places(run(kMain, with("RET"))), (std::vector<double>{0, 3, 5, 9, 11}));
  EXPECT_EQ(places(run(kMain, with("RET(,,1)"))), (std::vector<double>{0, 3, 5, 9, 11}));
}

TEST(ReturnLevels, TwoIsTheCallersCaller) {
  const Result played = run(kMain, with("RET(,,2)"));
  EXPECT_EQ(places(played), (std::vector<double>{0, 3, 9, 11}));
  EXPECT_TRUE(played.result.not_interpreted.empty());
}

TEST(ReturnLevels, ToALabelThere) {
  EXPECT_EQ(places(run(kMain, with("RET(\"LATER\",,2)"))), (std::vector<double>{0, 3, 11}));
}

// What else RET can do is told, and the program is left.
TEST(ReturnLevels, OtherFormsAreTold) {
  const Result played = run(kMain, with("RET(\"LATER\",1,1)"));
  EXPECT_TRUE(played.names("RET"));
  EXPECT_EQ(places(played), (std::vector<double>{0, 3, 5, 9, 11}));
}

}  // namespace
}  // namespace dripfeed::compile::test
