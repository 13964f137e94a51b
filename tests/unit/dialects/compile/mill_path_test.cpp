// CYCLE72 along the tool's centre (RL 40): the points of its path, by hand from the contour's; what is not interpreted.
// PGZ, "Path milling - CYCLE72"; ShopMill (BAS) 10.04, "Path milling along the center-point path".
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"
#include "tests/unit/dialects/compile/sinumerik_run.h"

namespace dripfeed::compile::test {
namespace {

const std::string kMillHead = "G17 G90 G94 G71 G40\nT1 D1 M6\nS1000 M3 F77\nG0 X-50 Y0 Z100\n";
const Texts kPaths = {{"SQUARE", "PROC SQUARE\nG1 X0 Y0\nX20\nY20\nX0\nY0\nM17\n"},
                      {"BEND", "PROC BEND\nG0 X10 Y0\nG3 X0 Y10 CR=10\nG1 Y30\nM17\n"},
                      {"ROUND", "PROC ROUND\nG0 X10 Y0\nG3 X10 Y0 I=AC(0) J=AC(0)\nM17\n"}};

Result along(const std::string& call, const std::string& rest = "", const Texts& paths = kPaths) {
  return run(kMillHead + call + "\nM30\n" + rest, paths, ir::MachineKind::mill);
}

// "R x y z" of a rapid, "L" with its feed of a line, "A" of an arc; from the call on.
std::string path_of(const Result& ran) {
  std::string out;
  bool is_first = true;
  for (const ir::Motion& m : ran.motions) {
    if (!ir::is_move(m.kind) || std::exchange(is_first, false)) continue;
    const bool is_arc = m.kind == ir::MotionKind::arc_ccw || m.kind == ir::MotionKind::arc_cw;
    const auto at = [](double value) { return std::round(value * 1000.0) / 1000.0 + 0.0; };
    out += fmt::format("{} {} {} {}",
                       m.kind == ir::MotionKind::rapid ? "R"
                       : is_arc                        ? "A"
                                                       : "L",
                       at(m.end[0]), at(m.end[1]), at(m.end[2]));
    out += m.kind == ir::MotionKind::rapid ? "\n" : fmt::format(" F{}\n", m.feed);
  }
  return out;
}

std::string square_at(double z) {
  return fmt::format("L 20 0 {0} F300\nL 20 20 {0} F300\nL 0 20 {0} F300\nL 0 0 {0} F300\n", z);
}

TEST(MillPath, VerticallyDownAtTheContoursStart) {
  const std::string begin = "R -50 0 10\nR 0 0 10\nR 0 0 2\nL 0 0 -2.5 F100\n" + square_at(-2.5);
  const std::string second = "L 0 0 -5 F100\n" + square_at(-5) + "R 0 0 10\n";
  const auto lifted = [&](const std::string& kind, double dp = -5.0) {
    return path_of(along(fmt::format("CYCLE72(\"SQUARE\",10,0,2,{},4,0,0,300,100,{},40,4,0)", dp, kind)));
  };
  EXPECT_EQ(lifted("1"), begin + "R 0 0 10\n" + second);
  EXPECT_EQ(lifted("101"), begin + "R 0 0 2\n" + second);
  EXPECT_EQ(lifted("201"), begin + "R 0 0 -0.5\n" + second);
  EXPECT_EQ(lifted("301"), begin + second);
  // The base keeps its allowance; what is left out of FFD and FFP1 is the feed in effect.
  EXPECT_EQ(path_of(along("CYCLE72(\"SQUARE\",10,0,2,-5,0,0,1,,,1,40,4,0)")),
            "R -50 0 10\nR 0 0 10\nR 0 0 2\nL 0 0 -4 F77\nL 20 0 -4 F77\nL 20 20 -4 F77\nL 0 20 -4 F77\nL 0 0 -4 F77\n"
            "R 0 0 10\n");
}

// Along the tangents: of an arc that begins in Y+, and of a line in Y+.
TEST(MillPath, StraightOnAndOff) {
  EXPECT_EQ(path_of(along("CYCLE72(\"BEND\",10,0,2,-5,9,0,0,300,100,1,40,1,3)")),
            "R -50 0 10\nR 10 -3 10\nR 10 -3 2\nL 10 -3 -5 F100\nL 10 0 -5 F300\nA 0 10 -5 F300\nL 0 30 -5 F300\n"
            "L 0 33 -5 F300\nR 0 33 10\n");
  EXPECT_EQ(path_of(along("CYCLE72(\"BEND\",10,0,2,-5,9,0,0,300,100,1,40,4,0,,1,5)")),
            "R -50 0 10\nR 10 0 10\nR 10 0 2\nL 10 0 -5 F100\nA 0 10 -5 F300\nL 0 30 -5 F300\nL 0 35 -5 F300\n"
            "R 0 35 10\n");
  EXPECT_EQ(path_of(along("CYCLE72(\"ROUND\",10,0,2,-5,9,0,0,300,100,1,40,4,0)")),
            "R -50 0 10\nR 10 0 10\nR 10 0 2\nL 10 0 -5 F100\nA -10 0 -5 F300\nA 10 0 -5 F300\nR 10 0 10\n");
}

TEST(MillPath, AContourBetweenLabelsUnderAShift) {
  EXPECT_EQ(path_of(along("TRANS X100 Y5\nCYCLE72(\"FROM:TO\",10,0,2,-5,9,0,0,300,100,1,40,4,0)",
                          "FROM: G1 X0 Y0\nX20\nTO: Y20\n")),
            "R -50 0 10\nR 100 5 10\nR 100 5 2\nL 100 5 -5 F100\nL 120 5 -5 F300\nL 120 25 -5 F300\nR 120 25 10\n");
}

TEST(MillPath, WhatIsNotCertainIsNamedAndNothingIsCut) {
  const auto left = [](const std::string& call, const std::string& why, const std::string& contour = "") {
    const Texts paths = {{"SQUARE", contour.empty() ? kPaths.at("SQUARE") : "PROC SQUARE\n" + contour + "M17\n"}};
    const Result ran = along(call + ")\nG91 G0 X1", "", paths);
    EXPECT_TRUE(ran.names("CYCLE72 " + why)) << call << ran.trace;
    EXPECT_TRUE(ran.names("increments from a position that is not known")) << call;
    EXPECT_EQ(path_of(ran).find('L'), std::string::npos) << call;
  };
  const std::string head = "CYCLE72(\"SQUARE\",10,0,2,-5,2,0,0,300,100,";
  left(head + "1,41,1,3", "with compensation of the radius (RL), whose approach is not certain");
  left(head + "1,40,2,3", "with an approach (AS1, AS2) that is not known");
  left(head + "1,40,11,3", "with an approach (AS1, AS2) that is not known");
  left(head + "11,40,4,0", "with a path from depth to depth by feed (VARI)");
  left(head + "2,40,4,0", "with finishing (VARI) along the tool's centre");
  left(head + "1001,40,4,0", "with a kind (VARI) that is not known");
  left("CYCLE72(\"SQUARE\",10,0,2,-5,2,0.3,0,300,100,1,40,4,0", "with an allowance (FAL) along the tool's centre");
  left(head + "301,40,1,3", "without a retract, along a contour that is open");
  left(head + "1,40,4,0", "along a contour without a move", "G1 X0 Y0\n");
  left(head + "1,40,4,0", "along a contour that leaves its plane", "G1 X0 Y0\nX20 Z1\n");
  left(head + "1,40,4,0", "along a contour with feeds of its own", "G1 X0 Y0\nX20 F50\n");
  left(head + "1,40,4,0", "along a contour of more than lines and arcs", "G1 X0 Y0\nX20\nG0 Y20\n");
  left(head + "1,40,4,0", "along a contour whose start is not known", "G3 X0 Y0 CR=100\nG1 X20\n");
  left("CYCLE72(,10,0,2,-5,2,0,0,300,100,1,40,4,0", "along a contour that is not known");
  EXPECT_EQ(alarm_of(along(head + "1,40,1,0)")), "61116");
  EXPECT_EQ(alarm_of(along(head + "4,40,4,0)")), "61002");
}

TEST(MillPath, ItsMovesAreTranslated) {
  ConvertRequest request;
  request.source = text::Source("program", kMillHead +
                                               "CYCLE72(\"FROM:TO\",10,0,2,-5,2,0,0,300,100,1,40,1,3)\nM30\n"
                                               "FROM: G1 X0 Y0\nX20\nTO: Y20\n");
  request.from = control("sinumerik-840d", ir::MachineKind::mill);
  request.to = control("fanuc", ir::MachineKind::mill);
  request.mode = ConvertMode::explicit_blocks;
  const ConvertResult made = convert(request);
  ASSERT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, request.source);
  EXPECT_EQ(made.not_verified, "");
  EXPECT_NE(made.text.find("G01 Z-1.6667 F100."), std::string::npos) << made.text;
}

}  // namespace
}  // namespace dripfeed::compile::test
