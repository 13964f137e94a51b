// Multiple repetitive cycles: the passes by the formulas of the cycle, computed here, and the shape left untouched.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

struct Move {
  char kind;  // r, f, t (thread), a (arc)
  double x;
  double z;
};

std::vector<Move> cut(const std::string& blocks, interpreter::Ended ended = interpreter::Ended::end,
                      std::string* fault = nullptr) {
  const ir::Control lathe = control("fanuc", ir::MachineKind::lathe);
  const text::Source source("program", "%\nO1\nG21 G99 G18\n" + blocks + "M30\n%\n");
  const ir::ReadResult read = find_dialect("fanuc")->read(source, lathe);
  EXPECT_FALSE(text::has_error(read.diagnostics)) << messages_of(read.diagnostics, source);
  Motions motions;
  const interpreter::RunResult result = execute(read.program, lathe, nullptr, motions, {});
  EXPECT_EQ(result.ended, ended);
  if (fault != nullptr && !result.diagnostics.empty())
    *fault = result.diagnostics.back().diagnostic.alarm + " " + text::message_of(result.diagnostics.back().diagnostic);
  std::vector<Move> moves;
  for (const ir::Motion& m : motions.all) {
    if (!ir::is_move(m.kind)) continue;
    const char kind = m.kind == ir::MotionKind::rapid    ? 'r'
                      : m.kind == ir::MotionKind::linear ? 'f'
                      : m.kind == ir::MotionKind::thread ? 't'
                                                         : 'a';
    moves.push_back({kind, m.end[0], m.end[2]});
  }
  return moves;
}

void expect_moves(const std::vector<Move>& actual, const std::vector<Move>& expected) {
  for (std::size_t i = 0; i < std::min(actual.size(), expected.size()); ++i) {
    EXPECT_EQ(actual[i].kind, expected[i].kind) << i;
    EXPECT_NEAR(actual[i].x, expected[i].x, 1e-9) << i;
    EXPECT_NEAR(actual[i].z, expected[i].z, 1e-9) << i;
  }
  EXPECT_EQ(actual.size(), expected.size());
}

// The last cut follows the shape with its chamfer from X38 to X40 and its fillet to X44, as G70 does.
TEST(Repetitive, TheCornersOfTheShapeAreCut) {
  const std::vector<Move> actual =
      cut("G00 X64. Z2.\nG71 U22. R1.\nG71 P10 Q20 U0. W0. F0.3\n"
          "N10 G00 X20.\nG01 Z-10. F0.1\nX40. ,C1.\nZ-20. ,R2.\nX60.\nN20 Z-30.\nG70 P10 Q20\n");
  const std::vector<Move> shape = {{'f', 20, -10}, {'f', 38, -10}, {'f', 40, -11}, {'f', 40, -18},
                                   {'a', 44, -20}, {'f', 60, -20}, {'f', 60, -30}};
  std::vector<Move> expected = {{'r', 64, 2}, {'r', 20, 2}};
  for (int pass = 0; pass < 2; ++pass) {
    expected.insert(expected.end(), shape.begin(), shape.end());
    expected.push_back({'r', 64, 2});
    if (pass == 0) expected.push_back({'r', 20, 2});
  }
  expect_moves(actual, expected);
}

