// SINUMERIK axes that move besides the path, frames, and calls whose arguments
// do not fit. The oracle of each is the rule of the Programming Manuals Fundamentals (PG) and Job Planning (PGA), or
// the alarm of the Diagnostics Manual, that it names.
#include "tests/unit/dialects/compile/sinumerik_run.h"

namespace dripfeed::compile::test {
namespace {

constexpr std::string_view kHead = "G17 G71 G90 G94\nG0 X0 Y0 Z5\n";

Result after_head(std::string_view text, const Texts& called = {}) {
  return run(std::string(kHead) + std::string(text) + "M30\n", called);
}

// PG, "Positioning axes": POS is no path motion, and the motion code stays.
TEST(SinumerikAxes, PositioningIsAMoveOfItsOwn) {
  const Result ran = after_head("G1 X1 F100\nPOS[Y]=5\nX2\nG91 POS[Z]=1\nPOS[AXNAME(\"X\")]=AC(7)\n");
  EXPECT_EQ(moves(ran),
            "2 rapid X0.0000 Y0.0000 Z5.0000\n"
            "3 linear X1.0000 Y0.0000 Z5.0000 F100.0000/min\n"
            "4 rapid X1.0000 Y5.0000 Z5.0000\n"
            "5 linear X2.0000 Y5.0000 Z5.0000 F100.0000/min\n"
            "6 rapid X2.0000 Y5.0000 Z6.0000\n"
            "7 rapid X7.0000 Y5.0000 Z6.0000\n");
  EXPECT_TRUE(std::ranges::all_of(ran.result.not_interpreted, &interpreter::NotInterpreted::effects_known));
}

TEST(SinumerikAxes, WhatDoesNotWaitIsReported) {
  const Result ran = after_head("POSA[X]=10 FA[X]=500\nWAITP(X)\nG0 Y1\n");
  EXPECT_TRUE(ran.names("POSA[X]"));
  EXPECT_TRUE(ran.names("FA[X]"));
  EXPECT_TRUE(ran.trace.contains("rapid X10.0000 Y1.0000"));
}

// A position from the machine's table (CAC), a measuring move that a list describes, a further base frame.
TEST(SinumerikAxes, WhereAnAxisMayBeAnywhereItIsNotKnown) {
  for (const std::string text : {"X=CAC(2)\n", "MEASA[X]=(1,1) G1 X30\n", "POLY PO[]=(2,1)\n", "POSP[X]=(10,2,0)\n",
                                 "$P_CHBFR[1]=CTRANS(X,5)\n", "PRESETON(X,5)\n", "WHEN TRUE DO POS[X]=5\n"}) {
    const Result ran = after_head(text + "G0 Y1\n");
    ASSERT_FALSE(ran.motions.empty()) << text;
    EXPECT_NE(ran.motions.back().axes_unknown & 1U, 0U) << text;
    EXPECT_FALSE(std::ranges::all_of(ran.result.not_interpreted, &interpreter::NotInterpreted::effects_known)) << text;
  }
  // Settings of the path move nothing.
  EXPECT_EQ(after_head("CYCLE832(0.01,1,1)\nG0 Y1\n").motions.back().axes_unknown & 1U, 0U);
}

// PG, "SPOS": the main spindle stands at an angle, as after M19.
TEST(SinumerikAxes, AnOrientedSpindleStands) {
  const Result ran = after_head("S500 M3\nSPOS=90\nG1 X1 F100\nSPOS[2]=5\n");
  EXPECT_TRUE(ran.trace.contains("4 spindle off"));
  EXPECT_TRUE(ran.names("SPOS"));  // the angle
  EXPECT_TRUE(ran.names("SPOS[2]"));
}

// Whether an increment takes a changed frame along, SD42440 FRAME_OFFSET_INCR_PROG decides (PG, "Incremental
// dimensions"): the position is not known until the axis is programmed absolutely.
TEST(SinumerikAxes, AnIncrementAfterAShiftIsNotKnown) {
  constexpr std::string_view kNote =
      "an increment along an axis whose frame has changed (SD42440 FRAME_OFFSET_INCR_PROG decides)";
  const std::string place = "G0 X0 Y0 Z5\n";
  struct Row {
    std::string text;
    unsigned unknown;  // bits of the axes, at the end
  };
  for (const Row& row :
       {Row{"TRANS X10\nG91 G1 X5 F100\n", 1U}, Row{"TRANS X10\nG1 X=IC(5) F100\n", 1U},
        Row{"ATRANS Y1\nG91 G1 X5 Y5 F100\n", 2U}, Row{"TRANS X10\nG91 G1 Y5 F100\nX5\n", 1U},
        Row{"G58 X10\nG91 G1 X5 F100\n", 1U}, Row{"ROT RPL=30\nG91 G1 X5 F100\n", 3U},
        Row{"$P_PFRAME=CTRANS(X,10)\nG91 G1 X5 F100\n", 1U}, Row{"TRANS X10\nG0 X0\nTRANS\nG91 G1 X5 F100\n", 1U}}) {
    const Result ran = after_head(place + row.text + "G90 G0 Z9\n");
    EXPECT_EQ(ran.motions.back().axes_unknown & 7U, row.unknown) << row.text;
    EXPECT_TRUE(ran.names(kNote)) << row.text;
  }
  for (const std::string known : {"TRANS X10\nG0 X0\nG91 G1 X5 F100\n", "TRANS X0\nG91 G1 X5 F100\n",
                                  "TRANS X10\nG91 G1 Y5 F100\n", "ROT RPL=30\nG0 X0 Y0\nG91 G1 X5 F100\n",
                                  "ROT RPL=30\nG91 G1 Z5 F100\n", "TRANS X10\nG91 G1 X5 F100\nG90 X5\nG91 X1\n"}) {
    const Result ran = after_head(place + known + "G90 G0 Z9\n");
    EXPECT_EQ(ran.motions.back().axes_unknown & 7U, 0U) << known;
  }
  EXPECT_TRUE(after_head(place + "TRANS X10\nG91 G1 X5 F100\nG90 X5\nM30\n").trace.contains("linear X15.0000"));
}

// The list of G functions (PG): the first of group 6 is G17, the second of group 14 G91.
TEST(SinumerikAxes, CodesByGroupAndNumber) {
  const Result ran = after_head("G[14]=2 G[1]=1 X1\nX1\nG[6]=R1\n");
  EXPECT_TRUE(ran.trace.contains("4 rapid X2.0000"));
  EXPECT_TRUE(ran.names("G[]"));
}

// Each program of a stream has names of its own: the caller's INT is not the called program's REAL.
TEST(SinumerikCalls, ProgramsOfOneTextHaveTheirOwnNames) {
  const Result ran =
      run("%_N_FIRST_MPF\nDEF INT XA\nG17 G90 G71 G94\nXA=1\nSECOND\nG0 Y=XA\nM30\n"
          "%_N_SECOND_SPF\nDEF REAL XA=1.5\nG0 X=XA\nXA=2.5\nG0 X=XA\nM17\n");
  EXPECT_TRUE(ran.trace.contains("rapid X1.5000")) << ran.trace;
  EXPECT_TRUE(ran.trace.contains("rapid X2.5000 Y1.0000")) << ran.trace;
}

TEST(SinumerikCalls, ArgumentsThatDoNotFitAreAlarms) {
  const Texts called = {{"PART", "PROC PART(VAR REAL A, REAL B, AXIS C)\nA=B\nM17\n"}};
  EXPECT_EQ(after_head("PART(R1,1,X)\n", called).result.ended, interpreter::Ended::end);
  EXPECT_EQ(alarm_of(after_head("PART(,1,X)\n", called)), "14010");
  EXPECT_EQ(alarm_of(after_head("PART(R1,1)\n", called)), "14010");
  EXPECT_EQ(alarm_of(after_head("PART(R1,1,X,2)\n", called)), "12340");
  EXPECT_EQ(alarm_of(after_head("PART(R1+1,1,X)\n", called)), "12320");
  const Result wrong = after_head("PART(R1,\"A\",X)\n", called);
  EXPECT_EQ(alarm_of(wrong), "12330");
  ASSERT_FALSE(wrong.result.diagnostics.empty());
  EXPECT_EQ(wrong.result.diagnostics.back().diagnostic.arguments.front(), "argument 2");
}

}  // namespace
}  // namespace dripfeed::compile::test
