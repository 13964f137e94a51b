// Edges of SINUMERIK's tools on controls that number lengths and radii: the tool that counts is the one in the spindle,
// on all paths. Oracle: Programming Manual, "Tool change with M6" (T prepares, M6 changes; D belongs to the tool that
// is in).
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

using ir::MachineKind;

const std::string kHead = "G17 G90 G71 G94 F200 S1000 M3\n";

ConvertResult on_mill(const std::string& text) { return translated(text, "sinumerik-840d", "fanuc"); }
std::string made_of(const std::string& text) {
  const ConvertResult made = on_mill(text);
  EXPECT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, text::Source("program", text));
  return made.text;
}
std::string messages_from(const std::string& text) {
  const ConvertResult made = on_mill(text);
  return messages_of(made.diagnostics, text::Source("program", text));
}
void expect_has(const std::string& text, std::string_view part) {
  EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}
void expect_not(const std::string& text, std::string_view part) {
  EXPECT_EQ(text.find(part), std::string::npos) << part << "\n" << text;
}

std::string messages(const std::string& dialect, const std::string& text) {
  const ir::Control own = control(dialect, MachineKind::mill);
  const text::Source source("program", text);
  const ir::ReadResult read = find_dialect(dialect)->read(source, own);
  return messages_of(find_dialect(dialect)->validate(read.program, own, ir::Delivery::memory), source);
}

TEST(Tools, ATThatPreparesChangesNothing) {
  const std::string made =
      made_of(kHead +
              "T5 M6\nD1\nG0 X0 Y0 Z50\nT6\nG41 G1 X10\nX20\nG40 X30\nD0\nD1\nM6\nD1\nG41 X40\nX50\n"
              "G40 X60\nM30\n");
  expect_has(made, "T5 M06\nG43 H5\n");
  expect_has(made, "T6\nG41 G01 X10. D5\n");
  expect_has(made, "G49\nG43 H5\nM06\nG43 H6\nG41 X40. D6\n");
}

// D1 T6 after the change: the edge of the tool that is in, and T6 gets ready.
TEST(Tools, DWithThePreparedToolActsAtOnce) {
  const std::string next = made_of(kHead + "T5\nM6\nD1 T6\nG0 X0 Y0 Z50\nG1 Z0\nG0 Z100\nM6\nD1 T7\nZ20\nM30\n");
  expect_has(next, "M06\nT6\nG43 H5\nG00 X0.");
  expect_has(next, "M06\nG43 H6\nT7\nZ20.");
  expect_has(made_of(kHead + "T5 M6\nD1\nG0 Z50\nT6 D0\nG0 X10\nM6\nD1\nZ20\nM30\n"), "T6\nG49\n");
  expect_not(made_of(kHead + "T5 M6\nD1\nG0 Z50\nT6 D1\nG0 X10\nM6\nZ20\nM30\n"), "T6\nG43");
}

// The profile of the machine that the text is for names its tools; what it does not name is refused by its word.
TEST(Tools, ANameIsTheNumberOfTheTargetsTool) {
  for (const ConvertMode mode : {ConvertMode::macro, ConvertMode::explicit_blocks}) {
    ConvertRequest request;
    request.source = text::Source("program", kHead + "G54\nT=\"DRILL\" M6\nD1\nG0 Z50\nG1 Z0\nM30\n");
    request.from = control("sinumerik-840d", MachineKind::mill);
    request.to = control("fanuc", MachineKind::mill);
    request.mode = mode;
    EXPECT_NE(messages_of(convert(request).diagnostics, request.source).find("T=\"DRILL\""), std::string::npos);
    request.to.from_profile = true;
    request.to.tool_names = {{"DRILL", 7}};
    const ConvertResult made = convert(request);
    EXPECT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, request.source);
    expect_has(made.text, "T7 M06\nG43 H7\n");
  }
}