// A cone from X20 Z0 to X60 Z-40: at diameter x it lies at z = -(x - 20), with 0.2 (radius) and 0.1 left on it.
TEST(Repetitive, RoughingStopsAtTheShapeWithItsAllowances) {
  const std::vector<Move> actual =
      cut("G00 X64. Z2.\nG71 U5. R1.\nG71 P10 Q20 U0.4 W0.1 F0.3\n"
          "N10 G00 X20.\nG01 Z0. F0.1\nN20 X60. Z-40.\nG00 X100.\n");
  std::vector<Move> expected = {{'r', 64, 2}};
  const double deepest = 10.0 + 0.2;  // radius of A' with the allowance
  for (int n = 1; 32.0 - 5.0 * n > deepest; ++n) {
    const double r = 32.0 - 5.0 * n;
    const double z = r > 30.2 ? -39.9 : -(2.0 * (r - 0.2) - 20.0) + 0.1;
    expected.push_back({'r', 2 * r, 2});
    expected.push_back({'f', 2 * r, z});
    expected.push_back({'f', 2 * (r + 1), z + 1});
    expected.push_back({'r', 2 * (r + 1), 2});
  }
  const std::vector<Move> shape = {{'r', 20.4, 2.1}, {'f', 20.4, 0.1}, {'f', 60.4, -39.9}, {'r', 64, 2}, {'r', 100, 2}};
  expected.insert(expected.end(), shape.begin(), shape.end());
  expect_moves(actual, expected);
}

// A quarter circle of radius 10 about X40 Z-10 (concave corner from X20 Z-10... to X40 Z-20).
TEST(Repetitive, RoughingMeetsArcsWhereTheyAre) {
  const std::vector<Move> actual =
      cut("G00 X44. Z2.\nG71 U2. R0.5\nG71 P10 Q20 U0. W0. F0.3\n"
          "N10 G00 X20.\nG01 Z-10. F0.1\nN20 G02 X40. Z-20. R10.\n");
  int passes = 0;
  for (std::size_t i = 0; i + 1 < actual.size(); ++i) {
    if (actual[i].kind != 'f' || actual[i - 1].kind != 'r' || actual[i].x != actual[i - 1].x) continue;
    const double r = actual[i].x / 2.0;
    if (r <= 10.0) continue;  // the pass along the shape
    ++passes;
    const double z = r >= 20.0 ? -20.0 : -10.0 - std::sqrt(100.0 - (20.0 - r) * (20.0 - r));
    EXPECT_NEAR(actual[i].z, z, 1e-9) << r;
  }
  EXPECT_EQ(passes, 5);  // radii 20, 18, 16, 14, 12
}

TEST(Repetitive, FinishingRunsTheShapeAndGoesBack) {
  const std::vector<Move> actual =
      cut("G00 X64. Z2.\nG71 U20. R1.\nG71 P10 Q20 U0. W0. F0.3\nN10 G00 X20.\nG01 Z0. F0.1\n"
          "N20 X60. Z-40.\nG70 P10 Q20\nG00 X100.\n");
  const std::vector<Move> tail(actual.end() - 5, actual.end());
  expect_moves(tail, {{'r', 20, 2}, {'f', 20, 0}, {'f', 60, -40}, {'r', 64, 2}, {'r', 100, 2}});
}

TEST(Repetitive, FacingHasTheAxesExchanged) {
  // The face rises from Z-20 at X60 to Z0 at X20: z = (20 - x)/2.
  const std::vector<Move> actual =
      cut("G00 X64. Z2.\nG72 W4. R1.\nG72 P10 Q20 U0. W0. F0.3\n"
          "N10 G00 Z-20.\nG01 X60. F0.1\nN20 X20. Z0.\n");
  std::vector<Move> expected = {{'r', 64, 2}};
  for (int n = 1; 2 - 4 * n > -20; ++n) {
    const double z = 2.0 - 4.0 * n;
    const double x = z > 0.0 ? 20.0 : 20.0 - 2.0 * z;
    expected.push_back({'r', 64, z});
    expected.push_back({'f', x, z});
    expected.push_back({'f', x + 2, z + 1});
    expected.push_back({'r', 64, z + 1});
  }
  const std::vector<Move> shape = {{'r', 64, -20}, {'f', 60, -20}, {'f', 20, 0}, {'r', 64, 2}};
  expected.insert(expected.end(), shape.begin(), shape.end());
  expect_moves(actual, expected);
}

