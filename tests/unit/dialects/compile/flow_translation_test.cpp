// Flow that one control writes by its own rules: RET over several programs, parts that are repeated, jumps to computed
// numbers, returns to a block of the caller. Oracle: the places that the programs name.
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

Texts with(const std::string& end) {
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

// What else RET can do is reported, and the program is left.
TEST(ReturnLevels, OtherFormsAreReported) {
  const Result played = run(kMain, with("RET(\"LATER\",1,1)"));
  EXPECT_TRUE(played.names("RET"));
  EXPECT_EQ(places(played), (std::vector<double>{0, 3, 5, 9, 11}));
}

std::vector<double> places(const std::vector<ir::Motion>& motions) {
  std::vector<double> out;
  for (const ir::Motion& m : moves_of(motions)) out.push_back(m.end[0]);
  return out;
}

// Translates as a macro, runs it there, and gives the places and the text.
std::pair<std::vector<double>, std::string> places_there(const std::string& text, const std::string& from,
                                                         const std::string& to) {
  const ConvertResult made = translated(text, from, to);
  EXPECT_FALSE(text::has_error(made.diagnostics)) << to << "\n"
                                                  << messages_of(made.diagnostics, text::Source("p", text));
  if (made.text.empty()) return {};
  return {places(run_text(made.text, control(to, ir::MachineKind::mill)).motions), made.text};
}

const std::string kOwn = "sinumerik-840d";
const std::string kOwnStart = "G17 G710 G90 G94 G40 F100\nG0 X0 Y0 Z0\n";

void expect_places_everywhere(const std::string& text, const std::vector<double>& expected) {
  EXPECT_EQ(places(run_text(text, control(kOwn, ir::MachineKind::mill)).motions), expected);
  for (const std::string to : {"fanuc", "mazak", "mitsubishi-m80"}) {
    const auto [there, written] = places_there(text, kOwn, to);
    EXPECT_EQ(there, expected) << written;
  }
}

// A part below the end of the program is run by its REPEAT only.
TEST(RepeatedParts, AfterTheEnd) {
  expect_places_everywhere(
      kOwnStart + "REPEAT LAB1 LAB2 P=2\nG0 X9\nREPEAT LAB1 LAB2\nM30\nLAB1: G0 X=IC(1)\nLAB2: G0 X=IC(2)\n",
      {0, 1, 3, 4, 6, 9, 10, 12});
}

// Run through once, then again as often as P says.
TEST(RepeatedParts, UpToTheirOwnRepeat) {
  expect_places_everywhere(kOwnStart + "LAB1: G0 X=IC(1)\nG0 X=IC(2)\nREPEAT LAB1 P=2\nG0 X20\nM30\n",
                           {0, 1, 3, 4, 6, 7, 9, 20});
  // In a loop each arrival counts again.
  expect_places_everywhere(kOwnStart + "R1=0\nWHILE R1<2\nLAB1: G0 X=IC(1)\nREPEAT LAB1 P=R1\nR1=R1+1\nENDWHILE\nM30\n",
                           {0, 1, 2, 3});
}

TEST(RepeatedParts, OneBlockAndANumberOfTimesThatIsComputed) {
  expect_places_everywhere(kOwnStart + "R1=3\nREPEATB LAB1 P=R1\nREPEATB LAB1 P=R1-3\nG0 X9\nM30\nLAB1: G0 X=IC(1)\n",
                           {0, 1, 2, 3, 9});
}

// The inner part is counted for itself.
TEST(RepeatedParts, OneInAnother) {
  expect_places_everywhere(kOwnStart +
                               "REPEAT LAB1 LAB2 P=2\nM30\n"
                               "LAB1: G0 X=IC(1)\nREPEAT LAB3 LAB4 P=2\nLAB2: G0 X=IC(10)\nM30\n"
                               "LAB3: G0 X=IC(2)\nLAB4: G0 X=IC(3)\nM30\n",
                           {0, 1, 3, 6, 8, 11, 21, 22, 24, 27, 29, 32, 42});
}

// A jump back to the first block of the program does not end the repetitions that are on.
TEST(RepeatedParts, GoOnAfterAJumpToTheFirstBlock) {
  expect_places_everywhere(
      "DEF INT TIMES=0\nBEGIN: G17 G710 G90 G94 G40 F100\nIF TIMES>0 GOTOF AFTER\nG0 X0 Y0 Z0\nREPEAT LAB1 LAB2 P=3\n"
      "AFTER: G0 X=IC(100)\nGOTOF LAB2\n"
      "LAB1: TIMES=TIMES+1\nG0 X=IC(1)\nIF TIMES==2 GOTOB BEGIN\nLAB2: G0 X=IC(10)\nM30\n",
      {0, 1, 11, 12, 112, 122, 123, 133, 233, 243});
}

// No control jumps into a loop.
TEST(RepeatedParts, OfAnotherLoopAreRefused) {
  const std::string text = kOwnStart +
                           "R1=0\nWHILE R1<1\nLAB1: G0 X=IC(1)\nLAB2: G0 X=IC(1)\nR1=R1+1\nENDWHILE\n"
                           "REPEAT LAB1 LAB2\nM30\n";
  EXPECT_TRUE(
      messages_of(translated(text, kOwn, "fanuc").diagnostics, text::Source("p", text)).contains("from another loop"));
}

const std::string kStart = "O1\nG17 G21 G90 G94 G40 G80\nG0 X0. Y0. Z0.\n";

TEST(ComputedJumps, AmongControlsWithNumberedVariables) {
  const std::string text = kStart + "#1=20\nGOTO#1\nN10 G0 X1.\nGOTO 30\nN20 G0 X2.\nGOTO[#1-10]\nN30 G0 X3.\nM30\n";
  for (const std::string to : {"mazak", "mitsubishi-m80"})
    EXPECT_EQ(places_there(text, "fanuc", to).first, (std::vector<double>{0, 2, 1, 3})) << to;
}

TEST(ComputedJumps, AreComparedWithEachNumberElsewhere) {
  const std::string text = kStart + "#1=20\nGOTO#1\nN10 G0 X1.\nGOTO 30\nN20 G0 X2.\nGOTO[#1-10]\nN30 G0 X3.\nM30\n";
  const auto [there, written] = places_there(text, "fanuc", kOwn);
  EXPECT_EQ(there, (std::vector<double>{0, 2, 1, 3})) << written;
  // What no block has stops the program, as it does there.
  const std::string lost = kStart + "#1=25\nGOTO#1\nN10 G0 X1.\nN20 G0 X2.\nM30\n";
  const ConvertResult made = translated(lost, "fanuc", kOwn);
  EXPECT_TRUE(made.text.contains("SETAL(65128")) << made.text;
}

TEST(ReturnsToABlock, OfTheCallerInTheSameText) {
  const std::string text = kStart + "M98 P200\nG0 X1.\nN30 G0 X2.\nM30\nO200\nG17 G21 G90 G94 G0 X5.\nM99 P30\n";
  const ConvertResult made = translated(text, "fanuc", kOwn);
  EXPECT_TRUE(made.text.contains("RET(\"N30\")"))
      << messages_of(made.diagnostics, text::Source("p", text)) << made.text;
  const ir::Control there = control(kOwn, ir::MachineKind::mill);
  const text::Source source("program", made.text);
  Motions motions;
  static_cast<void>(execute(find_dialect(kOwn)->read(source, there).program, there, nullptr, motions, {}));
  EXPECT_EQ(places(motions.all), (std::vector<double>{0, 5, 2})) << made.text;
}

// M99 of a main program begins it again, M99 P1 there is a jump; of a program that is called both return.
TEST(ReturnsOfAMainProgram, AreJumpsToSinumerik) {
  const auto [there, text] = places_there(
      "%\nO1\nG21 G17 G90 G54 G94\n#100=0\nN1 #100=#100+1\nG0 X#100\nIF[#100GE3]GOTO 9\nM99 P1\nN9 X20.\nM30\n%\n",
      "fanuc", kOwn);
  EXPECT_EQ(there, (std::vector<double>{1, 2, 3, 20})) << text;
  const ConvertResult again = translated("%\nO1\nG21 G17 G90 G54 G94\nG0 X0.\n/M99\nX20.\nM30\n%\n", "fanuc", kOwn);
  EXPECT_TRUE(again.text.contains("/ GOTOS\n")) << again.text;
  const ConvertResult called = translated(
      "%\nO1\nG21 G17 G90 G54 G94\nM98 P2\nM30\nO2\nG0 X1.\nIF[#500EQ1]GOTO 5\nM99\nN5 X2.\nM99\n%\n", "fanuc", kOwn);
  EXPECT_TRUE(called.text.contains("M17\n")) << called.text;
  EXPECT_FALSE(called.text.contains("GOTOS")) << called.text;
}

// G53 goes at rapid and not with G91; SUPA as programmed.
TEST(MachineMoves, AreTheSameOnlyByRapid) {
  const auto errors = [](const std::string& blocks, const std::string& from, const std::string& to) {
    const std::string text =
        from == kOwn ? "G17 G71 G90 G94\n" + blocks + "M30\n" : "%\nO1\nG17 G21 G90 G94 G54\n" + blocks + "M30\n%\n";
    return messages_of(translated(text, from, to).diagnostics, text::Source("p", text));
  };
  EXPECT_TRUE(errors("G1 X100 F200\nSUPA X50\n", kOwn, "fanuc").contains("by another motion than G0"));
  EXPECT_TRUE(errors("G1 X100. F200.\nG53 Z0.\n", "fanuc", kOwn).contains("by another motion than G0"));
  EXPECT_TRUE(errors("G0 X1.\nG91 G53 X5.\nG90\n", "fanuc", kOwn).contains("together with G91"));
  EXPECT_FALSE(errors("G1 X100. F200.\nG0 G53 Z0.\n", "fanuc", kOwn).contains("machine"));
  EXPECT_TRUE(errors("G1 X100. F200.\nG53 Z0.\n", "fanuc", "mazak").contains("by another motion than G0"));
  EXPECT_TRUE(errors("G1 X100. F200.\nG53 Z0.\n", "mitsubishi-m80", "fanuc").contains("by another motion than G0"));
  EXPECT_FALSE(errors("G1 X100. F200.\nG53 Z0.\n", "mitsubishi-m80", "mazak").contains("machine"));
  EXPECT_FALSE(errors("G1 X100. F200.\nG53 Z0.\n", "mitsubishi-m80", kOwn).contains("machine"));
  EXPECT_TRUE(errors("G0 X1.\nG91 G53 X5.\nG90\n", "mitsubishi-m80", "fanuc").contains("together with G91"));
}

// G53 leaves the tool length out; whether SUPA does, a machine data decides, and D0 says so.
TEST(MachineMoves, LeaveTheLengthOfTheToolOut) {
  const std::string head = "%\nO1\nG90 G21 G17 G94\nT1 M6\nG54 G0 X10. Y10.\nG43 Z10. H1\nG0 Z100.\n";
  const std::string mill = translated(head + "G53 Z0.\nX20.\nG53 X0.\nG49\nG53 Z0.\nM30\n%\n", "fanuc", kOwn).text;
  EXPECT_TRUE(mill.contains("SUPA Z0. D0\nD1\nX20.\nSUPA X0.\nD0\nSUPA Z0.\n")) << mill;

  ConvertRequest request;
  request.source =
      text::Source("p", "%\nO1\nG21 G18 G97 G99\nT0101\nG0 X50. Z5.\nG53 X200.\nT0100\nG53 X210.\nM30\n%\n");
  request.from = control("fanuc", ir::MachineKind::lathe);
  request.to = control(kOwn, ir::MachineKind::lathe);
  const std::string lathe = convert(request).text;
  EXPECT_TRUE(lathe.contains("SUPA X200. D0\nD1\nT1 D0\nSUPA X210.\n")) << lathe;

  const std::string sub = "%\nO2\nG53 G0 Z0\nM99\n%\n";
  EXPECT_TRUE(translated(sub, "fanuc", kOwn).text.contains("SUPA G0 Z0. D0\nD1\n"));
  EXPECT_TRUE(messages_of(translated(sub, "fanuc", kOwn).diagnostics, text::Source("p", sub))
                  .starts_with("p:3:1: warning[unknown-modal-state]: whether the tool length is in effect"));

  const std::string own = "G17 G90 G71 G94\nSUPA G0 Z0\nT1 D1\nM6\nG0 X0 Y0\nZ10\n";
  EXPECT_FALSE(text::has_error(translated(own + "SUPA Z0 D0\nM30\n", kOwn, "fanuc").diagnostics));
  EXPECT_FALSE(text::has_error(translated(own + "SUPA X0\nM30\n", kOwn, "fanuc").diagnostics));
  const std::string called = "%_N_A_MPF\n" + own + "B\nM30\n%_N_B_SPF\nSUPA G0 Z0\nM17\n";
  EXPECT_TRUE(text::has_error(translated(called, kOwn, "fanuc").diagnostics));
  const ConvertResult keeps = translated(own + "SUPA Z0\nM30\n", kOwn, "fanuc");
  ASSERT_TRUE(text::has_error(keeps.diagnostics));
  EXPECT_TRUE(messages_of(keeps.diagnostics, text::Source("p", own + "SUPA Z0\nM30\n")).starts_with("p:7:1: error"));
}

// How the machine follows the path is not a part of it: reported and left out.
TEST(Smoothing, OfAnotherControlIsLeftOut) {
  const std::string text = kOwnStart + "CYCLE832(0.01,1)\nG1 X10 F500\nCYCLE832()\nX20\nM30\n";
  for (const std::string& to : dialect_names()) {
    if (to == kOwn) continue;
    const ConvertResult made = translated(text, kOwn, to);
    EXPECT_TRUE(made.text.contains("G01 X10. F500.\nX20.\n")) << made.text;
    EXPECT_TRUE(
        messages_of(made.diagnostics, text::Source("p", text)).contains("p:3:1: warning[cannot-translate]: CYCLE832"));
  }
}

// What an operator has typed in is elsewhere on another control, and no one has typed it there.
TEST(OutsideValues, AreReportedByName) {
  const auto messages = [](const std::string& text, const std::string& from, const std::string& to) {
    return messages_of(translated(text, from, to).diagnostics, text::Source("p", text));
  };
  const std::string own = kOwnStart + "R5=3\nG0 X=R1+R5\nY=R2\nR3=R3+1\nM30\n";
  for (const std::string& to : dialect_names()) {
    if (to == kOwn) continue;
    const std::string all = messages(own, kOwn, to);
    EXPECT_TRUE(all.contains("the value of R1, which nothing here sets")) << all;
    EXPECT_TRUE(all.contains("R3, which") && all.contains("(#102, empty")) << all;
    EXPECT_FALSE(all.contains("value of R5")) << all;
  }
  const std::string macro = "%\nO1\nG21 G17 G90 G54 G94\n#102=2\nG0 X[#101+#102]\nM30\n%\n";
  EXPECT_TRUE(messages(macro, "fanuc", kOwn).contains("the value of #101, which nothing here sets"));
  EXPECT_FALSE(messages(macro, "fanuc", kOwn).contains("#102, which"));
  EXPECT_FALSE(messages(macro, "fanuc", "mazak").contains("which nothing here sets"));
  // A subprogram has them from its caller.
  EXPECT_FALSE(messages("G0 X=R1\nM17\n", kOwn, "fanuc").contains("which nothing here sets"));
}

// A part that is run again begins with what is in effect after it: positions by angle count otherwise with G91.
TEST(RepeatedParts, PolarPositionsInThemAreOfAllPaths) {
  const std::string text =
      kOwnStart + "PART:\nG111 X10 Y10\nG1 AP=90 RP=5 F100\nG91\nPARTEND:\nREPEAT PART PARTEND P=1\nM30\n";
  const ConvertResult made = translated(text, kOwn, "fanuc");
  EXPECT_TRUE(messages_of(made.diagnostics, text::Source("p", text)).contains("absolute or incremental is not known"))
      << made.text;
}

// What stands before the first head of a file is a program, too.
TEST(SeveralPrograms, TheFirstMayHaveNoHead) {
  const auto [there, text] =
      places_there("G17 G90 G71 G94 G54\nG0 X0 Y0\nSUB1\nM30\n%_N_SUB1_SPF\nG0 X5\nRET\n", kOwn, "fanuc");
  EXPECT_EQ(there, (std::vector<double>{0, 5})) << text;
}

}  // namespace
}  // namespace dripfeed::compile::test
