// Taps of lathes, from one control to the other. Oracle: the run of the source: ends, leads, speeds, dwells and how the
// spindle turns afterwards; the words by hand from the manuals.
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

using ir::MachineKind;
using ir::MotionKind;

const std::string kSinumerik = "sinumerik-840d";
const std::string kNumbered = "%\nO1\nG21 G18 G40 G80 G97 G99 G54\nT0101\nG00 X0 Z5. S300 M03\n";
const std::string kNumberedEnd = "G80\nG00 X100. Z50.\nG01 X99. F0.2\nM05\nM30\n%\n";
const std::string kNamed = "G71 G90 G18 G95 G40 DIAMON G54\nT1 D1\nG97 S300 M3\nG0 X0 Z5\n";
const std::string kNamedEnd = "G18\nG0 X100 Z50\nS200 M3\nG1 X99 F0.2\nM5\nM30\n";

std::string numbered(const std::string& blocks) { return kNumbered + blocks + kNumberedEnd; }
std::string named(const std::string& blocks) { return kNamed + blocks + kNamedEnd; }

ConvertResult converted(const std::string& text, const std::string& from, const std::string& to,
                        MachineKind kind = MachineKind::lathe, ir::GSystem system = ir::GSystem::a) {
  ConvertRequest request;
  request.source = text::Source("program", text);
  request.from = find_dialect(from)->control(kind, system);
  request.to = find_dialect(to)->control(kind, system);
  return convert(request);
}

double lead_of(const ir::Motion& m) {
  const bool by_time = m.kind == MotionKind::linear && m.feed_mode == ir::FeedMode::per_min && m.spindle_rpm > 0.0;
  return by_time ? m.feed / m.spindle_rpm : m.feed;
}

// Moves and dwells; a rapid that only stops on the path of the next one is left out.
std::vector<ir::Motion> cuts_of(const std::vector<ir::Motion>& motions) {
  std::vector<ir::Motion> out;
  for (const ir::Motion& m : motions) {
    const bool counts = m.kind == MotionKind::dwell || (ir::is_move(m.kind) && m.start != m.end);
    if (counts) out.push_back(m);
  }
  return out;
}

std::string expect_same_there(const std::string& text, const std::string& from, const std::string& to,
                              MachineKind kind = MachineKind::lathe, ir::GSystem system = ir::GSystem::a) {
  SCOPED_TRACE(to);
  const ConvertResult made = converted(text, from, to, kind, system);
  EXPECT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, text::Source("program", text));
  const auto a = cuts_of(run_text(text, find_dialect(from)->control(kind, system)).motions);
  const auto b = cuts_of(run_text(made.text, find_dialect(to)->control(kind, system)).motions);
  EXPECT_GE(a.size(), 4U);
  EXPECT_EQ(a.size(), b.size()) << made.text;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const std::string where = made.text + ", move " + std::to_string(i);
    for (std::size_t axis = 0; axis < 6; ++axis) EXPECT_NEAR(a[i].end[axis], b[i].end[axis], 1e-9) << where;
    const bool rapid = a[i].kind == MotionKind::rapid;
    EXPECT_EQ(rapid, b[i].kind == MotionKind::rapid) << where;
    if (rapid) continue;
    EXPECT_NEAR(lead_of(a[i]), lead_of(b[i]), 1e-9) << where;
    EXPECT_EQ(a[i].kind == MotionKind::dwell, b[i].kind == MotionKind::dwell) << where;
    EXPECT_NEAR(a[i].spindle_rpm, b[i].spindle_rpm, 1e-9) << where;
    if (a[i].kind != MotionKind::linear || b[i].kind != MotionKind::linear) continue;
    EXPECT_EQ(a[i].spindle, b[i].spindle) << where;
  }
  if (!a.empty() && !b.empty()) {
    EXPECT_EQ(a.back().spindle, b.back().spindle) << made.text;
  }
  return made.text;
}

std::string refusal(const std::string& text, const std::string& from, const std::string& to,
                    MachineKind kind = MachineKind::lathe) {
  const ConvertResult made = converted(text, from, to, kind);
  EXPECT_TRUE(text::has_error(made.diagnostics)) << made.text;
  EXPECT_EQ(made.text, "");
  return messages_of(made.diagnostics, text::Source("program", text));
}

void expect_has(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "no " << part << " in\n" << text;
}
void expect_has_not(const std::string& text, const std::string& part) {
  EXPECT_EQ(text.find(part), std::string::npos) << part << " in\n" << text;
}

const std::vector<std::string> kControls = {"fanuc", "mazak", "mitsubishi-m80"};