TEST(Repetitive, ThePatternComesNearer) {
  const std::vector<Move> actual =
      cut("G00 X70. Z5.\nG73 U6. W3. R4\nG73 P10 Q20 U0.4 W0.2 F0.3\n"
          "N10 G00 X20. Z0.\nN20 G01 X60. Z-40. F0.1\n");
  std::vector<Move> expected = {{'r', 70, 5}};
  for (int n = 0; n < 4; ++n) {
    const double share = (3.0 - n) / 3.0;
    const double dx = 2.0 * (6.0 * share + 0.2);
    const double dz = 3.0 * share + 0.2;
    expected.push_back({'r', 70 + dx, 5 + dz});
    expected.push_back({'r', 20 + dx, dz});
    expected.push_back({'f', 60 + dx, -40 + dz});
  }
  expected.push_back({'r', 70, 5});
  expect_moves(actual, expected);
}

TEST(Repetitive, HollowsNeedXAndZInTheFirstBlock) {
  const std::string shape = "G01 X20. Z-10. F0.1\nX30. Z-20.\nX20. Z-30.\nN20 X40. Z-40.\n";
  std::string fault;
  cut("G00 X44. Z2.\nG71 U4. R0.5\nG71 P10 Q20 U0. W0. F0.3\nN10 G00 X20.\n" + shape, interpreter::Ended::alarm,
      &fault);
  EXPECT_TRUE(fault.starts_with("PS0064")) << fault;
  const std::vector<Move> actual =
      cut("G00 X44. Z2.\nG71 U4. R0.5\nG71 P10 Q20 U0. W0. F0.3\nN10 G00 X20. Z1.\n" + shape);
  // At radius 14 the shape is met at Z-18, left at Z-22 and met again at Z-34.
  bool second = false;
  for (std::size_t i = 1; i < actual.size(); ++i) {
    if (actual[i].kind == 'f' && std::abs(actual[i].x - 28.0) < 1e-9 && std::abs(actual[i].z + 34.0) < 1e-9) {
      second = true;
      EXPECT_NEAR(actual[i - 1].z, -22.0, 1e-9);
    }
  }
  EXPECT_TRUE(second);
}

TEST(Repetitive, PeckingGroovesByStepsAndPecks) {
  // X steps of 2 (radius) from 40 to 30, pecks of 4 down to Z-10, back by 1.
  const std::vector<Move> actual = cut("G00 X40. Z2.\nG74 R1.\nG74 X32. Z-10. P2000 Q5000 F0.1\n");
  std::vector<Move> expected = {{'r', 40, 2}};
  for (int column = 0; column <= 2; ++column) {
    const double x = 40.0 - 4.0 * column;
    if (column > 0) expected.push_back({'r', x, 2});
    for (const double z : {-3.0, -8.0}) {
      expected.push_back({'f', x, z});
      expected.push_back({'r', x, z + 1});
    }
    expected.push_back({'f', x, -10});
    expected.push_back({'r', x, 2});
  }
  expected.push_back({'r', 40, 2});
  expect_moves(actual, expected);
}

TEST(Repetitive, GroovingAlongX) {
  const std::vector<Move> actual = cut("G00 X40. Z2.\nG75 R0.5\nG75 X20. Z-1. P3000 Q1500 F0.1\n");
  std::vector<Move> expected = {{'r', 40, 2}};
  for (const double z : {2.0, 0.5, -1.0}) {
    if (z < 2.0) expected.push_back({'r', 40, z});
    for (const double r : {17.0, 14.0, 11.0}) {
      expected.push_back({'f', 2 * r, z});
      expected.push_back({'r', 2 * (r + 0.5), z});
    }
    expected.push_back({'f', 20, z});
    expected.push_back({'r', 40, z});
  }
  expected.push_back({'r', 40, 2});
  expect_moves(actual, expected);
}