// A form of DPRNT that is not read, and BPRNT: their text is the source control's own.
TEST(Tools, AnOutputThatIsNotReadIsNotLeftOutSilently) {
  const std::string text = "%\nO1\nG21 G17 G90\n#1=2.\nDPRNT[X#1[44]*Y#1[3]]\nBPRNT[A#1[3]]\nM30\n%\n";
  const ConvertResult made = translated(text, "fanuc", "haas");
  const std::string messages = messages_of(made.diagnostics, text::Source("program", text));
  expect_has(messages, "DPRNT has no counterpart");
  expect_has(messages, "BPRNT has no counterpart");
}

// T2 T3 M6 of Mazak: T2 is put in and T3 made ready; T0 there: none is.
TEST(Tools, MazakNamesTheNextToolWithTheChange) {
  const std::string text = "%\nO1\nG21 G17 G90 G94\nT2 T3 M6\nG0 X0.\nT4 M6\nX1.\nN5 T05 T0 M06\nX2.\nM30\n%\n";
  std::string tools;
  for (const ir::Motion& m : run_text(text, control("mazak", MachineKind::mill)).motions)
    if (m.kind == ir::MotionKind::tool) tools += std::to_string(m.number) + " ";
  EXPECT_EQ(tools, "2 4 5 ");
  for (const std::string to : {"fanuc", "mitsubishi-m80", "sinumerik-840d"}) {
    const ConvertResult made = translated(text, "mazak", to);
    EXPECT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, text::Source("program", text));
    const std::string change = to == "sinumerik-840d" ? "T2 M6\nT3\n" : "T2 M06\nT3\n";
    expect_has(made.text, change);
    expect_not(made.text, "T0");
  }
  const std::string twice = "%\nO1\nG21 G17 G90 G94\nT2 T3 M6\nG0 X0.\nM30\n%\n";
  EXPECT_TRUE(messages("mazak", twice).empty()) << messages("mazak", twice);
  EXPECT_TRUE(messages("fanuc", twice).contains("the address T stands twice"));
}

// What starts stands in the order that the program has, in front of the move.
TEST(Tools, TheSpindleTurnsBeforeTheCoolantFlows) {
  expect_has(made_of("G17 G90 G71 G94\nG0 X0 Y0 Z50 S1000 M3 M8\nM30\n"), "S1000 M03\nG00 X0. Y0. Z50. M08\n");
}

TEST(Tools, DInTheBlockOfItsTool) {
  expect_has(made_of(kHead + "T5 D1\nM6\nG0 X0 Y0 Z50\nG41 G1 X10\nX20\nG40 X30\nM30\n"), "D5");
  // Without M6 a T brings its tool in.
  expect_has(made_of(kHead + "T5 D1\nG0 X0 Y0 Z50\nT6 D1\nG41 G1 X10\nX20\nG40 X30\nM30\n"), "G41 G01 X10. D6");
}

// MD20270 is usually 1; whoever takes the translation over is to know.
TEST(Tools, AChangeWithoutAnEdgeTakesTheFirst) {
  const std::string text = kHead + "T5 M6\nG0 X0 Y0 Z50\nT6 M6\nG0 X10 Z2\nM30\n";
  const std::string made = made_of(text);
  expect_has(made, "T5 M06\nG43 H5\nG00 X0.");
  expect_has(made, "T6 M06\nG43 H6\nG00 X10.");
  expect_has(messages_from(text), "a tool change without D is not known here: MD20270 decides");
  expect_not(messages_from(kHead + "T5 M6\nG54\nD1\nG0 X0 Y0 Z50\nM30\n"), "MD20270");
  for (const std::string rest : {"M30\n", "TRANS X10\nD1\nG0 Z2\nM30\n", "G0 X0 Y0\nZ2 D1\nM30\n"})
    expect_not(messages_from(kHead + "T5 M6\n" + rest), "MD20270");
  expect_not(messages_from(kHead + "T0 M6\nG0 Z2\nM30\n"), "MD20270");
  // Where the path turns, the edge is stated at once.
  for (const std::string rest :
       {"IF R1==1 GOTOF ON\nD1\nON: G1 Z-5\nM30\n", "IF R1==1\nD1\nENDIF\nG1 Z-5\nM30\n", "M17\n", "SUB1\nM30\n"}) {
    expect_has(messages_from(kHead + "T5 M6\n" + rest), "MD20270");
    expect_has(made_of(kHead + "T5 M6\n" + rest), "T5 M06\nG43 H5");
  }
  expect_has(made_of(kHead + "T5 M6 D1\nG0 Z50\nT0 M6\nG0 Z40\nM30\n"), "T0 M06\nG49\n");
  expect_has(messages_from(kHead + "G18\nT5 M6\nG0 X0 Y0\nZ2 D1\nM30\n"), "MD20270");
}

