// Arguments of calls in translation: by position on SINUMERIK, by letter elsewhere. Each pair of programs must move the
// same on both sides, in one text and each file by itself.
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

using Files = std::map<std::string, std::string>;

constexpr std::string_view kSinumerik = "sinumerik-840d";

ir::Control mill(std::string_view dialect) { return control(std::string(dialect), ir::MachineKind::mill); }

std::vector<ir::Motion> played(const std::string& main, const Files& files, std::string_view dialect) {
  ProgramLibrary library(mill(dialect), [&](std::string_view name) -> std::optional<text::Source> {
    const auto file = files.find(std::string(name));
    if (file == files.end()) return std::nullopt;
    return text::Source(file->first, file->second);
  });
  return real_moves(run_text(main, mill(dialect), &library).motions);
}

ConvertResult file_as(const std::string& name, const std::string& text, std::string_view from, std::string_view to) {
  ConvertRequest request;
  request.source = text::Source(name, text);
  request.from = mill(from);
  request.to = mill(to);
  return convert(request);
}

// Each file by itself; calls must find each other by the names that both sides have.
void expect_files_kept(const std::string& main, const Files& files, std::string_view from, std::string_view to) {
  const ConvertResult there = file_as("MAIN", main, from, to);
  ASSERT_FALSE(text::has_error(there.diagnostics)) << messages_of(there.diagnostics, text::Source("MAIN", main));
  std::string shown = there.text;
  Files translated;
  for (const auto& [name, text] : files) {
    const ConvertResult one = file_as(name, text, from, to);
    ASSERT_FALSE(text::has_error(one.diagnostics)) << messages_of(one.diagnostics, text::Source(name, text));
    std::string own = name;
    if (name.front() == 'L' || name.front() == 'O') own.front() = to == kSinumerik ? 'L' : 'O';
    translated[own] = one.text;
    shown += "\n" + own + ":\n" + one.text;
  }
  const std::vector<ir::Motion> original = played(main, files, from);
  ASSERT_FALSE(original.empty());
  expect_same(original, played(there.text, translated, to), 1e-9, shown);
}

std::string refusal(const std::string& text, std::string_view from, std::string_view to) {
  const ConvertResult result = file_as("O9010", text, from, to);
  EXPECT_TRUE(text::has_error(result.diagnostics)) << result.text;
  return messages_of(result.diagnostics, text::Source("O9010", text));
}

const std::string kMain =
    "DEF REAL X_START=3\nG17 G710 G90 G94\nR1=2 R2=0\nG0 X=X_START Y0 Z10\nGROOVE(R1,2.6,,1)\n"
    "GROOVE(R1+X_START,,7)\nG0 X=X_START\nPLAIN\nG0 X=X_START\nL0100 P2\nG0 X=R2\nM30\n";
const Files kSubprograms = {
    {"GROOVE",
     "PROC GROOVE(REAL DEPTH, INT PASSES, REAL WIDTH=5.5, BOOL FAST)\nDEF REAL X_START\nX_START=DEPTH*2\n"
     "G0 X=X_START Y=PASSES Z=WIDTH+FAST\nPLAIN\nG0 X=X_START\nM17\n"},
    {"PLAIN", "PROC PLAIN\nDEF REAL V=8\nG0 Y=V\nM17\n"},
    {"L0100", "G90 G0 Z=IC(1)\nR2=R2+1\nM17\n"},
};

TEST(Arguments, ByPositionBecomeLettersInEachFile) {
  for (const std::string& to : dialect_names())
    if (to != kSinumerik) expect_files_kept(kMain, kSubprograms, kSinumerik, to);
  const ConvertResult main = file_as("MAIN", kMain, kSinumerik, "fanuc");
  EXPECT_NE(main.text.find("G65 <GROOVE> A#101 B2.6 I1."), std::string::npos) << main.text;
  const ConvertResult sub = file_as("GROOVE", kSubprograms.at("GROOVE"), kSinumerik, "fanuc");
  EXPECT_NE(sub.text.find("%\n<GROOVE>\nIF[#1 EQ #0]THEN #1=0.\n"), std::string::npos) << sub.text;
  EXPECT_NE(sub.text.find("IF[#3 EQ #0]THEN #3=5.5\n"), std::string::npos) << sub.text;
}