// First cut 0.4, then 0.4·√n, no step under 0.1, down to 0.05 before the height of 1.2; the height itself twice.
TEST(Repetitive, ThreadingDeepensByTheRootOfThePass) {
  const std::vector<Move> actual = cut("G00 X34. Z4.\nG76 P021060 Q100 R0.05\nG76 X27.6 Z-20. P1200 Q400 F2.\n");
  std::vector<double> depths;
  for (double depth = 0.0, n = 1.0; depth < 1.15 - 1e-9; ++n) {
    depth = std::min(1.15, std::max(0.4 * std::sqrt(n), depth + 0.1));
    depths.push_back(depth);
  }
  depths.push_back(1.2);
  depths.push_back(1.2);
  std::vector<Move> expected = {{'r', 34, 4}};
  for (const double depth : depths) {
    const double x = 27.6 + 2.0 * (1.2 - depth);
    expected.push_back({'r', x, 4.0 - depth * std::tan(30.0 * 3.14159265358979323846 / 180.0)});
    expected.push_back({'t', x, -18});        // r = 10: over one lead of 2
    expected.push_back({'t', x + 4.0, -20});  // … at 45 degrees, X being a diameter
    expected.push_back({'r', 34, -20});
    expected.push_back({'r', 34, 4});
  }
  expect_moves(actual, expected);
}

TEST(Repetitive, FaultsOfTheShape) {
  std::string fault;
  cut("G00 X64. Z2.\nG71 U5. R1.\nG71 P10 Q99 U0.4 W0.1 F0.3\nN10 G00 X20.\nN20 G01 Z0. F0.1\n",
      interpreter::Ended::alarm, &fault);
  EXPECT_TRUE(fault.starts_with("PS0063")) << fault;
  cut("G00 X64. Z2.\nG71 U5. R1.\nG71 P10 Q20 U0.4 W0.1 F0.3\nN10 G02 X20. Z-5. R30. F0.1\nN20 G01 Z-9.\n",
      interpreter::Ended::alarm, &fault);
  EXPECT_TRUE(fault.starts_with("PS0065")) << fault;
  cut("G00 X64. Z2.\nG71 U5. R1.\nG71 P10 Q20 U0.4 W0.1 F0.3\nN10 G00 X20.\nM98 P5\nN20 G01 Z0. F0.1\n",
      interpreter::Ended::alarm, &fault);
  EXPECT_TRUE(fault.starts_with("PS0065")) << fault;
}

TEST(Repetitive, AShapeAtTheEndOfTheText) {
  const std::vector<Move> actual =
      cut("GOTO5\nN10 G00 X20.\nG01 Z0. F0.1\nN20 X60. Z-40.\nM30\n"
          "N5 G00 X64. Z2.\nG70 P10 Q20\n");
  expect_moves(actual, {{'r', 64, 2}, {'r', 20, 2}, {'f', 20, 0}, {'f', 60, -40}, {'r', 64, 2}});
}

ConvertResult lathe_translated(const std::string& text, const std::string& from, const std::string& to) {
  ConvertRequest request;
  request.source = text::Source("program", text);
  request.from = control(from, ir::MachineKind::lathe);
  request.to = control(to, ir::MachineKind::lathe);
  return convert(request);
}

// The same moves there, to the decimals that are printed.
std::string expect_translated(const std::string& text, const std::string& from, const std::string& to) {
  const ConvertResult made = lathe_translated(text, from, to);
  EXPECT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, text::Source("program", text));
  const auto a = real_moves(run_text(text, control(from, ir::MachineKind::lathe)).motions);
  const auto b = real_moves(run_text(made.text, control(to, ir::MachineKind::lathe)).motions);
  EXPECT_EQ(a.size(), b.size()) << made.text;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    EXPECT_EQ(a[i].kind, b[i].kind) << i << made.text;
    for (const std::size_t axis : {std::size_t{0}, std::size_t{2}})
      EXPECT_NEAR(a[i].end[axis], b[i].end[axis], 1.1e-3) << i << made.text;
    EXPECT_NEAR(a[i].feed, b[i].feed, 1e-9) << i << made.text;
  }
  return made.text;
}

const std::string kLatheHead = "%\nO1\nG21 G18 G99 G97 G40\nS500 M03\nG00 X34. Z5.\n";