TEST(Tools, PathsThatDiffer) {
  const std::string either = kHead + "T5 M6 D1\nIF R1==1\nT7 M6 D1\nENDIF\nG0 X0 Y0 Z50\n";
  expect_has(messages_from(either + "G41 G1 X10\nX20\nG40 X30\nM30\n"), "a tool that is not known here");
  expect_has(messages_from(either + "D0\nD1\nG0 Z10\nM30\n"), "a tool that is not known here");
  expect_not(messages_from(either + "T8 M6\nD1\nG41 G1 X10\nX20\nG40 X30\nM30\n"), "a tool that is not known");
  expect_not(messages_from(kHead + "T5 M6 D1\nIF R1==1\nT5 M6 D1\nENDIF\nG41 G1 X10\nX20\nG40 X30\nM30\n"),
             "a tool that is not known");
  expect_has(messages_from(kHead + "T5 M6\nD1\n/T6 M6\nG0 X0 Y0\nD1\nG0 Z50\nM30\n"), "a tool that is not known here");
  expect_has(messages_from(kHead + "T5 M6\nCHANGE\nD1\nG0 Z50\nM30\n"), "which what line 3 calls may have changed");
  const std::string loop = kHead + "T5 M6\nD1\nR1=0\nAGAIN:\nG41 G1 X10\nX20\nG40 X30\nR1=R1+1\n";
  expect_has(made_of(loop + "IF R1<3 GOTOB AGAIN\nM30\n"), "G41 G01 X10. D5");
  expect_has(messages_from(loop + "T6 M6\nD1\nIF R1<3 GOTOB AGAIN\nM30\n"), "a tool that is not known here");
}

// The length is in effect before its block moves, and the tool before its length.
TEST(Tools, BeforeTheMoveOfTheirBlock) {
  expect_has(made_of(kHead + "T5 M6\nD1 G0 X0 Y0 Z2\nG0 Z100 D0\nM30\n"),
             "T5 M06\nG43 H5\nG00 X0. Y0. Z2.\nG49\nG00 Z100.\n");
  expect_has(made_of(kHead + "T5 M6 D1 G0 X0 Y0 Z2\nM30\n"), "T5 M06\nG43 H5\nG00 X0. Y0. Z2.\n");
  expect_has(made_of(kHead + "T5 M6 M3 S1000 D1\nG0 Z2\nM30\n"), "S1000 T5 M06\nM03\nG43 H5\nG00 Z2.\n");
  expect_has(made_of(kHead + "T5 M6 M3 S800 D1 G0 X0\nM30\n"), "T5 M06\nG43 H5\nG00 S800 X0. M03\n");
}

// What stands in the block of a T that prepares comes with its M6.
TEST(Tools, WhatIsPreparedComesWithM6) {
  expect_has(made_of(kHead + "T5 M6 D1\nG0 Z2\nT6 D1\nG1 Z-5\nG0 Z100\nM6\nG0 Z2\nM30\n"),
             "T6\nG01 Z-5.\nG00 Z100.\nM06\nG43 H6\nG00 Z2.\n");
  const std::string head = "G18 G90 G95 G71 DIAMON F0.2 S500 M3\n";
  ConvertRequest request;
  request.source = text::Source("program", head + "T5 D1\nM6\nG0 X100 Z5\nT7 D1\nG1 X80\nG0 X200\nM6\nG0 X90\nM30\n");
  request.from = control("sinumerik-840d", MachineKind::lathe);
  request.to = control("fanuc", MachineKind::lathe);
  const std::string made = convert(request).text;
  expect_has(made, "T0505\nG00 X100. Z5.\nG01 X80.\nG00 X200.\nT0707\nG00 X90.\n");
}