TEST(Arguments, ByPositionBecomeLettersInOneText) {
  std::string text = "%_N_MAIN_MPF\n;$PATH=/_N_MPF_DIR\n" + kMain;
  for (const auto& [name, file] : kSubprograms) text += "%_N_" + name + "_SPF\n;$PATH=/_N_SPF_DIR\n" + file;
  const std::vector<ir::Motion> original = played(text, {}, kSinumerik);
  ASSERT_EQ(original.size(), played(kMain, kSubprograms, kSinumerik).size());
  for (const std::string& to : dialect_names()) {
    const ConvertResult result = file_as("MAIN", text, kSinumerik, to);
    ASSERT_FALSE(text::has_error(result.diagnostics)) << messages_of(result.diagnostics, text::Source("MAIN", text));
    if (to != kSinumerik) expect_same(original, played(result.text, {}, to), 1e-9, result.text);
  }
}

TEST(Arguments, ThatNoVariableCanHoldAreRefusedAtTheHead) {
  const auto messages = [](const std::string& parameters) {
    return refusal("PROC CUT(" + parameters + ")\nG90 G0 X1\nM17\n", kSinumerik, "fanuc");
  };
  EXPECT_NE(messages("REAL A1_, VAR REAL RESULT").find("O9010:1:29: error"), std::string::npos)
      << messages("VAR REAL RESULT");
  EXPECT_NE(messages("VAR REAL RESULT").find("the parameter RESULT, which gives a value back (VAR),"),
            std::string::npos);
  EXPECT_NE(messages("STRING[20] NAME").find("the parameter NAME, which is not a number,"), std::string::npos);
  EXPECT_NE(messages("AXIS WHICH").find("the parameter WHICH, which is not a number,"), std::string::npos);
  std::string many = "REAL P1_";
  for (int i = 2; i <= 22; ++i) many += ", REAL P" + std::to_string(i) + "_";
  EXPECT_NE(messages(many).find("a program with more than 21 parameters"), std::string::npos) << messages(many);
}

TEST(Arguments, OfSinumerikGiveNoModesBack) {
  EXPECT_NE(refusal("PROC CUT SAVE\nG91 G0 X1\nM17\n", kSinumerik, "fanuc").find("SAVE, which gives the caller"),
            std::string::npos);
}

const std::string kMacroMain =
    "%\nO0001\nG21 G17 G90 G94\n#1=3.\n#24=50.\nG00 X#1 Y0 Z10.\nG65 P9010 A2. B5. F100.\nG00 X#1\n"
    "G65 P9010 A4. F200. Z-3.\nG65 P9010 A#1 B0. F50.\nG00 X#24\nM30\n%\n";
const std::string kMacro =
    "%\nO9010\nIF[#9EQ#0]THEN #9=77.\nG01 X#1 Y#2 Z-#26 F#9\nIF[#2EQ#0]GOTO10\nG01 Y[#2+1.]\nN10 IF[#2NE0]GOTO20\n"
    "G01 X9.\nN20 #24=#1*2.\nG01 X#24\nM99\n%\n";

// 6: an empty variable stays empty.
TEST(Arguments, ByLetterBecomeParametersInEachFile) {
  expect_files_kept(kMacroMain, {{"O9010", kMacro}}, "fanuc", kSinumerik);
  const ConvertResult sub = file_as("O9010", kMacro, "fanuc", kSinumerik);
  EXPECT_NE(sub.text.find("PROC L9010(REAL ARG_A, REAL ARG_B, "), std::string::npos) << sub.text;
  EXPECT_NE(sub.text.find("NO_B=NOT $P_SUBPAR[2]"), std::string::npos) << sub.text;
}