// R of G73 is how many passes: 3, not 0.003 mm.
TEST(LatheOfNumberedControls, PassesOfAPatternStayANumber) {
  for (const std::string to : {"mazak", "mitsubishi-m80"}) {
    const std::string made = expect_translated(
        kLatheHead +
            "G73 U6. W2. R3\nG73 P10 Q20 U0.4 W0.1 F0.3\nN10 G00 X14.\nG01 Z-8. F0.1\nN20 X33. Z-28.\n"
            "G71 U2. R1\nG71 P30 Q40 U0.4 F0.3\nN30 G00 X14.\nG01 Z-9. F0.1\nN40 X33. Z-30.\nG00 X50.\nM30\n%\n",
        "fanuc", to);
    EXPECT_TRUE(made.contains("W2. R3\n")) << made;
    EXPECT_TRUE(made.contains("U2. R0.001\n")) << made;  // a distance
  }
}

TEST(LoweredTurning, SinglePassesAsTheirMoves) {
  const std::string made = expect_translated(
      kLatheHead +
          "G92 X29.2 Z-20. F2.\nX28.6\nX28.2 R-0.5\nU-6.2 W-24.\nG00 X40.\nG01 Z0. F0.2\nG00 X34. Z5.\n#1=29.\n"
          "WHILE[#1 GT 27.]DO1\nG92 X#1 Z-20. F2.\n#1=#1-0.5\nEND1\nG00 X50.\nG90 X30. Z-10. F0.3\nX28.\n"
          "G94 X20. Z2. R-1.\nG00 X100. Z50.\nM30\n%\n",
      "fanuc", "sinumerik-840d");
  // A switch for the coolant alone leaves the place known.
  expect_translated("%\nO1\nG21 G18 G99 G97 G40\nG00 X34. Z5. /M08\nG92 X29. Z-20. F2.\nG00 X50.\nM30\n%\n", "fanuc",
                    "sinumerik-840d");
  EXPECT_NE(made.find("G33 Z-20. K2."), std::string::npos) << made;
  EXPECT_NE(made.find("G0 X=R1"), std::string::npos) << made;
}

TEST(LoweredTurning, RepetitiveCyclesAsTheirMoves) {
  expect_translated(kLatheHead +
                        "G76 P021060 Q100 R0.05\nG76 X27.6 Z-20. P1200 Q400 F2.\nG01 X50. F0.2\n"
                        "G76 X27.6 Z-20. K1.2 D400 A60 F1.5\nG00 X40. Z2.\nG74 R1.\nG74 X32. Z-10. P2000 Q5000 F0.1\n"
                        "G75 R0.5\nG75 X20. Z-1. P3000 Q1500 F0.1\nG00 X100. Z50.\nM30\n%\n",
                    "fanuc", "sinumerik-840d");
}

TEST(LoweredTurning, ThreadsOfCallsAsTheirMoves) {
  const std::string text =
      "G18 G90 G95 G71 DIAMON\nS500 M3\nG0 X50 Z10\nG1 X45 "
      "F0.3\nCYCLE97(2,,0,-30,20,20,3,2,1.23,0.05,30,0,5,2,3,1,1)\nX44\n"
      "CYCLE97(1.5,,0,-30,20,24,3,2,0.9,0.05,0,0,4,1,2,2,1)\nDIAMOF\nCYCLE97(1.5,,0,-30,20,20,3,2,0.9,,,,2,,1)\n"
      "G0 X50\nM30\n";
  for (const std::string to : {"fanuc", "mazak", "mitsubishi-m80"}) {
    const std::string made = expect_translated(text, "sinumerik-840d", to);
    EXPECT_EQ(made.find("K2."), std::string::npos) << made;  // F is the lead there
  }
}