TEST(Tools, NumbersThatAreVariables) {
  expect_has(made_of(kHead + "R1=5\nT=R1\nM6\nD1\nG0 Z2\nM30\n"), "G43 H#101");
  const std::string unknown = "a tool that is not known here";
  expect_has(messages_from(kHead + "R1=5\nT=R1 M6 D1\nG0 Z2\nR1=200\nG41 G1 X5\nG40 X9\nM30\n"), unknown);
  expect_has(messages_from(kHead + "T=R1 M6\nR1=7\nG0 X0 Y0 D1\nM30\n"), unknown);
  expect_has(made_of(kHead + "R1=0\nAGAIN: R1=R1+1\nT=R1 M6\nD1\nG0 Z2\nIF R1<3 GOTOB AGAIN\nM30\n"), "G43 H#101");
  expect_has(made_of(kHead + "FOR R1=1 TO 3\nT=R1 M6\nG0 Z50 D1\nG1 G41 X10\nG40 X0\nENDFOR\nM30\n"), "X10. D#101");
}

TEST(Tools, WhatIsCalledBetween) {
  const std::string unknown = "a tool that is not known here";
  expect_has(messages_from(kHead + "T5 M6 D1\nG0 Z2\nT6\nL6\nD1\nG0 Z2\nM30\n"), unknown);
  const std::string at_once = kHead + "T5\nL6\nD1\nG0 Z2\nM30\n";
  expect_has(made_of(at_once), "T5\nM98 P6\nG43 H5 D5\nG00 Z2.\n");
  expect_has(messages_from(at_once), "which what line 3 calls may have changed");
  expect_has(messages_from(kHead + "T5 M6 D1\nL100\nT6\nG41 G1 X5\nG40 X9\nM30\n"), unknown);
  expect_has(messages_from(kHead + "IF R1==1\nT5\nELSE\nT6\nENDIF\nM6\nG0 X0 Z2\nM30\n"), unknown);
  expect_has(messages_from(kHead + "T5\nL6\nG0 Z2\nM30\n"), "a tool that a called program brings in, without D");
  // Another program of the same text changes it.
  const std::string packed = "%_N_MAIN_MPF\n" + kHead + "T5\nTOOLCH\nD1\nG0 Z2\nM30\n%_N_TOOLCH_SPF\nM6\nM17\n";
  expect_has(made_of(packed), "G43 H5");
  // A subprogram's tool is its caller's.
  expect_has(messages_from("G1 G41 X5 Y5 F100\nG40 X0 Y0\nM17\n"), "the number of the compensation (D)");
}

TEST(Tools, HolesAfterHoles) {
  const std::string head = kHead + "T5 M6 D1\nG0 X0 Y0 Z50\n";
  expect_not(made_of(head + "CYCLE81(3,2,1,-8)\nX10\nCYCLE81(50,2,1,-8)\nG0 X20\nM30\n"), "G98");
  expect_not(made_of(head + "MCALL CYCLE81(3,2,1,-8)\nX10\nMCALL\nMCALL CYCLE81(50,2,1,-8)\nX20\nMCALL\nM30\n"), "G98");
  expect_has(made_of(head + "MCALL CYCLE81(50,2,1,-8)\nX10\nMCALL\nMCALL CYCLE81(50,2,1,-9)\nX20\nMCALL\nM30\n"),
             "G98 G81 Z-9.");
  expect_has(messages_from(head + "MCALL CYCLE81(50,2,1,-8)\nSUB1\nMCALL\nM30\n"),
             "a call of another program after MCALL");
  expect_not(made_of(head + "MCALL CYCLE81(50,2,1,-8)\nX10\nG55 X20\nMCALL\nM30\n"), "G98");
  // A subprogram, or one that a called program changes: reported, not refused.
  const std::string called = "G0 X0 Y0 Z10\nCYCLE81(10,2,1,-8)\nG0 X20\nM17\n";
  expect_has(made_of(called), "Z-8.");
  expect_has(messages_from(called), "absolute or incremental is not known here");
  expect_has(messages_from(head + "SUB1\nCYCLE81(50,2,1,-8)\nG0 X20\nM30\n"), "may have changed");
}