// --- to SINUMERIK

// PG, "Tapping with compensating chuck (G63)": 300 turns of 1.5 mm are 450 mm a minute.
TEST(LatheTap, FloatingBecomesG63) {
  for (const std::string& from : kControls) {
    const std::string made = expect_same_there(numbered("G84 Z-20. R-2. P500 F1.5\nZ-15.\n"), from, kSinumerik);
    expect_has(made, "G94\nG63 Z-20. F450\nG4 F0.5\nG63 Z3. M4\nG0 Z5.\nS300 M3\nG95\n");
    expect_has(made, "G63 Z-15. F450");
    const std::string by_time =
        expect_same_there(numbered("G98 G01 Z4. F100.\nG84 Z-20. R-2. F450.\nG80\nG01 Z6.\n"), from, kSinumerik);
    expect_has(by_time, "G63 Z-20. F450\nG63 Z2. M4\n");
    expect_has_not(by_time, "G95");
  }
}

TEST(LatheTap, FloatingFromTheSide) {
  const std::string made =
      expect_same_there(numbered("G00 X60. Z-5.\nG88 X20. R-2. F1.25\nW-10.\n"), "fanuc", kSinumerik);
  expect_has(made, "G63 X20. F375\nG63 X56. M4\n");
}

TEST(LatheTap, RigidBecomesG331AndG332) {
  const std::string pair = "M19\nG331 Z-20. K1.5 S300\nG4 F0.5\nG332 Z3. K1.5\n";
  const std::string tap = "G84 Z-20. R-2. P500 F1.5";
  expect_has(expect_same_there(numbered("M29 S300\n" + tap + "\n"), "fanuc", kSinumerik), pair);
  expect_has(expect_same_there(numbered(tap + " ,R1\n"), "mitsubishi-m80", kSinumerik), pair);
  expect_has(expect_same_there(numbered("G84.2 Z-20. R-2. P500 F1.5\n"), "mazak", kSinumerik), pair);
  const std::string stopped = expect_same_there(numbered("M05\nM29 S300\n" + tap + "\n"), "fanuc", kSinumerik);
  expect_has(stopped, pair + "G0 Z5.\nM5\n");
  const std::string side = expect_same_there(
      numbered("G00 X60. Z-5.\nG98\nM29 S300\nG88 X20. R-2. F450.\nZ-9.\nG80\nG99\n"), "fanuc", kSinumerik);
  expect_has(side, "G331 X20. I1.5 S300\nG332 X56. I1.5\nG0 X60.\n");
  expect_has_not(side, "M29");
  // ,R1: F is the lead in G98, too.
  const std::string by_lead = expect_same_there(numbered("G98 G01 Z4. F100.\nG84 Z-20. R-2. F1.5 ,R1\nG80\nG99\n"),
                                                "mitsubishi-m80", kSinumerik);
  expect_has(by_lead, "G331 Z-20. K1.5 S300\n");
}

TEST(LatheTap, InchesAndLoops) {
  const std::string inch =
      "%\nO1\nG20 G18 G40 G80 G97 G99 G54\nT0101\nG00 X0 Z0.2 S300 M03\nM29 S300\nG84 Z-0.8 R-0.1 F0.05\nG80\nG00 "
      "Z2.\nM30\n%\n";
  expect_has(expect_same_there(inch, "fanuc", kSinumerik), "G331 Z-0.8 K0.05 S300\nG332 Z0.1 K0.05\n");
  const std::string loop =
      numbered("#1=0\nWHILE[#1 LT 3]DO1\nG00 X[40.+#1] Z5.\nM29 S300\nG84 Z-20. R-2. F1.5\nG80\n#1=#1+1\nEND1\n");
  expect_has(expect_same_there(loop, "fanuc", kSinumerik), "WHILE");
}