// K there and F here: here the lead is the feed of what follows, there it is not.
TEST(LoweredTurning, PlainThreadsKeepLeadAndFeed) {
  const std::string siemens =
      "G18 G90 G95 G71 DIAMON\nS500 M3\nG0 X50 Z10\nG1 X45 F0.3\nG33 Z-20 K2\nX48 Z-25 K2\nG0 X50\nG1 X40\nG0 Z10\n"
      "G33 Z0 K1.5\nF0.2\nG1 X41\nM30\n";
  for (const std::string to : {"fanuc", "mazak", "mitsubishi-m80"})
    EXPECT_EQ(expect_translated(siemens, "sinumerik-840d", to).find('K'), std::string::npos);
  const std::string made = expect_translated(
      "%\nO1\nG21 G18 G99 G97 G40\nS500 M03\nG00 X50. Z10.\nG01 X45. F0.3\nG32 Z-20. F2.\nX48. Z-25.\n"
      "G00 X50.\nG01 X40.\nG00 Z10.\nG32 Z0. F1.5\nG00 X60.\nG01 X41. F0.4\nM30\n%\n",
      "fanuc", "sinumerik-840d");
  EXPECT_NE(made.find("X48. Z-25. K2."), std::string::npos) << made;
}

TEST(LoweredTurning, WhatIsNotKnownIsRefused) {
  const std::string head = "%\nO1\nG21 G18 G99 G97 G40\n";
  for (const std::string blocks :
       {"G92 X29. Z-20. F2.\nM30\n",                                                    // begins anywhere
        "G00 X34. Z5.\nT0202\nG92 X29. Z-20. F2.\nM30\n",                               // with another offset
        "G00 X#5 Z5.\nG92 X29. Z-20. F2.\nM30\n",                                       // at a computed place
        "G00 X34. Z5.\nG76 P021060 Q100 R0.05\nG76 X#1 Z-20. P1200 Q400 F2.\nM30\n",    // how many passes
        "G00 X34. Z5.\nIF[#1EQ1.]GOTO5\nG92 X29. Z-20. F2.\nN5 X28.\nG00 X50.\nM30\n",  // a pass, or a move
        "G00 X34. Z5.\nG92 X29. Z-20.\nG00 X50.\nM30\n"})                               // no lead
    EXPECT_TRUE(text::has_error(lathe_translated(head + blocks + "%\n", "fanuc", "sinumerik-840d").diagnostics))
        << blocks;
  EXPECT_TRUE(text::has_error(
      lathe_translated("G18 G90 G95 G71 DIAMON\nG0 X50 Z10\nCYCLE97(R1,,0,-30,20,20,3,2,1.23,0,0,0,5)\nM30\n",
                       "sinumerik-840d", "fanuc")
          .diagnostics));
}

// A thread of more passes than are run for one call is refused by the name of its cycle, and writes nothing of it.
TEST(LoweredTurning, AThreadThatIsTooLongToRunIsRefused) {
  const auto made = lathe_translated(
      "G18 G90 G95 G71 DIAMON\nS500 M3\nG0 X50 Z10\nCYCLE97(2,,0,-30,40,40,0,0,1.2,0.05,29,0,300000,1,3,1)\nM30\n",
      "sinumerik-840d", "fanuc");
  ASSERT_TRUE(text::has_error(made.diagnostics));
  EXPECT_NE(text::message_of(made.diagnostics.front()).find("CYCLE97 with such arguments"), std::string::npos)
      << text::message_of(made.diagnostics.front());
  EXPECT_EQ(made.text, "");
}

// The angle of a G76 in one block is not an axis of the machine.
// S counts as G96 or G97 of its block says, wherever the spindle's M goes.
TEST(LoweredTurning, SpeedsGoWithWhatTheyCount) {
  const std::string text =
      "%\nO1\nG21 G18 G40 G97 G99\nT0101\nG50 S2000\nG0 G96 X60. Z5. S250 M3 M8\nG1 Z-10. F0.2\n"
      "G0 G97 X100. Z50. S800 M4 M8\nM30\n%\n";
  for (const std::string to : {"mazak", "mitsubishi-m80"}) {
    const std::string made = lathe_translated(text, "fanuc", to).text;
    EXPECT_TRUE(made.contains("G96 S250 M03\nG00 X60. Z5. M08\n")) << made;
    EXPECT_TRUE(made.contains("G97 S800 M04\nG00 X100. Z50. M08\n")) << made;
  }
}

