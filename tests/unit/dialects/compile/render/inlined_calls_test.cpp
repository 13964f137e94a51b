// Calls that the lines of what they call replace, and each reason for which one stays.
#include <map>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/render/optimized.h"

namespace dripfeed::compile {
namespace {

using optimize::Rule;
using Files = std::map<std::string, std::string, std::less<>>;

struct Inlining {
  std::string_view dialect = "fanuc";
  Files files = {};        // by the name that a call has
  bool all_rules = false;  // those that are usually on; otherwise the one
};

OptimizeResult inlined(const std::string& text, const Inlining& given = {}) {
  const Dialect& dialect = *find_dialect(given.dialect);
  const ir::Control control = dialect.control(ir::MachineKind::mill, ir::GSystem::a);
  ProgramLibrary library(control, [&](std::string_view name) -> std::optional<text::Source> {
    const auto file = given.files.find(name);
    if (file == given.files.end()) return {};
    return text::Source(file->first, file->second);
  });
  OptimizeRequest request{.source = text::Source("program", text),
                          .control = control,
                          .cost = find_dialect("sinumerik-840d")->control(ir::MachineKind::mill, ir::GSystem::a).cost};
  request.library = &library;
  if (!given.all_rules) request.settings.rules = optimize::Rules::none();
  request.settings.rules.set(Rule::inlined, true);
  request.settings.own = {{ir::Bank::r, 0, 99}};
  OptimizeResult result = optimize_text(request);
  EXPECT_FALSE(text::has_error(result.diagnostics)) << text;
  return result;
}

void expect_inlined(const std::string& text, const std::string& wanted, const Inlining& given = {}) {
  const OptimizeResult result = inlined(text, given);
  EXPECT_EQ(result.obstacle, "");
  EXPECT_EQ(result.not_verified, "");
  EXPECT_EQ(result.text, wanted);
  EXPECT_TRUE(result.not_inlined.empty()) << result.not_inlined.front().why;
  ASSERT_TRUE(result.saved);
  EXPECT_GT(result.saved->ms, 0.0);
}

void expect_kept(const std::string& text, const std::string& why, const Inlining& given = {}) {
  const OptimizeResult result = inlined(text, given);
  EXPECT_EQ(result.text, text);
  ASSERT_EQ(result.not_inlined.size(), 1U) << text;
  EXPECT_EQ(result.not_inlined.front().why, why);
  EXPECT_TRUE(result.changes.empty());
}

const std::string kMain = "O0001\nG90 G17 G94 G21\nG0 X0 Y0 Z5.\n#100=0\nWHILE[#100LT5]DO1\n";
const std::string kAfter = "#100=#100+1\nEND1\nM30\n";

TEST(InlinedCalls, ALoneCallBecomesTheBlocksOfAProgramOfTheSameText) {
  const std::string point = "O0002 (POINT)\n(ITS PLACE)\nN10 #101=#100*2.\n(CUT)\nN20 G1 X#101 F100. (MM)\nN30 M99\n";
  expect_inlined(kMain + "N10 M98 P2 (ONE POINT)\n" + kAfter + point,
                 kMain +
                     "N10 (START OF O0002) (ONE POINT)\n#101=#100*2.\n(CUT)\nG1 X#101 F100. (MM)\n"
                     "(END OF O0002)\n" +
                     kAfter + point);
}

TEST(InlinedCalls, OfAnotherFile) {
  expect_inlined(kMain + "M98P0002\n" + kAfter, kMain + "(START OF O0002)\nG1 X#100 F100.\n(END OF O0002)\n" + kAfter,
                 {.files = {{"O0002", "%\nO0002\nG1 X#100 F100.\nM99\n%\n"}}});
}

TEST(InlinedCalls, AllFourControls) {
  for (const std::string_view dialect : {"fanuc", "mazak", "mitsubishi-m80", "haas"})
    expect_inlined(kMain + "M98 P2\n" + kAfter, kMain + "(START OF O0002)\nG1 X#100 F100.\n(END OF O0002)\n" + kAfter,
                   {.dialect = dialect, .files = {{"O0002", "O0002\nG1 X#100 F100.\nM99\n"}}});
  const std::string before = "G90 G17 G94 G71\nG0 X0 Y0 Z5\nR1=0\nWHILE R1<5\n", after = "R1=R1+1\nENDWHILE\nM30\n";
  for (const std::string call : {"POINT", "CALL \"POINT\"", "POINT()"})
    expect_inlined(before + call + " ; one\n" + after,
                   before + "; start of POINT ; one\nR2=R1*2\nG1 X=R2 F100 ; cut\n; end of POINT\n" + after,
                   {.dialect = "sinumerik-840d",
                    .files = {{"POINT", "PROC POINT\nN10 R2=R1*2\nN20 G1 X=R2 F100 ; cut\nN30 RET\n"}}});
}

TEST(InlinedCalls, AReturnMayStandInTheLastBlock) {
  expect_inlined(kMain + "M98 P2\n" + kAfter, kMain + "(START OF O0002)\nG1 X#100 F100.\n(END OF O0002)\n" + kAfter,
                 {.files = {{"O0002", "O0002\nG1 X#100 F100. M99\n"}}});
  expect_inlined("G0 X0\nWHILE R1<5\nPOINT\nR1=R1+1\nENDWHILE\nM30\n",
                 "G0 X0\nWHILE R1<5\n; start of POINT\nG1 X=R1 F100\n; end of POINT\nR1=R1+1\nENDWHILE\nM30\n",
                 {.dialect = "sinumerik-840d", .files = {{"POINT", "G1 X=R1 F100 M17\n"}}});
}

// M17 in a block of its own ends continuous-path mode there.
TEST(InlinedCalls, AReturnThatRestsIsInlinedWhereTheToolRestsAnyhow) {
  const std::string program = "G0 X0\nWHILE R1<5\nPOINT\nR1=R1+1\nENDWHILE\nM30\n";
  const Inlining point{.dialect = "sinumerik-840d", .files = {{"POINT", "G1 X=R1 F100\nM17\n"}}};
  const std::string why =
      "its return stops the tool between moves, where continuous-path mode may be in effect (RET does not)";
  expect_kept(program, why, point);
  expect_kept("G64\n" + program, why, point);
  expect_kept("G60\nIF R5>1\nG64\nENDIF\n" + program, why, point);
  EXPECT_EQ(inlined("G60\n" + program, point).changes.size(), 1U);
  EXPECT_EQ(inlined("DEF REAL A\nR9=2\nG90 G60\n" + program, point).changes.size(), 1U);
  expect_kept("IF R5>1\nG60\nENDIF\n" + program, why, point);
  expect_kept("G60\n" + program, why, {.dialect = "sinumerik-840d", .files = {{"POINT", "G64\nG1 X=R1 F100\nM17\n"}}});
}

TEST(InlinedCalls, OneInTheOther) {
  const Files files = {{"O0002", "O0002\n#101=#100+1.\nN5 M98 P3 (CUT)\nM99\n"},
                       {"O0003", "O0003\nG1 X#101 F100.\nM99\n"}};
  expect_inlined(kMain + "M98 P2\n" + kAfter,
                 kMain +
                     "(START OF O0002)\n#101=#100+1.\n(START OF O0003) (CUT)\nG1 X#101 F100.\n"
                     "(END OF O0003)\n(END OF O0002)\n" +
                     kAfter,
                 {.files = files});
}

TEST(InlinedCalls, LoopsGetNumbersThatAreFree) {
  const std::string body =
      "O0002\nN1 #102=0\nWHILE [#102 LT 2] DO 1 (TWICE)\nG1 X#102 F100.\n#102=#102+1\nEND 1\nM99\n";
  expect_inlined(kMain + "M98 P2\n" + kAfter,
                 kMain +
                     "(START OF O0002)\n#102=0\nWHILE [#102 LT 2] DO 2 (TWICE)\nG1 X#102 F100.\n"
                     "#102=#102+1\nEND 2\n(END OF O0002)\n" +
                     kAfter,
                 {.files = {{"O0002", body}}});
  const std::string deep =
      "O0002\nWHILE[#102LT2]DO2\nWHILE[#103LT2]DO3\nWHILE[#104LT2]DO1\nG1 X#104 F100.\n"
      "#104=#104+1\nEND1\n#103=#103+1\nEND3\n#102=#102+1\nEND2\nM99\n";
  expect_kept(kMain + "M98 P2\n" + kAfter, "its loops would lie too deep in those around the call",
              {.files = {{"O0002", deep}}});
}

TEST(InlinedCalls, BlockSkipAndEndsOfBlocksStay) {
  expect_inlined("O0001\r\nG0 X0\r\nM98 P2\r\nM30\r\n",
                 "O0001\r\nG0 X0\r\n(START OF O0002)\r\n/G1 X1. F100.\r\n/2 G1  X2.\r\n(END OF O0002)\r\n"
                 "M30\r\n",
                 {.files = {{"O0002", "O0002\n/N10 G1 X1. F100.\nN20 /2 G1  X2.\nM99\n"}}});
}

TEST(InlinedCalls, OtherRulesGoOnInTheNewText) {
  const std::string text = "G0 X0 Y0\nR1=30\nR4=0\nWHILE R4<3\nPOINT\nR4=R4+1\nENDWHILE\nM30\n";
  const OptimizeResult result =
      inlined(text, {.dialect = "sinumerik-840d",
                     .files = {{"POINT", "PROC POINT\nR2=R1*SIN(R1)\nG1 X=R2 Y=R4 F100\nRET\n"}},
                     .all_rules = true});
  EXPECT_EQ(result.text,
            "G0 X0 Y0\nR1=30 R4=0\nR2=R1*SIN(R1)\nWHILE R4<3\n; start of POINT\nG1 X=R2 Y=R4 F100\n"
            "; end of POINT\nR4=R4+1\nENDWHILE\nM30\n");
  ASSERT_GE(result.savings.size(), 2U);
  EXPECT_EQ(result.savings.front().rule, Rule::inlined);
  double sum = 0.0;
  for (const RuleSaving& one : result.savings) sum += one.saved.ms;
  ASSERT_TRUE(result.saved);
  EXPECT_NEAR(sum, result.saved->ms, 1e-9);
  // Each line has one of the given text: a body's, that of its call.
  EXPECT_EQ(result.origin_lines.size(), 10U);
  EXPECT_EQ(result.origin_lines[5], 5U);
}

TEST(InlinedCalls, ProgramsAfterTheMainOneKeepTheirBytes) {
  const std::string tail = "O0002\n g1  X#101  F100.\nM99\nO0003\n#101=#101+1\nG65 P2 A1.\nM99\n%\n";
  const std::string text = "%\nO0001\nG0 X0\n#101=1.+2.\nM98 P2\nM98 P3\nM30\n" + tail;
  const OptimizeResult result = inlined(text, {.all_rules = true});
  EXPECT_EQ(result.obstacle, "");
  EXPECT_TRUE(result.text.ends_with("M30\n" + tail)) << result.text;
  EXPECT_EQ(result.origin_lines.back(), 15U);
}

struct Refused {
  std::string call;  // the whole block
  std::string body;  // of O0002, without its number
  std::string why;
};

TEST(InlinedCalls, WhatWouldNotBeTheSameStays) {
  const std::string body = "G1 X#100 F100.\nM99\n";
  const Refused cases[] = {
      {"M98 P2 L3", body, "the call repeats it"},
      {"M98 P30002", body, "the call repeats it"},
      {"M98 P2 Q10", "N10 " + body, "the call runs a part of it"},
      {"/M98 P2", body, "block skip may leave the call out"},
      {"G0 Y1. M98 P2", body, "the block of the call has other words"},
      {"M98 P2 F50.", body, "the block of the call has other words"},
      {"G65 P2 A1.", body, "the call gives it variables of its own"},
      {"M198 P2", body, "it is a program of another device"},
      {"M98 P2", "IF[#100EQ2]GOTO10\nG1 X1. F100.\nN10 M99\n", "it jumps"},
      {"M98 P2", "G1 X[1. F100.\nM99\n", "its text has an error"},
      {"M98 P2", "/M99\n" + body, "it returns before its last block"},
      {"M98 P2", "G1 X1. F100.\n/M99\n", "block skip may leave its return out"},
      {"M98 P2", body + "G1 X3.\n", "it does not end at its only return"},
      {"M98 P2", "G1 X1. F100.\n", "it does not return"},
      {"M98 P2", "G1 X1. F100.\nM30\n", "it does not return"},
      {"M98 P2", "G66 P9010\nG1 X1. F100.\nG67\nM99\n", "it has a modal call"},
      {"M98 P2", "#1=#4114\n" + body, "it reads the number of a block"},
  };
  for (const Refused& one : cases) {
    SCOPED_TRACE(one.call + " of " + one.body);
    expect_kept(kMain + one.call + "\n" + kAfter, one.why, {.files = {{"O0002", "O0002\n" + one.body}}});
  }
  expect_kept(kMain + "M98 P2\n" + kAfter, "its text is not at hand");
  expect_kept(kMain + "M98 P#101\n" + kAfter, "which program it is, a value decides");
  expect_kept(kMain + "#3=#4114\nM98 P2\n" + kAfter, "its caller reads the number of a block",
              {.files = {{"O0002", "O0002\n" + body}}});
}

TEST(InlinedCalls, AReturnToABlockOfTheCallerLeavesTheText) {
  const std::string text = kMain + "M98 P2\n" + kAfter + "O0002\nG1 X#100 F100.\nM99 P10\n";
  const OptimizeResult result = inlined(text);
  EXPECT_EQ(result.text, text);
  EXPECT_EQ(result.obstacle, "a return to a block of the caller (line 12)");
  expect_kept(kMain + "N10 M98 P2\n" + kAfter, "it returns to a block that it names",
              {.files = {{"O0002", "O0002\nG1 X#100 F100.\nM99 P10\n"}}});
}

TEST(InlinedCalls, AProgramThatCallsItselfStays) {
  const OptimizeResult result =
      inlined(kMain + "M98 P2\n" + kAfter, {.files = {{"O0002", "O0002\n#101=#101+1\nM98 P2\nM99\n"}}});
  ASSERT_FALSE(result.not_inlined.empty());
  EXPECT_EQ(result.not_inlined.front().why, "it calls itself");
}

TEST(InlinedCalls, WhatASinumerikProgramDefinesForItself) {
  const auto main = [](const std::string& call) { return "G0 X0\nWHILE R1<5\n" + call + "\nR1=R1+1\nENDWHILE\nM30\n"; };
  const auto expect = [&](const std::string& call, const std::string& body, const std::string& why) {
    SCOPED_TRACE(call + " of " + body);
    expect_kept(main(call), why, {.dialect = "sinumerik-840d", .files = {{"POINT", body}, {"OTHER", "G4 F1\nRET\n"}}});
  };
  const std::string move = "G1 X=R1 F100\nRET\n";
  expect("POINT P3", move, "the call repeats it");
  expect("POINT(5)", "PROC POINT(REAL A)\nG1 X=A F100\nRET\n", "it takes arguments");
  expect("POINT", "PROC POINT SAVE\n" + move, "it restores the modes of its caller");
  expect("POINT", "PROC POINT DISPLOF\n" + move, "its head states how it is run");
  expect("POINT", "DEF REAL A\nA=R1\n" + move, "it defines variables of its own");
  expect("POINT", "EXTERN OTHER\nOTHER\n" + move, "it declares programs or data");
  expect("POINT", "AGAIN: R2=R2+1\nG1 X=R1 F100\nRET\n", "it has labels");
  expect("POINT", "G1 X=R1 F100\nEXECSTRING(\"R2=1\")\nRET\n", "it has a text that is executed (EXECSTRING)");
  expect("POINT", "N10 G1 X=R1 F100\nREPEATB N10 P=2\nRET\n", "it has a part of the program that is repeated (REPEAT)");
  expect("/POINT", move, "block skip may leave the call out");
  expect("X1 POINT", move, "the block of the call has other words");
}

// The caller's own names and short forms give the body's words another meaning.
TEST(InlinedCalls, ANameOfTheCallerLeavesTheCall) {
  const auto main = [](const std::string& head) { return head + "G0 X0\nWHILE R1<5\nPOINT\nR1=R1+1\nENDWHILE\nM30\n"; };
  const std::string body = "CUT_HERE\nG1 X=R1 F100\nRET\n";
  expect_kept(
      main("DEFINE CUT_HERE AS M8\n"), "its blocks would be read differently in its caller's text",
      {.dialect = "sinumerik-840d", .files = {{"POINT", body}, {"CUT_HERE", "PROC CUT_HERE SAVE\nG4 F1\nRET\n"}}});
}

TEST(InlinedCalls, ALongProgramPaysInNoPlaceAndAShortOneInLoops) {
  std::string moves;
  for (int i = 0; i < 21; ++i) moves += "G1 X" + std::to_string(i) + ". F100.\n";
  expect_kept("O0001\nG0 X0\nM98 P2\nM30\n", "its 21 blocks are more than the 20 for which it pays outside of loops",
              {.files = {{"O0002", "O0002\n" + moves + "M99\n"}}});
  EXPECT_EQ(inlined(kMain + "M98 P2\n" + kAfter, {.files = {{"O0002", "O0002\n" + moves + "M99\n"}}}).changes.size(),
            1U);
  // A jump back makes a loop as well.
  EXPECT_EQ(inlined("O0001\nG0 X0\nN10 M98 P2\n#100=#100+1\nIF[#100LT3]GOTO10\nM30\n",
                    {.files = {{"O0002", "O0002\n" + moves + "M99\n"}}})
                .changes.size(),
            1U);
}

TEST(InlinedCalls, TheRuleCanBeSwitchedOff) {
  const std::string text = kMain + "M98 P2\n" + kAfter + "O0002\nG1 X#100 F100.\nM99\n";
  OptimizeRequest request{.source = text::Source("program", text),
                          .control = find_dialect("fanuc")->control(ir::MachineKind::mill, ir::GSystem::a),
                          .cost = {}};
  request.settings.rules.set(Rule::inlined, false);
  const OptimizeResult result = optimize_text(request);
  EXPECT_EQ(result.text, text);
  EXPECT_TRUE(result.not_inlined.empty());
}

}  // namespace
}  // namespace dripfeed::compile