TEST(LatheTap, WhatIsNotSureOfNumberedTapsIsRefused) {
  const auto refused = [](const std::string& body, const std::string& why, const std::string& from = "fanuc") {
    expect_has(refusal(numbered(body), from, kSinumerik), why);
  };
  refused("G84 Z-20. R-2. Q5000 F1.5\n", "Q5000");
  refused("M05\nG84 Z-20. R-2. F1.5\n", "does not turn by M3");
  refused("M04\nM29 S300\nG84 Z-20. R-2. F1.5\n", "does not turn by M3");
  refused("G84 Z-20. R-2. F1.5 M68\n", "M function");
  refused("G84 Z-20. R-2. F1.5 M04\n", "M04 in the same block");
  refused("/M29 S300\nG84 Z-20. R-2. F1.5\n", "M29 that does not stand right before its tap");
  refused("M29 S300\n#1=5\nG84 Z-20. R-2. F1.5\n", "M29 that does not stand right before its tap");
  refused("/G84 Z-20. R-2. F1.5\n", "a switch may skip");
  refused("G96 S100\nG84 Z-20. R-2. F1.5\nG97 S300\n", "a speed that is not known");
  refused("#1=#5021\nG84 Z[#1-20.] R-2. F1.5\n", "G84 together with");
  refused("#1=0\nWHILE[#1 LT 3]DO1\nG84 Z[-10.-#1] R-2. F1.5\nG80\n#1=#1+1\nEND1\n", "other moves each time");
  refused("#1=0\nWHILE[#1 LT 3]DO1\nS[300+#1*50]\nG84 Z-10. R-2. F1.5\nG80\n#1=#1+1\nEND1\n", "other moves each time");
  refused("G84 Z-20. R-2. F1.5 D3 ,R1\n", "D3", "mitsubishi-m80");
}

// --- from SINUMERIK

TEST(LatheTap, CalledTapsBecomeG84OrG88) {
  const std::string called = named("G17\nCYCLE84(5,0,2,-20,,1,3,,1.5,0,300,300)\n");
  expect_has(expect_same_there(called, kSinumerik, "fanuc"),
             "G00 Z2.\nS300\nM29\nG84 Z-20. R0. P1000 F1.5\nG80\nG00 Z5.\nS300 M03\n");
  expect_has(expect_same_there(called, kSinumerik, "mazak"), "G84.2 Z-20. R0. P1000 F1.5\nG80\n");
  expect_has(expect_same_there(called, kSinumerik, "mitsubishi-m80"), "G84 Z-20. R0. P1000 F1.5 ,R1\nG80\n");
  const std::string side = named(
      "G0 X60 Z-10\nG19 G94 F100\nMCALL CYCLE84(60,40,2,20,,0,5,8,,0,300,300)\nZ-20\nZ-30\nMCALL\n"
      "G1 Z-35\nG18 G95\n");
  expect_has(expect_same_there(side, kSinumerik, "fanuc"),
             "G00 X42.\nS300\nM29\nG88 X20. R0. F375.\nG80\nG00 X60.\nM05\n");
  expect_has(expect_same_there(side, kSinumerik, "mazak"), "G88.2 X20. R0. F375.\n");
  // ,R1: F is the lead.
  expect_has(expect_same_there(side, kSinumerik, "mitsubishi-m80"), "G88 X20. R0. F1.25 ,R1\n");
  const std::string made = expect_same_there(called, kSinumerik, "fanuc", MachineKind::lathe, ir::GSystem::b);
  expect_has(made, "G98 G84 Z-20. R0. P1000 F1.5\n");
}

TEST(LatheTap, FloatingCallsBecomeG84) {
  const std::string by_lead = named("G17\nCYCLE840(5,0,2,-20,,0,0,3,0,,1.5)\n");
  const std::string by_feed = named("F1.5\nG17\nCYCLE840(5,0,2,-20,,0.3,4,5,1)\n");
  for (const std::string& to : kControls) {
    const std::string made = expect_same_there(by_lead, kSinumerik, to);
    expect_has(made, "G00 Z2.\nG84 Z-20. R0. F1.5\nG80\nG00 Z5.\nS300 M03\n");
    expect_has_not(made, "M29");
    expect_has(expect_same_there(by_feed, kSinumerik, to), "G84 Z-20. R0. P300 F1.5\nG80\nG00 Z5.\nM05\n");
  }
}

TEST(LatheTap, PairsBecomeG84) {
  for (const std::string& to : kControls) {
    const std::string rigid =
        expect_same_there(named("SPOS=0\nG0 Z3\nG331 Z-20 K1.5 S300\nG4 F0.5\nG332 Z3 K1.5\n"), kSinumerik, to);
    expect_has(rigid, "M05\nG00 Z3.\nS300\n");
    expect_has(rigid, "Z-20. R0. P500 F1.5");
    expect_has_not(rigid, "SPOS");
    const std::string side =
        expect_same_there(named("G0 X60 Z-9\nM19\nG331 X20 I1.5 S300\nG332 X60 I1.5\n"), kSinumerik, to);
    expect_has(side, " X20. R0. F1.5");
    const std::string floating = expect_same_there(named("G94\nG63 Z-20 F450\nG63 Z5 M4\nG95\n"), kSinumerik, to);
    expect_has(floating, "G84 Z-20. R0. F450.\nG80\nS300 M04\n");
  }
}

