// What two spellings of one program have in common, and what is never the same.
#include "dialects/compile/translate/meant_lines.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dialects/compile/dialect/dialect.h"

namespace dripfeed::compile {
namespace {

Meaning meant(const std::string& text, const std::string& dialect = "fanuc",
              ir::MachineKind kind = ir::MachineKind::mill) {
  const Dialect* of = find_dialect(dialect);
  const ir::Control control = of->control(kind, ir::GSystem::a);
  return meaning_of(of->read(text::Source("program", text), control), control);
}

std::vector<std::string> words(const Meaning& meaning) {
  std::vector<std::string> out;
  for (const MeantLine& line : meaning.lines) out.push_back(line.words);
  return out;
}

void expect_same(const std::string& a, const std::string& b, const std::string& dialect = "fanuc") {
  const Meaning one = meant(a, dialect);
  const Meaning other = meant(b, dialect);
  EXPECT_EQ(one.not_understood, "") << a;
  EXPECT_EQ(other.not_understood, "") << b;
  EXPECT_EQ(words(one), words(other)) << a << b;
}
void expect_other(const std::string& a, const std::string& b, const std::string& dialect = "fanuc") {
  EXPECT_NE(words(meant(a, dialect)), words(meant(b, dialect))) << a << b;
}

TEST(MeantLines, LooksDoNotCount) {
  expect_same("%\nO1\nN10 G01 X10.0 F0100.\nM30\n%\n", "%\nO1(PUMP)\n\nG1X10.(CUT)F100.000\r\n(END)\r\nN99M30\n%\n");
  expect_same("O1\n#100=1\nM30\n", "O2\n#100 = 1.0\nM30\n");
  expect_same("g1 x10 ; cut\nm30\n", "N10 G01 X10.0\nN20 M30\n", "sinumerik-840d");
  expect_same("/G1X1.F1.\nM30\n", "/1 G1 X1. F1.\nM30\n");
}

TEST(MeantLines, ValuesCount) {
  expect_other("G1X10.F100.\n", "G1X10.001F100.\n");
  expect_other("G1X10.F100.\n", "G1X-10.F100.\n");
  expect_other("G1X10.F100.\n", "G2X10.F100.\n");
  expect_other("G1X10.F100.\n", "/G1X10.F100.\n");
  expect_other("#100=1\n", "#101=1\n");
  expect_other("#100=[1+2]*3\n", "#100=1+[2*3]\n");
  expect_other("G1 X1\nG1 Y1\n", "G1 X1 Y1\n", "sinumerik-840d");
  expect_other("T=\"DRILL\"\n", "T=\"Drill\"\n", "sinumerik-840d");
}

TEST(MeantLines, APointCountsWhereItIsNotCertainWhatItIsWithout) {
  expect_other("G1X10F100.\n", "G1X10.F100.\n");
  expect_other("G65P9010A1\n", "G65P9010A1.\n");
  expect_other("G1X-10F100.\n", "G1X-10.F100.\n");
  expect_same("G1 X10 F100\n", "G1 X10. F100.\n", "sinumerik-840d");
  expect_same("G28Z0\n", "G28Z0.\n");  // nothing is nothing
}

TEST(MeantLines, AJumpMeansItsLine) {
  const std::string loop = "#1=0\nN10#1=#1+1\nIF[#1LT10]GOTO10\nM30\n";
  expect_same(loop, "#1=0\nN100#1=#1+1\nIF[#1LT10]GOTO100\nM30\n");
  expect_other(loop, "N10#1=0\n#1=#1+1\nIF[#1LT10]GOTO10\nM30\n");  // another line has the number
  expect_same("N1\nG1X1.F1.\nGOTO1\n", "N5G1X1.F1.\nGOTO5\n");      // an empty block is the next one
}

TEST(MeantLines, AShapeIsMeantByItsLines) {
  const auto turned = [](int first, int last) {
    return "O1\nG71U1.R1.\nG71P" + std::to_string(first) + "Q" + std::to_string(last) + "U0.2W0.1F0.2\nN" +
           std::to_string(first) + "G0X10.\nG1Z-10.\nN" + std::to_string(last) + "X20.\nM30\n";
  };
  const Meaning one = meant(turned(10, 20), "fanuc", ir::MachineKind::lathe);
  EXPECT_EQ(words(one), words(meant(turned(100, 200), "fanuc", ir::MachineKind::lathe)));
  EXPECT_EQ(one.numbers_matter, "");
}

TEST(MeantLines, NumbersThatAreComputedMatter) {
  EXPECT_EQ(meant("#1=10\nN10G1X1.F1.\nGOTO#1\n").numbers_matter, "line 3");
  EXPECT_EQ(meant("N10G1X1.F1.\nN10G1X2.\nGOTO10\n").numbers_matter, "line 3");  // two blocks have it
  EXPECT_EQ(meant("N10G1X1.F1.\nGOTO10\n").numbers_matter, "");
}

TEST(MeantLines, NamesOfCallsAreExact) {
  expect_other("L100\nM30\n", "L0100\nM30\n", "sinumerik-840d");  // two programs there
  expect_same("M98P0100\nM30\n", "M98P100\nM30\n");
}

TEST(MeantLines, WhatIsNotUnderstoodIsReported) {
  EXPECT_NE(meant("G1X1.F1.\nG1X[1+\nM30\n").not_understood, "");
  EXPECT_TRUE(meant("G1X1.F1.\nG1X[1+\nM30\n").not_understood.starts_with("line 2: "));
  EXPECT_NE(meant("G1 X1\nUNHEARD_OF X=\nM30\n", "sinumerik-840d").not_understood, "");
}

}  // namespace
}  // namespace dripfeed::compile
