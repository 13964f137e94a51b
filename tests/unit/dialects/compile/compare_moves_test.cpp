// Two programs are run and their moves compared with each other; what no run shows is never passed over.
#include "dialects/compile/translate/compare_moves.h"

#include <string>

#include <gtest/gtest.h>

#include "dialects/compile/dialect/dialect.h"

namespace dripfeed::compile {
namespace {

struct Opened {
  Opened(const std::string& text, const ir::Control& of)
      : control(of),
        read(find_dialect(of.dialect)->read(text::Source("program", text), control)),
        meaning(meaning_of(read, control)),
        library(control, [](std::string_view) { return std::nullopt; }) {}
  ir::Control control;
  ir::ReadResult read;
  Meaning meaning;
  ProgramLibrary library;
};

MovesAnswer held(const std::string& a, const std::string& b, const std::string& dialect = "fanuc",
                 ir::MachineKind kind = ir::MachineKind::mill) {
  const ir::Control control = find_dialect(dialect)->control(kind, ir::GSystem::a);
  Opened first("O1\nG21 G17 G90 G94 G54\n" + a + "\nM30\n", control);
  Opened second("O2\nG21 G17 G90 G94 G54\n" + b + "\nM30\n", control);
  return compare_moves({first.read.program, control, first.meaning, first.library},
                       {second.read.program, control, second.meaning, second.library}, {});
}

void expect_equal(const std::string& a, const std::string& b) {
  const MovesAnswer answer = held(a, b);
  EXPECT_EQ(answer.why, "") << a;
  EXPECT_TRUE(answer.equal) << answer.first << " | " << answer.second;
  EXPECT_EQ(answer.deviation_mm, 0.0);
}

TEST(CompareMoves, TheSameMovesByAnotherText) {
  expect_equal("G0X0Y0\nG1X10.F100.", "G0X0Y0\n#1=5\nG1X[#1*2]F100.");
  expect_equal("G0X0Y0\nG1X10.F100.\nX20.", "G0X0Y0\nG1X10.F100.\nG91X10.\nG90");
  expect_equal("G0X0Y0\nG1X10.F100.\nX20.\nX30.", "G0X0Y0F100.\n#1=1\nWHILE[#1LE3]DO1\nG1X[#1*10]\n#1=#1+1\nEND1");
  expect_equal("G0X0Y0\nG1X10.F100.", "G0X0Y0\nG1X10.F100.\nX10.");  // it is there already
}

TEST(CompareMoves, TheFirstDifferenceHasItsLines) {
  const MovesAnswer answer = held("G0X0Y0\nG1X10.F100.\nX20.\nX30.", "(A)\nG0X0Y0\nG1X10.F100.\nX20.5\nX29.");
  EXPECT_EQ(answer.why, "");
  EXPECT_FALSE(answer.equal);
  EXPECT_EQ(answer.moves, 2U);
  EXPECT_EQ(answer.first_line, 5U);
  EXPECT_EQ(answer.second_line, 6U);
  EXPECT_EQ(answer.first, "line X20. F100");
  EXPECT_EQ(answer.second, "line X20.5 F100");
  EXPECT_DOUBLE_EQ(answer.deviation_mm.value_or(-1), 1.0);  // not of the first, but of the largest
}

TEST(CompareMoves, ADiameterDeviatesByHalf) {
  const MovesAnswer answer = held("G0X0Z0\nG1X10.F.1", "G0X0Z0\nG1X11.F.1", "fanuc", ir::MachineKind::lathe);
  EXPECT_DOUBLE_EQ(answer.deviation_mm.value_or(-1), 0.5) << answer.why;
}

TEST(CompareMoves, MoreMovesHaveNoDeviation) {
  const MovesAnswer answer = held("G0X0Y0\nG1X10.F100.", "G0X0Y0\nG1X10.F100.\nX20.");
  EXPECT_FALSE(answer.equal);
  EXPECT_EQ(answer.first, "nothing more");
  EXPECT_EQ(answer.first_line, 0U);
  EXPECT_EQ(answer.deviation_mm, std::nullopt);
}

TEST(CompareMoves, StatesCount) {
  for (const char* other :
       {"G0X0Y0\nG1X10.F200.", "G0X0Y0\nM8\nG1X10.F100.", "G0X0Y0\nS500M3\nG1X10.F100.", "G0X0Y0\nG43H1\nG1X10.F100.",
        "G0X0Y0\nG9G1X10.F100.", "T1M6\nG0X0Y0\nG1X10.F100.", "G55\nG0X0Y0\nG1X10.F100.", "G0X0Y0\nM0\nG1X10.F100.",
        "G0X0Y0\nG4P1000\nG1X10.F100.", "G0X0Y0\nG1X10.F100.\n/X11."}) {
    const MovesAnswer answer = held("G0X0Y0\nG1X10.F100.", other);
    EXPECT_EQ(answer.why, "") << other;
    EXPECT_FALSE(answer.equal) << other;
  }
}

TEST(CompareMoves, WhatNoRunShowsMustBeTheSame) {
  expect_equal("G28Z0\nM150\nG0X0Y0\nG10L2P1X5.\n#5221=1.", "N10G28Z0.\nM150(X)\nG0X0Y0\nG10L2P1X5.0\n#5221=1");
  const std::string moves = "G0X0Y0\n";
  for (const char* more : {"M150", "G28X0", "G10L2P1X5.", "#5221=1.", "G92X5."}) {
    const MovesAnswer answer = held(moves, moves + more);
    EXPECT_NE(answer.why, "") << more;
    EXPECT_FALSE(answer.equal) << more;
  }
  EXPECT_NE(held(moves + "M150", moves + "M151").why, "");
  EXPECT_NE(held(moves + "G10L2P1X5.", moves + "G10L2P1X6.").why, "");
}

TEST(CompareMoves, ValuesFromOutsideAreNotCompared) {
  for (const char* text :
       {"G1X#500F100.", "G1X10.F100.\nM98P1234", "#1=#500\n#5221=#1", "#1=1.\n#5221=#1", "G1X[#1+\nF100."}) {
    const MovesAnswer answer = held(text, text);
    EXPECT_NE(answer.why, "") << text;
    EXPECT_FALSE(answer.equal) << text;
  }
}

}  // namespace
}  // namespace dripfeed::compile
