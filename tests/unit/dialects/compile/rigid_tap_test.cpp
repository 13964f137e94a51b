// Rigid taps whose F counts one thing here and another there: a feed a minute after M29 and of G84.2, the lead with
// ,R1 and in CYCLE84. Oracle: the lead of each move of both runs.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dialects/text/number.h"
#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

using ir::MachineKind;

const std::string kHead = "%\nO1\nG21 G17 G40 G80 G90 G94 G54\nG00 X0 Y0 Z5. S500 M03\n";
const std::string kEnd = "G80\nG01 X99. F100.\nM30\n%\n";

ConvertResult converted(const std::string& text, const std::string& from, const std::string& to,
                        MachineKind kind = MachineKind::mill) {
  ConvertRequest request;
  request.source = text::Source("program", text);
  request.from = control(from, kind);
  request.to = control(to, kind);
  return convert(request);
}
std::string refusal(const std::string& text, const std::string& from, const std::string& to,
                    MachineKind kind = MachineKind::mill) {
  const ConvertResult made = converted(text, from, to, kind);
  EXPECT_TRUE(text::has_error(made.diagnostics)) << made.text;
  return messages_of(made.diagnostics, text::Source("program", text));
}

// Ends and leads of the moves into the material.
std::vector<std::string> cuts_of(const std::string& text, const std::string& dialect) {
  std::vector<std::string> out;
  for (const ir::Motion& m : run_text(text, control(dialect, MachineKind::mill)).motions) {
    if (!ir::is_move(m.kind) || m.kind == ir::MotionKind::rapid || m.start == m.end) continue;
    const bool by_time = m.kind != ir::MotionKind::thread && m.feed_mode == ir::FeedMode::per_min;
    const double lead = by_time ? m.feed / m.spindle_rpm : m.feed;
    out.push_back(text::format_fixed(m.end[0], 3) + " " + text::format_fixed(m.end[2], 3) + " " +
                  text::format_fixed(lead, 4));
  }
  return out;
}
void expect_same_leads(const std::string& text, const std::string& from, const std::string& to) {
  const ConvertResult made = converted(text, from, to);
  EXPECT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, text::Source("program", text));
  const auto here = cuts_of(text, from);
  EXPECT_GE(here.size(), 2U);
  EXPECT_EQ(here, cuts_of(made.text, to)) << made.text;
}

TEST(RigidTap, TheLeadIsTheSame) {
  const std::string fanuc = kHead + "M29 S500\nG84 Z-20. R2. F750.\nX10.\nG80\nG01 X20.\n" + kEnd;
  const std::string lead = kHead + "G84 Z-20. R2. F1.5 ,R1\nX10.\nG80\nG01 X20.\n" + kEnd;
  expect_same_leads(fanuc, "fanuc", "mitsubishi-m80");
  expect_same_leads(fanuc, "fanuc", "mazak");
  expect_same_leads(fanuc, "fanuc", "sinumerik-840d");
  expect_same_leads(lead, "mitsubishi-m80", "fanuc");
  expect_same_leads(lead, "mitsubishi-m80", "mazak");
  // With numbers of blocks, which are no labels where no one jumps to them.
  expect_same_leads(kHead + "N10 M29 S500\nN20 G84 Z-20. R2. F750.\nN30 X10.\n" + kEnd, "fanuc", "mitsubishi-m80");
  expect_same_leads(kHead + "N10 M29 S500\nN20 G84 Z-20. R2. F750.\nN30 X10.\n" + kEnd, "fanuc", "mazak");
}

// Per revolution F is the lead for both.
TEST(RigidTap, ALeadThatChangesUnderTheCycleIsRefusedWhereItCounts) {
  const std::string head = "%\nO1\nG21 G17 G40 G80 G90 G95 G54\nG00 X0 Y0 Z5. S500 M03\n";
  expect_same_leads(head + "G84 Z-20. R2. F1.5 ,R1\nX10. F2.\n" + kEnd, "mitsubishi-m80", "fanuc");
  for (const std::string tap : {"G84 Z-20. R2. F1.5 ,R1\nX10. F2.\n", "G84 Z-20. R2. F1.5 ,R1\nG95\nX10.\n"})
    EXPECT_NE(refusal(kHead + tap + kEnd, "mitsubishi-m80", "fanuc").find("changes under a rigid tap"),
              std::string::npos)
        << tap;
  EXPECT_NE(refusal(kHead + "M29 S500\nG84 Z-20. R2. F750.\nX10. F375.\n" + kEnd, "fanuc", "mitsubishi-m80")
                .find("changes under a rigid tap"),
            std::string::npos);
}

