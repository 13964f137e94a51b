// Block numbers change, what names them follows, and what cannot be followed refuses it.
#include "dialects/compile/renumber/renumber.h"

#include <string>

#include <gtest/gtest.h>

#include "dialects/compile/dialect/dialect.h"

namespace dripfeed::compile {
namespace {

Renumbered numbered(const std::string& text, Numbering numbering = Numbering::numbered,
                    const std::string& dialect = "fanuc", std::uint32_t step = 10) {
  const text::Source source("program", text);
  return renumber({.source = source,
                   .control = find_dialect(dialect)->infer_control(source),
                   .numbering = numbering,
                   .first = 10,
                   .step = step});
}

std::string why(const Renumbered& made) {
  std::string out;
  for (const RenumberRefusal& one : made.refused) out += std::to_string(one.line) + ": " + one.text + "\n";
  return out;
}

TEST(Renumber, JumpsFollow) {
  const Renumbered made =
      numbered("%\nO1\n#1=0\nN7 G0 X0\nIF[#1GT100]GOTO 0100\n#1=#1+1\nN3(NEXT)\nGOTO7\nN100 G0 Z7.\nM30\n%\n");
  EXPECT_EQ(why(made), "");
  EXPECT_EQ(made.text, "%\nO1\n#1=0\nN10 G0 X0\nIF[#1GT100]GOTO 30\n#1=#1+1\nN20(NEXT)\nGOTO10\nN30 G0 Z7.\nM30\n%\n");
  EXPECT_EQ(made.numbers, 3U);
  EXPECT_EQ(made.references, 2U);
}

TEST(Renumber, EveryBlockGetsANumber) {
  const Renumbered made =
      numbered("%\nO1(HEAD)\n\n(TOOL)\nG21 G17 G90 G94\n/2 T5 M6\nN4M3\n#1=2\nM30\n%\n", Numbering::all, "fanuc", 5);
  EXPECT_EQ(made.text, "%\nO1(HEAD)\n\n(TOOL)\nN10 G21 G17 G90 G94\n/2 N15 T5 M6\nN20M3\nN25 #1=2\nN30 M30\n%\n");
}

TEST(Renumber, OnlyNamedBlocksKeepTheirs) {
  const Renumbered made = numbered("%\nO1\nN1 #1=1\nN2 G0 X0\nN3 GOTO2\nN4\nN5 M30\n%\n", Numbering::none);
  EXPECT_EQ(made.text, "%\nO1\n#1=1\nN10 G0 X0\nGOTO10\n\nM30\n%\n");
}

TEST(Renumber, EachProgramOfATextBeginsAgain) {
  const Renumbered made = numbered("%\nO1\nN1 GOTO5\nN5 M98P2\nM30\nO2\nN1 #1=#1+1\nIF[#1LT3]GOTO1\nM99\n%\n");
  EXPECT_EQ(made.text, "%\nO1\nN10 GOTO20\nN20 M98P2\nM30\nO2\nN10 #1=#1+1\nIF[#1LT3]GOTO10\nM99\n%\n");
  EXPECT_TRUE(made.assumptions.empty());
  EXPECT_EQ(numbered("%\nO1\nN1 M98P9\nM30\n%\n").assumptions.size(), 1U);
}

TEST(Renumber, TheContourOfATurningCycleFollows) {
  const Renumbered made = numbered(
      "%\nO1\nN1 T0101\nG0 X50. Z2.\nG71 U2. R1.\nG71 P20 Q21 U0.5 W0.1 F0.2\nN20 G0 X20.\nG1 Z-21.\nN21 X50.\nG70 P20 "
      "Q0021\nM30\n%\n");
  EXPECT_EQ(why(made), "");
  EXPECT_EQ(made.text,
            "%\nO1\nN10 T0101\nG0 X50. Z2.\nG71 U2. R1.\nG71 P20 Q30 U0.5 W0.1 F0.2\nN20 G0 X20.\nG1 Z-21.\nN30 "
            "X50.\nG70 P20 Q30\nM30\n%\n");
}

TEST(Renumber, SinumerikJumpsAndRepetitionsFollow) {
  const Renumbered made =
      numbered("N1 R1=0\nN5 ANF: R1=R1+1\nN7 G0 X=R1\nREPEAT N7 N8 P=2\nN8 IF R1<3 GOTOB N1\nGOTOF ENDE\nENDE: M30\n",
               Numbering::numbered, "sinumerik-840d");
  EXPECT_EQ(why(made), "");
  EXPECT_EQ(made.text.substr(0, made.text.find('\n')), "N10 R1=0");
  EXPECT_NE(made.text.find("GOTOB N10\n"), std::string::npos) << made.text;
  EXPECT_NE(made.text.find("REPEAT N"), std::string::npos) << made.text;
  EXPECT_NE(made.text.find("GOTOF ENDE"), std::string::npos);
}

TEST(Renumber, WhatCannotBeFollowedRefuses) {
  struct Case {
    const char* text;
    const char* word;
    const char* dialect = "fanuc";
  };
  const Case cases[] = {
      {"%\nO1\nN1 #1=1\nGOTO#1\nM30\n%\n", "4: its target is calculated"},
      {"%\nO1\nN1 G0 X0\nM99 P1\n%\n", "calling program's"},
      {"%\nO1\nN1 GOTO9\nM30\n%\n", "which no block has"},
      {"%\nO1\nN1 GOTO2\nN2 G0 X0\nN2 G0 X1.\nM30\n%\n", "which several blocks have"},
      {"%\nO1\nN1 G0 X[\nM30\n%\n", "the line has an error"},
      {"N10 R1=1\nN20 GOTO \"N\"<<R1\nM30\n", "", "sinumerik-840d"},
      {"N10 G0 X0\nCYCLE95(\"N10:N20\",1,0,0,0,1,1,1,9,0,0,0)\nN20 X1\nM30\n", "may name a block", "sinumerik-840d"},
  };
  for (const Case& one : cases) {
    const Renumbered made = numbered(one.text, Numbering::numbered, one.dialect);
    EXPECT_FALSE(made.refused.empty()) << one.text;
    EXPECT_TRUE(made.text.empty()) << one.text;
    EXPECT_NE(why(made).find(one.word), std::string::npos) << one.text << why(made);
  }
}

TEST(Renumber, NumbersThatAreTooHighRefuse) {
  std::string text = "%\nO1\n";
  for (int i = 0; i < 11; ++i) text += "G1 X1.\n";
  EXPECT_NE(why(numbered(text + "M30\n%\n", Numbering::all, "fanuc", 9'999)).find("smaller step"), std::string::npos);
}

}  // namespace
}  // namespace dripfeed::compile