TEST(Arguments, ThatAreNotTakenDoNoHarm) {
  expect_files_kept("%\nO0001\nG21 G17 G90 G94\nG00 Z1.\nG65 P9010 A2. Z5. T3.\nG65 P9010 A3.\nM30\n%\n",
                    {{"O9010", "%\nO9010\nG00 X#1\nM99\n%\n"}}, "fanuc", kSinumerik);
}

TEST(Arguments, ByLetterBecomeParametersInOneText) {
  const std::string text = kMacroMain.substr(0, kMacroMain.size() - 2) + kMacro.substr(2);
  const std::vector<ir::Motion> original = played(text, {}, "fanuc");
  for (const std::string& to : dialect_names()) {
    const ConvertResult result = file_as("MAIN", text, "fanuc", to);
    ASSERT_FALSE(text::has_error(result.diagnostics)) << messages_of(result.diagnostics, text::Source("MAIN", text));
    expect_same(original, played(result.text, {}, to), 1e-9, result.text);
  }
}

TEST(Arguments, ComeBackFromSinumerik) {
  const std::string text = kMacroMain.substr(0, kMacroMain.size() - 2) + kMacro.substr(2);
  const ConvertResult there = file_as("MAIN", text, "fanuc", kSinumerik);
  const ConvertResult back = file_as("MAIN", there.text, kSinumerik, "fanuc");
  EXPECT_TRUE(text::has_error(back.diagnostics)) << back.text;  // $P_SUBPAR has no counterpart: said, not guessed
  EXPECT_NE(messages_of(back.diagnostics, text::Source("MAIN", there.text)).find("$P_SUBPAR[2]"), std::string::npos);
}

TEST(Arguments, WithoutAPointCountIncrements) {
  ConvertRequest request;
  request.source = text::Source("MAIN", "%\nO0001\nG21 G17 G90 G94\nG65 P9010 A2000 F100\nM30\n%\n");
  request.from = mill("fanuc");
  request.from.semantics.decimal_mode = ir::DecimalMode::least_increment;
  request.to = mill(kSinumerik);
  const ConvertResult result = convert(request);
  ASSERT_FALSE(text::has_error(result.diagnostics)) << messages_of(result.diagnostics, request.source);
  EXPECT_NE(result.text.find("L9010(2,,,,,,,,100)\n"), std::string::npos) << result.text;
}

TEST(Arguments, OfTheSecondKindAreRefused) {
  EXPECT_NE(refusal("%\nO0001\nG21 G17 G90 G94\nG65 P9010 A1. I2. J3. I4.\nM30\n%\n", "fanuc", kSinumerik)
                .find("arguments of the second kind"),
            std::string::npos);
}

TEST(Arguments, ThatMayBeEmptyAreNotHandedOn) {
  const auto messages = [](const std::string& body) {
    return refusal("%\nO9010\n" + body + "M99\n%\n", "fanuc", kSinumerik);
  };
  EXPECT_NE(messages("#100=#1\n").find("a value that may be empty, handed on"), std::string::npos);
  EXPECT_NE(messages("G65 P9011 A#1\n").find("an argument that may be empty"), std::string::npos);
  EXPECT_NE(messages("IF[#1EQ#2]GOTO10\nN10 G00 X1.\n").find("two variables that may be empty"), std::string::npos);
  EXPECT_NE(messages("G00 X#1\nM98 P9011\n").find("a subprogram (M98), which would share"), std::string::npos);
}