// Which S counts, a path round or past it decides; and where the feed is to be stated again.
TEST(RigidTap, WhatJumpsDecideIsRefused) {
  const std::string past = kHead + "#1=1\nIF[#1EQ1]GOTO5\nS800\nN5 G84 Z-20. R2. F1.5 ,R1\n" + kEnd;
  EXPECT_NE(refusal(past, "mitsubishi-m80", "mazak").find("a rigid tap whose feed or speed"), std::string::npos);
  const std::string round = kHead +
                            "#1=0\nWHILE[#1LT2]DO1\nG84 Z-20. R2. F1.5 ,R1\nX10.\nG80\nG01 X50. F100.\nS300\n#1=#1+1\n"
                            "END1\n" +
                            kEnd;
  EXPECT_NE(refusal(round, "mitsubishi-m80", "fanuc").find("a rigid tap whose feed or speed"), std::string::npos);
  const std::string away = kHead + "G84 Z-20. R2. F1.5 ,R1\nGOTO20\nN10 G80\nN20 G01 X50.\n" + kEnd;
  EXPECT_NE(refusal(away, "mitsubishi-m80", "fanuc").find("with a jump before its end"), std::string::npos);
  // One speed in all of the program is the one.
  expect_same_leads(kHead + "#1=0\nWHILE[#1LT2]DO1\nG84 Z-20. R2. F1.5 ,R1\nX10.\nG80\n#1=#1+1\nEND1\n" + kEnd,
                    "mitsubishi-m80", "fanuc");
}

TEST(RigidTap, ASecondOneAfterOneM29IsRefused) {
  const std::string twice = "M29 S500\nG84 Z-20. R2. F750.\nG84 Z-25. X3.\n";
  for (const std::string to : {"mazak", "mitsubishi-m80"})
    EXPECT_NE(refusal(kHead + twice + kEnd, "fanuc", to).find("a second tap after one M29"), std::string::npos);
  const std::string lathe =
      "%\nO1\nG21 G18 G40 G80 G97 G99 G54\nT0101\nG00 X0 Z5. S500 M03\nM29 S500\nG84 Z-20. R-2. F1.5\nG84 Z-25. R-2. "
      "F1.5 X3.\nG80\nM30\n%\n";
  EXPECT_NE(refusal(lathe, "fanuc", "sinumerik-840d", MachineKind::lathe).find("a second one after one M29"),
            std::string::npos);
  EXPECT_NE(refusal(lathe, "fanuc", "mazak", MachineKind::lathe).find("a second tap after one M29"), std::string::npos);
  expect_same_leads(kHead + "M29 S500\nG84 Z-20. R2. F750.\nG80\nM29 S500\nG84 Z-25. X3. R2. F750.\n" + kEnd, "fanuc",
                    "mazak");
}

// CYCLE84 has the lead and the speed among its arguments: a block that changes them calls it again.
TEST(RigidTap, ALaterHoleHasALeadOfItsOwn) {
  for (const std::string change : {"X10. F375.\n", "F375.\nX10.\n", "X10. S250\n", "X10. F375. Z-15.\n"}) {
    expect_same_leads(kHead + "G84 X0 Z-20. R2. F750.\n" + change + kEnd, "fanuc", "sinumerik-840d");
    expect_same_leads(kHead + "M29 S500\nG84 X0 Z-20. R2. F750.\n" + change + kEnd, "fanuc", "sinumerik-840d");
  }
  const std::string per_turn = "%\nO1\nG21 G17 G40 G80 G90 G95 G54\nG00 X0 Y0 Z5. S500 M03\n";
  expect_same_leads(per_turn + "G84 X0 Z-20. R2. F1.5 ,R1\nX10. F2.\n" + kEnd, "mitsubishi-m80", "sinumerik-840d");
}

TEST(RigidTap, ALeftHandedLeadIsRefused) {
  const std::string text =
      "G71 G90 G18 G95 G40 DIAMON G54\nT1 D1\nG97 S300 M3\nG0 X0 "
      "Z5\nG17\nCYCLE840(5,0,2,-20,,0,4,3,0,,-1.5)\nG18\nM5\nM30\n";
  EXPECT_NE(refusal(text, "sinumerik-840d", "fanuc", MachineKind::lathe).find("not right-handed"), std::string::npos);
}

TEST(RigidTap, AThreadWhoseSpindleTurnsBackIsNoPlainMove) {
  ConvertRequest request;
  request.source = text::Source(
      "program", "G71 G90 G17 G95 G40 G54\nT1 D1\nS300 M3\nG0 X0 Y0 Z5\nCYCLE840(5,0,2,-20,,0,4,3,0,,1.5)\nM5\nM30\n");
  request.from = control("sinumerik-840d", MachineKind::mill);
  request.to = control("fanuc", MachineKind::mill);
  request.mode = ConvertMode::explicit_blocks;
  const ConvertResult made = convert(request);
  EXPECT_TRUE(text::has_error(made.diagnostics)) << made.text;
}

// G63 goes on without a stop, too, but it is for taps: without override and feed hold.
TEST(RigidTap, ContinuousPathIsNotTapping) {
  const std::string text = "G71 G90 G17 G94 G64\nG0 X0\nG1 X1 F100\nM30\n";
  for (const std::string to : {"fanuc", "mazak", "mitsubishi-m80"}) {
    const ConvertResult made = converted(text, "sinumerik-840d", to);
    EXPECT_NE(made.text.find("G64"), std::string::npos) << made.text;
    EXPECT_EQ(made.text.find("G63"), std::string::npos) << made.text;
    EXPECT_EQ(made.text.find("G61"), std::string::npos) << made.text;
  }
}

}  // namespace
}  // namespace dripfeed::compile::test