TEST(LatheTap, WhatIsNotSureOfNamedTapsIsRefused) {
  const auto refused = [](const std::string& body, const std::string& why) {
    expect_has(refusal(named(body), kSinumerik, "fanuc"), why);
  };
  const std::string left = "not right-handed";
  refused("G17\nCYCLE84(5,0,2,-20,,0,3,,-1.5,0,300,300)\n", left);
  refused("G17\nCYCLE84(5,0,2,-20,,0,3,-8,,0,300,300)\n", left);
  refused("SPOS=0\nG331 Z-20 K-1.5 S300\nG332 Z5 K-1.5\n", left);
  refused("M4\nG17\nCYCLE840(5,0,2,-20,,0,0,3,0,,1.5)\n", left);
  refused("G63 Z-20 F1.5\nG63 Z5\n", left);  // the spindle goes on as it was
  refused("G17\nCYCLE84(5,0,2,-20,,0,3,,1.5,90,300,300)\n", "an angle of its spindle");
  refused("G17\nCYCLE84(5,0,2,-20,,0,3,,1.5,0,300,200)\n", "speed");
  refused("G17\nCYCLE84(5,0,2,-20,,0,,,1.5,0,300,300)\n", "SDAC");
  refused("G17\nCYCLE84(5,0,2,-20,,0,3,,1.5,0,300,300,2)\n", "CYCLE84 ");  // along Y
  refused("G17\nCYCLE84(5,0,2,-20,,0,3,,1.5,0,300,300,0,1)\n", "a unit of its own");
  refused("G17\nCYCLE84(5,0,2,-20,,0,3,,1.5,0,300,300,0,0,0,1,5)\n", "pecks");
  refused("CYCLE84(5,0,2,-20,,0,3,,1.5,0,300,300)\n", "CYCLE84 ");  // along Y
  refused("G17\nCYCLE840(5,0,2,-20,,0,4,3,11,,1.5)\n", "ENC");
  refused("G331 Z-20 K1.5 S300\nG332 Z5 K1.5\n", "not brought to a stop");
  refused("SPOS=0\nG331 Z-20 K1.5 S300\nG332 Z5 K1.25\n", "a lead");
  refused("SPOS=0\nG331 Z-20 K1.5 S300\nG332 Z5 K1.5 S200\n", "a speed");
  refused("SPOS=0\nG331 Z-20 K1.5 S300\nG332 Z8 K1.5\n", "does not lead back");
  refused("SPOS=0\nG331 Z-20 K1.5 S300\nG0 Z5\n", "without its retract");
  refused("SPOS=90\nG331 Z-20 K1.5 S300\nG332 Z5 K1.5\n", "the word SPOS=90");
  refused("G332 Z5 K1.5\n", "without G331");
  refused("G63 Z-20 F1.5\nG0 Z5\n", "without its retract");
  refused("G17\n/MCALL CYCLE84(5,0,2,-20,,0,3,,1.5,0,300,300)\nX1\nMCALL\n", "a switch may skip");
}

// F of the tap is its lead there, and the feed of the next cut here.
TEST(LatheTap, TheFeedAfterATapOfAnotherNumberedControl) {
  const std::string end = "G80\nG01 Z9.\nG00 X100.\nM30\n%\n";
  const std::string by_time =
      expect_same_there(kNumbered + "G98\nM29 S300\nG84 Z-20. R-2. F450.\nZ-9.\n" + end, "fanuc", "mitsubishi-m80");
  expect_has(by_time, "G84 Z-20. R-2. F1.5 ,R1\nZ-9.\nG80 F450.\n");
  expect_same_there(kNumbered + "G98\nG84 Z-20. R-2. F1.5 ,R1\nG01 Z9.\nG00 X100.\nM30\n%\n", "mitsubishi-m80",
                    "fanuc");
}

// A plain feed would stop at a feed hold while the spindle goes on.
TEST(LatheTap, G63IsNoPlainFeed) {
  expect_has(refusal("G17 G71 G90 G94 G40\nS300 M3\nG0 X0 Y0 Z5\nG63 Z-10 F300\nG63 Z5 M4\nG0 Z50\nM30\n", kSinumerik,
                     "fanuc", MachineKind::mill),
             "G63 on a mill");
}