// 6: X#107 moves nothing while #107 is empty; R107 is always a number.
TEST(Arguments, InCommonVariablesAreReportedWhereTheyMayBeEmpty) {
  const auto messages = [](const std::string& body) {
    const std::string text = "%\nO9010\n" + body + "M99\n%\n";
    const ConvertResult result = file_as("O9010", text, "fanuc", kSinumerik);
    EXPECT_FALSE(text::has_error(result.diagnostics)) << messages_of(result.diagnostics, text::Source("O9010", text));
    return messages_of(result.diagnostics, text::Source("O9010", text));
  };
  EXPECT_NE(messages("G00 X#107\n")
                .find("O9010:3:6: warning[translation-not-known]: a word that is left out while #107 is empty"),
            std::string::npos)
      << messages("G00 X#107\n");
  EXPECT_EQ(messages("#107=5.\nG00 X#107\n").find("while #107"), std::string::npos);
  EXPECT_EQ(messages("G00 X[#107+1.]\n").find("while #107"), std::string::npos);
}

// 10: M98 shares the caller's local variables, G65 does not.
TEST(Arguments, AreNotTheLocalVariablesOfACallerByM98) {
  const std::string sub = "O9010\nG00 X#1\nM99\n%\n";
  const std::string head = "%\nO0001\nG21 G17 G90 G94\n";
  EXPECT_NE(refusal(head + "#1=5.\nM98 P9010\nM30\n" + sub, "fanuc", kSinumerik)
                .find("O9010:5:1: error[translation-kept-value]: a subprogram (M98) that reads the local variables"),
            std::string::npos);
  const std::string macro = head + "G65 P9010 A5.\nM30\n" + sub;
  EXPECT_FALSE(text::has_error(file_as("O9010", macro, "fanuc", kSinumerik).diagnostics));
}

// M98 would leave what the last call gave in #1: each call starts with its own, or with none.
TEST(Arguments, AreNewAtEachCallOfAProgramInAnotherFile) {
  const std::string main = "G17 G710 G90 G94\nG0 X0 Y0 Z10\nDIVE(4)\nDIVE\nDIVE\nX1\nL0100\nM30\n";
  const Files files = {{"DIVE", "PROC DIVE(REAL DEPTH=1)\nG0 Y=DEPTH Z=DEPTH\nX7 Z5\nM17\n"},
                       {"L0100", "G0 Y=IC(1)\nM17\n"}};
  ConvertRequest request;
  request.source = text::Source("MAIN", main);
  request.from = mill(kSinumerik);
  request.to = mill("fanuc");
  ProgramLibrary library(request.from, [&](std::string_view name) -> std::optional<text::Source> {
    const auto file = files.find(std::string(name));
    return file == files.end() ? std::nullopt : std::optional(text::Source(file->first, file->second));
  });
  request.library = &library;
  const ConvertResult made = convert(request);
  EXPECT_NE(made.text.find("G65 <DIVE> A4.\nG65 <DIVE>\nG65 <DIVE>\n"), std::string::npos) << made.text;
  EXPECT_NE(made.text.find("M98 P0100"), std::string::npos) << made.text;

  request.library = nullptr;
  request.source = text::Source("MAIN", "EXTERN DIVE(REAL)\nEXTERN WAIT\n" + main);
  const ConvertResult declared = convert(request);
  EXPECT_NE(declared.text.find("G65 <DIVE> A4.\nG65 <DIVE>\nG65 <DIVE>\n"), std::string::npos) << declared.text;
  EXPECT_NE(declared.text.find("M98 P0100"), std::string::npos) << declared.text;
}

TEST(Arguments, OfModalCallsAreKept) {
  expect_files_kept("%\nO0001\nG21 G17 G90 G94\nG00 X0 Y0 Z5.\nG66 P9010 A4.\nX10.\nY10.\nG67\nX0\nM30\n%\n",
                    {{"O9010", "%\nO9010\nG00 Z-#1\nZ5.\nM99\n%\n"}}, "fanuc", kSinumerik);
  expect_files_kept("G17 G710 G90 G94\nG0 X0 Y0 Z5\nMCALL DIVE(4)\nX10\nY10\nMCALL\nX0\nM30\n",
                    {{"DIVE", "PROC DIVE(REAL DEPTH)\nG0 Z=-DEPTH\nZ5\nM17\n"}}, kSinumerik, "mitsubishi-m80");
}

}  // namespace
}  // namespace dripfeed::compile::test