// The reverse: H and D of the tool in the spindle are its own edge, whatever T prepares.
TEST(Tools, OffsetsOfTheToolThatIsIn) {
  const std::string head = "%\nO1\nG21 G17 G90 G94 G40 G49\n";
  const auto to_sinumerik = [&](const std::string& text) { return translated(head + text, "fanuc", "sinumerik-840d"); };
  const auto messages = [&](const std::string& text) {
    return messages_of(to_sinumerik(text).diagnostics, text::Source("program", head + text));
  };
  const std::string cut = "G41 D5 G01 X10. F100.\nX20.\nG40 D0 X30.\nG00 Z100.\n";
  const std::string made =
      to_sinumerik("T5 M06\nT6\nG00 X0 Y0\nG43 H5 Z10.\n" + cut + "M06\nG43 H6 Z10.\nM30\n%\n").text;
  expect_has(made, "T6\nG0 X0. Y0.\nZ10. D1\nG41 G1 X10. D1 F100\n");
  expect_has(made, "G40 X30.\nG0 Z100.\nM6\nZ10. D1\n");  // D0 would take the length away
  expect_has(messages("T5 M06\nT6\nG43 H6 G00 Z10.\nM30\n%\n"), "the length offset of another tool");
  expect_has(messages("T5 M06\nG43 H5 G00 Z10.\nG41 D0 G01 X10. F100.\nX20.\nG40 X30.\nM30\n%\n"),
             "compensation without a radius (D0)");
  expect_has(messages("T5 M06\nG43 H5 G00 Z10. D0\nG41 G01 X10. F100.\nX20.\nG40 X30.\nM30\n%\n"),
             "compensation without a radius (D0)");
  expect_has(messages("T5 M06\nIF[#1 EQ 1]GOTO10\nT6 M06\nN10 G43 H5 G00 Z10.\nM30\n%\n"),
             "not the same on all control-flow paths");
  expect_has(messages("T5 M06\nM98 P200\nG43 H5 G00 Z10.\nM30\n%\n"), "calls may have changed");
}

TEST(Tools, OffsetsThatAnotherWordChanges) {
  const auto messages = [](const std::string& text) {
    const std::string whole = "%\nO1\nG21 G17 G90 G94 G40\nT5 M06\nG00 G43 H5 Z50.\n" + text + "M30\n%\n";
    return messages_of(translated(whole, "fanuc", "sinumerik-840d").diagnostics, text::Source("program", whole));
  };
  expect_has(messages("G01 G41 D5 X10. F100.\nY20.\nY30. D0\nY40.\nG40 X0\n"), "compensation without a radius (D0)");
  expect_has(messages("H7\nG01 Z-7. F100.\n"), "the length offset of another tool");
  expect_has(messages("G49\nG41 D5 G01 X10. F100.\nG40 X0\n"), "a radius where the length is off");
  expect_has(messages("G41 D5 G01 X10. F100.\nG40 X0\nT6 M06\nG43 H6 Z50.\nG41 X10.\nG40 X0\n"),
             "the compensation number of another tool");
  expect_not(messages("G41 D5 G01 X10. F100.\nG40 X0\nG43 H5 D5 Z40.\nH0\n"), "error");
}