// Words that the cycles of the other controls have not.
TEST(LatheTap, PecksOfATapAndAnAxisOfADrillAreRefused) {
  const std::string pecks = refusal(
      "%\nO1\nG21 G17 G90 G94 G40 G54\nT1 M06\nS300 M03\nG00 X0 Y0 Z10.\nM29 S300\nG98 G84 X1. Z-10. R2. Q3. "
      "F450.\nG80\n"
      "M30\n%\n",
      "fanuc", kSinumerik, MachineKind::mill);
  expect_has(pecks, "a tap by pecks (Q)");
  const std::string head = "G17 G71 G90 G94 G40 G54\nT1 D1 M6\nG97 S300 M3\nG0 X0 Y0 Z60 F100\n";
  for (const std::string cycle :
       {"MCALL CYCLE83(60,0,2,-20,,,5,0,,,1,1,1)\nX=$AA_IW[X]\nMCALL\n", "CYCLE84(60,0,2,-20,,0,3,,1.5,0,300,300,1)\n",
        "CYCLE840(60,0,2,-20,,0,4,3,0,,1.5,2)\n", "CYCLE840(60,0,2,-20,,0,4,3,0,,1.5,0,1)\n"})
    expect_has(refusal(head + cycle + "M30\n", kSinumerik, "fanuc", MachineKind::mill), "of its own");
}

// AXN: in G18 the first axis of the plane is Z, the second X (Cycles Programming Manual, CYCLE83).
TEST(LatheTap, CyclesAlongAnAxisOfThePlane) {
  for (const std::string to : {"fanuc", "mazak", "mitsubishi-m80"}) {
    const std::string drilled = "G0 X0 Z5 F0.2\nCYCLE83(5,0,2,-20,,,5,0,,,1,1,1)\n";
    expect_same_there(named(drilled), kSinumerik, to);
    const std::string tapped = "CYCLE84(5,0,2,-20,,0,3,,1.5,0,300,300,1)\n";
    expect_has(expect_same_there(named(tapped), kSinumerik, to), "Z-20.");
    const std::string floats = "CYCLE840(5,0,2,-20,,0,4,3,0,,1.5,1)\n";
    expect_same_there(named(floats), kSinumerik, to);
  }
}

TEST(LatheTap, AsPlainBlocks) {
  const auto plain = [](const std::string& text, const std::string& from, const std::string& to) {
    ConvertRequest request;
    request.source = text::Source("program", text);
    request.from = control(from, MachineKind::lathe);
    request.to = control(to, MachineKind::lathe);
    request.mode = ConvertMode::explicit_blocks;
    return convert(request);
  };
  const ConvertResult floating = plain(numbered("G84 Z-20. R-2. F1.5\n"), "fanuc", kSinumerik);
  EXPECT_FALSE(text::has_error(floating.diagnostics));
  expect_has(messages_of(floating.diagnostics, text::Source("", "")), "feed override and feed hold");
  EXPECT_TRUE(text::has_error(plain(numbered("M29 S300\nG84 Z-20. R-2. F1.5\n"), "fanuc", kSinumerik).diagnostics));
  EXPECT_TRUE(text::has_error(plain(numbered("G84 Z-20. R-2. F1.5 ,R1\n"), "mitsubishi-m80", "fanuc").diagnostics));
  EXPECT_TRUE(text::has_error(plain(numbered("G84.2 Z-20. R-2. F1.5\n"), "mazak", "fanuc").diagnostics));
}

// Where G91 is a mode (systems B and C), the ends of the moves that stand for a cycle are absolute all the same.
TEST(LatheCycles, WithG91AreAbsoluteMoves) {
  const std::string head = "%\nO1\nG21 G18 G40 G95 G90\nT0101\nG97 G00 X50. Z2. S1000 M03\n";
  const auto with = [&](const std::string& cycle) { return head + cycle + "\nG90\nG00 X60.\nM30\n%\n"; };
  for (const std::string cycle :
       {"G91 G77 X-4. Z-10. F0.2", "G91 G78 X-4. Z-10. F1.5", "G91 G75 X-10. Z-9. P2000 Q3000 F0.2"}) {
    const std::string text = with(cycle);
    const ConvertResult made = converted(text, "fanuc", kSinumerik, MachineKind::lathe, ir::GSystem::b);
    ASSERT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, text::Source("p", text));
    const auto before = run_text(text, find_dialect("fanuc")->control(MachineKind::lathe, ir::GSystem::b)).motions;
    const auto after =
        run_text(made.text, find_dialect(kSinumerik)->control(MachineKind::lathe, ir::GSystem::b)).motions;
    expect_same(cuts_of(before), cuts_of(after), 1e-4, made.text);
  }
}

}  // namespace
}  // namespace dripfeed::compile::test