// The usual thread of a program's own: cuts in a loop. G97 leaves a feed per turn one, and after the loop nothing
// cuts.
TEST(LoweredTurning, ThreadsInALoop) {
  const std::string head = "DEF INT CUT\nG18 G54 G90 G710 DIAMON\nT2 D1\nG95 F0.2\nG97 S600 M3\nG0 X24 Z5\n";
  const std::string loop = "FOR CUT=1 TO 4\nG0 X=20-CUT*0.4\nG33 Z-12 K1.5\nG0 X24\nG0 Z5\nENDFOR\n";
  const std::string own = head + loop + "G1 X22\nG0 X100\nM30\n";
  for (const std::string to : {"fanuc", "mazak", "mitsubishi-m80"}) {
    const ConvertResult made = lathe_translated(own, "sinumerik-840d", to);
    ASSERT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, text::Source("p", own));
    expect_same(real_moves(run_text(own, control("sinumerik-840d", ir::MachineKind::lathe)).motions),
                real_moves(run_text(made.text, control(to, ir::MachineKind::lathe)).motions), 1e-9, made.text);
  }
  const std::string feed = "DEF INT CUT\nG18 G54 G90 G710 DIAMON\nT2 D1\nG95 F=R1\nG97 S600 M3\nG0 X24 Z5\n";
  EXPECT_FALSE(
      text::has_error(lathe_translated(feed + loop + "G0 X100\nM30\n", "sinumerik-840d", "fanuc").diagnostics));
  EXPECT_TRUE(text::has_error(lathe_translated(feed + loop + "G1 X22\nM30\n", "sinumerik-840d", "fanuc").diagnostics));
}

// T6 of a lathe is offset 6 of the tool that is in; where no T names a tool, it is that of tool 6.
TEST(LoweredTurning, AnOffsetWithoutATool) {
  const auto messages = [](const std::string& tools) {
    const std::string text = "%\nO1\nG21 G18 G40 G97 G99\n" + tools + "G0 X20. Z5.\nM30\n%\n";
    return messages_of(lathe_translated(text, "fanuc", "sinumerik-840d").diagnostics, text::Source("p", text));
  };
  const std::string gang = "%\nO1\nG21 G18 G40 G97 G99\nT6\nG0 X20. Z5.\nT9\nX30.\nT0\nM30\n%\n";
  const std::string made = lathe_translated(gang, "fanuc", "sinumerik-840d").text;
  EXPECT_TRUE(made.contains("T6 D1\n") && made.contains("T9 D1\n") && made.contains("\nD0\n")) << made;
  EXPECT_TRUE(messages("T6\n").contains("warning[translation-tool]: an offset without a tool"));
  EXPECT_TRUE(messages("T0101\nT6\n").contains("the offset of another tool"));
  EXPECT_FALSE(messages("T0606\nT6\n").contains("the offset of another tool"));
}

TEST(Repetitive, AnAngleIsNoAxis) {
  const std::vector<Move> actual = cut("G00 X34. Z4.\nG76 X27.6 Z-20. K1.2 D400 A29 F2.\n");
  ASSERT_GT(actual.size(), 1U);
  EXPECT_NEAR(actual[1].z, 4.0 - 0.4 * std::tan(14.5 * 3.14159265358979323846 / 180.0), 1e-9);
  const std::string text = kLatheHead + "G76 X27.6 Z-20. K1.2 D400 A29 F2.\nM30\n%\n";
  for (const std::string to : {"mazak", "mitsubishi-m80", "sinumerik-840d"}) expect_translated(text, "fanuc", to);
}

}  // namespace
}  // namespace dripfeed::compile::test