// What holds the program does so last.
TEST(Tools, StopsOfTheSpindleComeBeforeThatOfTheProgram) {
  expect_has(made_of(kHead + "T5 M6 D1\nG0 Z60 M0 M5\nM30\n"), "G00 Z60. M05\nM00\n");
  expect_has(made_of(kHead + "T5 M6 D1\nG0 Z60\nM0 M5 M9\nM30\n"), "M05\nM09\nM00\n");
}

TEST(Tools, JumpsRoundHoles) {
  const std::string head = kHead + "T5 M6 D1\nG0 X0 Y0 Z50\nR1=0\n";
  expect_has(messages_from(head + "MCALL CYCLE81(50,0,2,-8)\nX10\nIF R1==0 GOTOF ON\nX20\nMCALL\nON: G0 X30\nM30\n"),
             "a modal call that jumps lead into or out of");
  expect_has(made_of(head + "MCALL CYCLE81(50,0,2,-8)\nAGAIN: X=IC(10)\nR1=R1+1\nIF R1<3 GOTOB AGAIN\nMCALL\nM30\n"),
             "G98 G81");
  expect_not(made_of(head + "G91\nGOTOF ON\nG90\nON: Z50\nG90\nCYCLE81(50,0,2,-8)\nG0 X10\nM30\n"), "G98");
}

// Modes that a hole changes and says again are those of the paths that lead to it.
TEST(Tools, ModesAroundAHole) {
  const std::string head = kHead + "T5 M6 D1\nG0 X0 Y0 Z50\n";
  const std::string either = head + "IF R1==1\nG1 X5\nENDIF\nCYCLE81(50,0,2,-5)\n";
  expect_has(messages_from(either + "X10\nM30\n"), "the motion code in effect after a cycle");
  expect_not(messages_from(either + "G0 X10\nM30\n"), "the motion code");
  const std::string turned = head + "IF R1==1\nG18\nENDIF\nCYCLE81(50,0,2,-5)\nG0 X10\nM30\n";
  expect_has(messages_from(turned), "the plane");
  // What is only reported first is an error where paths differ after it.
  const ConvertResult both =
      on_mill(head + "SUB1\nCYCLE81(50,0,2,-5)\nIF R1==1\nG91\nENDIF\nCYCLE81(50,0,2,-5)\nG0 X10\nM30\n");
  EXPECT_TRUE(text::has_error(both.diagnostics)) << both.text;
  const std::string mode = head + "IF R1==1\nG91\nENDIF\nCYCLE81(50,0,2,-5)\nG0 X10\nM30\n";
  expect_has(messages_from(mode), "absolute or incremental");
  // A jump leads round the block that says G91.
  const std::string round = made_of(head + "GOTOF ON\nG91\nON: CYCLE81(50,0,2,-5)\nG0 X10\nM30\n");
  expect_not(round.substr(round.find("Z-5.")), "G91");
}

// Mazak: the digits say how T is divided.
TEST(Tools, SixDigitsAreThreeForTheToolAndThreeForItsOffset) {
  const auto on_lathe = [](const std::string& dialect) { return control(dialect, MachineKind::lathe); };
  const std::string text = "%\nO1\nG21 G18 G97 G99\nT001001\nG0 X50. Z2.\nT010010\nG0 X60.\nT0303\nG0 X70.\nM30\n%\n";
  ConvertRequest request;
  request.source = text::Source("program", text);
  request.from = on_lathe("mazak");
  request.to = on_lathe("fanuc");
  const ConvertResult made = convert(request);
  ASSERT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, request.source);
  expect_has(made.text, "T0101\nG00 X50.");
  expect_has(made.text, "T1010\nG00 X60.");
  expect_has(made.text, "T0303\nG00 X70.");
  std::vector<std::int64_t> tools;
  for (const ir::Motion& m : run_text(text, on_lathe("mazak")).motions)
    if (m.kind == ir::MotionKind::tool) tools.push_back(m.number);
  EXPECT_EQ(tools, (std::vector<std::int64_t>{1, 10, 3}));
}

}  // namespace
}  // namespace dripfeed::compile::test
