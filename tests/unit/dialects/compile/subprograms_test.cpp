// Subprograms in translation: their modes come from their callers, and a text of several programs stays one.
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

ConvertResult turned(const std::string& text, const std::string& from, const std::string& to,
                     ConvertMode mode = ConvertMode::macro) {
  ConvertRequest request;
  request.source = text::Source("program", text);
  request.from = control(from, ir::MachineKind::lathe);
  request.to = control(to, ir::MachineKind::lathe);
  request.mode = mode;
  return convert(request);
}

std::string complaints(const ConvertResult& result) {
  std::string out;
  for (const text::Diagnostic& d : result.diagnostics) {
    out += text::message_of(d) + "\n";
    for (const text::DiagnosticNote& note : d.notes) out += "  " + note.text + "\n";
  }
  return out;
}

// Per minute in the first call, per revolution in the second program's.
const std::string kTwoModes = R"(%
O0001
G21 G18 G40 G97 G98
T0101
G00 X50. Z2.
G01 Z0. F100.
M98 P0100
G99
M98 P0200
G00 X100.
M30
O0100
G96 S200 M03
G01 Z-10. F120.
GOTO10
N10 G97 S500
M99
O0200
G97 S500 M03
G01 X20. F0.1
N10 G00 X60.
M99
%
)";

TEST(Subprograms, TakeTheFeedModeOfTheirCallers) {
  const ConvertResult result = turned(kTwoModes, "fanuc", "sinumerik-840d");
  ASSERT_FALSE(text::has_error(result.diagnostics)) << complaints(result);
  EXPECT_NE(result.text.find("%_N_L0100_SPF\n;$PATH=/_N_SPF_DIR\nG961 S200 M3\n"), std::string::npos) << result.text;
  EXPECT_NE(result.text.find("N10 G971 S500\n"), std::string::npos) << result.text;
  EXPECT_NE(result.text.find("%_N_L0200_SPF\n;$PATH=/_N_SPF_DIR\nG97 S500 M3\n"), std::string::npos) << result.text;
}

TEST(Subprograms, OfOneTextMoveTheSameOnEveryControl) {
  const Played original = run_text(kTwoModes, control("fanuc", ir::MachineKind::lathe));
  for (const std::string& to : dialect_names()) {
    const ConvertResult result = turned(kTwoModes, "fanuc", to);
    ASSERT_FALSE(text::has_error(result.diagnostics)) << to << complaints(result);
    const Played there = run_text(result.text, control(to, ir::MachineKind::lathe));
    expect_same(real_moves(original.motions), real_moves(there.motions), 1e-6, to + "\n" + result.text);
  }
}

TEST(Subprograms, KeepTheirNumbersOnControlsThatCallByNumber) {
  const ConvertResult result = turned(kTwoModes, "fanuc", "mazak");
  ASSERT_FALSE(text::has_error(result.diagnostics)) << complaints(result);
  EXPECT_NE(result.text.find("M30\nO0100\nG96 S200 M03\n"), std::string::npos) << result.text;
  EXPECT_NE(result.text.find("M99\nO0200\n"), std::string::npos) << result.text;
  EXPECT_TRUE(result.text.ends_with("M99\n%\n")) << result.text;
  EXPECT_EQ(std::ranges::count(result.text, '%'), 2);
}

TEST(Subprograms, ComeBackFromAPunchedTape) {
  const ConvertResult there = turned(kTwoModes, "fanuc", "sinumerik-840d");
  const ConvertResult back = turned(there.text, "sinumerik-840d", "fanuc");
  ASSERT_FALSE(text::has_error(back.diagnostics)) << complaints(back);
  EXPECT_NE(back.text.find("\nO0200\n"), std::string::npos) << back.text;
  const ir::Control lathe = control("fanuc", ir::MachineKind::lathe);
  expect_same(real_moves(run_text(kTwoModes, lathe).motions), real_moves(run_text(back.text, lathe).motions), 1e-6,
              back.text);
}

TEST(Subprograms, WithCallersThatDifferAreRefusedByBothPaths) {
  const std::string text =
      "O0001\nG97 G98\nM98 P0100\nG97 G99\nM98 P0100\nM30\n"
      "O0100\nG96 S200\nG01 X10. F0.2\nM99\n";
  const ConvertResult result = turned(text, "fanuc", "sinumerik-840d");
  EXPECT_TRUE(text::has_error(result.diagnostics));
  EXPECT_TRUE(result.text.empty()) << result.text;
  EXPECT_NE(
      complaints(result).find("the feed mode is not known here: feed per minute from line 2 of O0001, or feed per "
                              "revolution from line 4 of O0001"),
      std::string::npos)
      << complaints(result);
}

TEST(Subprograms, ThatSayTheModeThemselvesNeedNoCaller) {
  const std::string text = "O0100\nG98 G96 S200\nG01 X10. F120.\nM99\n";
  const ConvertResult result = turned(text, "fanuc", "sinumerik-840d");
  EXPECT_FALSE(text::has_error(result.diagnostics)) << complaints(result);
  EXPECT_NE(result.text.find("G961 S200"), std::string::npos) << result.text;
}

TEST(Subprograms, WithoutACallerAreNotTakenAsPowerOn) {
  const std::string text = "O0100\nG96 S200\nG01 X10. F120.\nM99\n";
  const ConvertResult result = turned(text, "fanuc", "sinumerik-840d");
  EXPECT_TRUE(text::has_error(result.diagnostics)) << result.text;
  EXPECT_NE(complaints(result).find("the feed mode is not known here: what a caller outside of this text has set"),
            std::string::npos)
      << complaints(result);
}

// What the called program sets holds after the call.
TEST(Subprograms, HandTheirModesBack) {
  const std::string text =
      "O0001\nG97 G99\nM98 P0100\nG96 S150 M03\nG01 X10. F120.\nM30\n"
      "O0100\nG97 G98\nM99\n";
  const ConvertResult result = turned(text, "fanuc", "sinumerik-840d");
  ASSERT_FALSE(text::has_error(result.diagnostics)) << complaints(result);
  EXPECT_NE(result.text.find("G961 S150"), std::string::npos) << result.text;
}

TEST(Subprograms, OutsideOfTheTextMayChangeAMode) {
  const std::string text = "O0001\nG97 G98\nM98 P0100\nG96 S150 M03\nG01 X10. F120.\nM30\n";
  const ConvertResult result = turned(text, "fanuc", "sinumerik-840d");
  ASSERT_FALSE(text::has_error(result.diagnostics)) << complaints(result);
  EXPECT_NE(complaints(result).find("which what line 3 calls or does may have changed"), std::string::npos)
      << complaints(result);
}

// Two jumps that join are two paths as well.
TEST(Subprograms, AJumpOverAModeIsAPathOfItsOwn) {
  const std::string text = "O0001\nG97 G99\nIF[#100EQ1]GOTO10\nG98\nN10 G96 S150 M03\nG01 X10. F120.\nM30\n";
  const ConvertResult result = turned(text, "fanuc", "sinumerik-840d");
  EXPECT_NE(complaints(result).find("feed per minute from line 4"), std::string::npos) << complaints(result);
  EXPECT_TRUE(text::has_error(result.diagnostics));
}

// G91 of the caller: on a lathe with letters for increments each word depends on it.
TEST(Subprograms, OfSinumerikNeedToSayTheirDistanceMode) {
  const ConvertResult open = turned("G1 X10 F0.2\nM17\n", "sinumerik-840d", "fanuc");
  EXPECT_NE(complaints(open).find("absolute or incremental is not known here"), std::string::npos) << complaints(open);
  EXPECT_TRUE(text::has_error(open.diagnostics));
  const ConvertResult stated = turned("G90 DIAMON G1 X10 F0.2\nM17\n", "sinumerik-840d", "fanuc");
  EXPECT_FALSE(text::has_error(stated.diagnostics)) << complaints(stated);
}

TEST(Subprograms, RunByThemselvesReportWhatIsAssumed) {
  const std::string text = "O0100\nG21 G01 X10. F0.2\nM99\n";
  const ConvertResult result = turned(text, "fanuc", "mazak", ConvertMode::explicit_blocks);
  ASSERT_FALSE(text::has_error(result.diagnostics)) << complaints(result);
  EXPECT_NE(result.not_verified.find("which only its caller can run"), std::string::npos) << result.not_verified;
  EXPECT_NE(complaints(result).find("taken as feed per revolution at power-on; a caller may have set"),
            std::string::npos)
      << complaints(result);
  // Inch or millimetre is nothing to take for granted.
  const ConvertResult no_unit = turned("O0100\nG01 X10. F0.2\nM99\n", "fanuc", "mazak", ConvertMode::explicit_blocks);
  EXPECT_TRUE(text::has_error(no_unit.diagnostics)) << no_unit.text;
  EXPECT_NE(complaints(no_unit).find("taken as millimetre"), std::string::npos) << complaints(no_unit);
  const ConvertResult main = turned("O0100\nG21 G01 X10. F0.2\nM30\n", "fanuc", "mazak", ConvertMode::explicit_blocks);
  EXPECT_EQ(complaints(main).find("a caller"), std::string::npos) << complaints(main);
}

TEST(Subprograms, RunByThemselvesLoseNoSpeed) {
  const std::string text = "O0100\nG99 G96 S200\nG01 X10. F0.2\nM99\n";
  const ConvertResult result = turned(text, "fanuc", "mazak", ConvertMode::explicit_blocks);
  EXPECT_TRUE(text::has_error(result.diagnostics)) << result.text;
  const ConvertResult started =
      turned("O0100\nG21 G99 G97 S200 M03\nG01 X10. F0.2\nM99\n", "fanuc", "mazak", ConvertMode::explicit_blocks);
  EXPECT_FALSE(text::has_error(started.diagnostics)) << complaints(started);
}

// 800 turns a minute, not 800 metres.
TEST(Modes, AFeedCodeThatEndsSurfaceSpeedSaysSoElsewhere) {
  const std::string text =
      "G90 G18 G710 DIAMON\nT1 D1\nG96 S200 LIMS=2000 M4\nG0 X50 Z2\nG1 Z0 F0.2\nG95 S800 F0.1\nG1 X70\nG94 F90\n"
      "G1 X72\nM30\n";
  const std::vector<ir::Motion> original =
      real_moves(run_text(text, control("sinumerik-840d", ir::MachineKind::lathe)).motions);
  for (const std::string& to : dialect_names()) {
    for (const ConvertMode mode : {ConvertMode::macro, ConvertMode::explicit_blocks}) {
      const ConvertResult result = turned(text, "sinumerik-840d", to, mode);
      ASSERT_FALSE(text::has_error(result.diagnostics)) << to << complaints(result);
      expect_same(original, real_moves(run_text(result.text, control(to, ir::MachineKind::lathe)).motions), 1e-6,
                  to + "\n" + result.text);
    }
  }
  const ConvertResult fanuc = turned(text, "sinumerik-840d", "fanuc");
  EXPECT_NE(fanuc.text.find("G97 G99 S800"), std::string::npos) << fanuc.text;
  EXPECT_NE(fanuc.text.find("\nG98 F90"), std::string::npos) << fanuc.text;
}

// F0.06 after a thread of that lead is a feed that must be written.
TEST(Modes, TheLeadOfAThreadIsNoFeed) {
  const std::string text =
      "O0001\nG21 G18 G99 G97\nG00 X35. Z3.\nG01 Z1. F0.04\nG92 X28.5 Z-10. F0.06\nX26.\nG00 X40.\nG01 Z-5. F0.06\n"
      "X41.\nM30\n";
  const std::vector<ir::Motion> original = real_moves(run_text(text, control("fanuc", ir::MachineKind::lathe)).motions);
  for (const std::string& to : dialect_names()) {
    const ConvertResult result = turned(text, "fanuc", to, ConvertMode::explicit_blocks);
    ASSERT_FALSE(text::has_error(result.diagnostics)) << to << complaints(result);
    const std::vector<ir::Motion> there =
        real_moves(run_text(result.text, control(to, ir::MachineKind::lathe)).motions);
    ASSERT_FALSE(there.empty());
    EXPECT_NEAR(there.back().feed, original.back().feed, 1e-9) << to << "\n" << result.text;
    EXPECT_NEAR(there.back().feed, 0.06, 1e-9);
  }
}

// Hundredths per revolution, whole ones per minute; a subprogram of unknown mode cannot be written.
TEST(Modes, AFeedWithoutAPointCountsAsItsModeSays) {
  ConvertRequest request;
  request.from = control("fanuc", ir::MachineKind::lathe);
  request.from.semantics.decimal_mode = ir::DecimalMode::least_increment;
  request.to = control("sinumerik-840d", ir::MachineKind::lathe);
  const auto written_as = [&](const std::string& text) {
    request.source = text::Source("program", text);
    return convert(request);
  };
  const ConvertResult main =
      written_as("O0001\nG21 G18 G97 G99\nG00 X35. Z3.\nG01 Z1. F20\nG98 Z2. F200\nG99 Z3. F.3\nM30\n");
  ASSERT_FALSE(text::has_error(main.diagnostics)) << complaints(main);
  EXPECT_NE(main.text.find("Z1. F0.2\n"), std::string::npos) << main.text;
  EXPECT_NE(main.text.find("Z2. F200\n"), std::string::npos) << main.text;
  EXPECT_NE(main.text.find("Z3. F0.3\n"), std::string::npos) << main.text;
  const ConvertResult sub = written_as("O0100\nG01 Z1. F20\nM99\n");
  EXPECT_TRUE(text::has_error(sub.diagnostics)) << sub.text;
  EXPECT_NE(complaints(sub).find("the feed mode is not known here"), std::string::npos) << complaints(sub);
}

// One number in one program and another in the next would be two variables.
TEST(Subprograms, ShareTheirVariables) {
  const std::string text =
      "O0001\nG97 G99\n#501=1.\n#500=2.\nM98 P0100\nG00 X#500\nM30\n"
      "O0100\n#501=5.\nM99\n";
  const ConvertResult result = turned(text, "fanuc", "sinumerik-840d");
  EXPECT_TRUE(text::has_error(result.diagnostics)) << result.text;
  EXPECT_NE(complaints(result).find("another number in another program"), std::string::npos) << complaints(result);
}

TEST(Subprograms, OfOtherTextsAreReportedOfNumbersThatChange) {
  const std::string call = "O0001\nG97 G99\n#500=2.\nM98 P0100\nG00 X#500\nM30\n";
  EXPECT_NE(complaints(turned(call, "fanuc", "sinumerik-840d")).find("the number of #500, here R"), std::string::npos);
  const std::string alone = "O0001\nG97 G99\n#500=2.\nG00 X#500\nM30\n";
  EXPECT_EQ(complaints(turned(alone, "fanuc", "sinumerik-840d")).find("the number of"), std::string::npos);
}

// #1 of a macro is not #1 of its caller.
TEST(Subprograms, OfMacrosHaveLocalVariablesOfTheirOwn) {
  const std::string next_to_it = "O0001\nG97 G99\n#1=2.\nG65 P9100\nG00 X#1\nM30\n";
  const ConvertResult own = turned(next_to_it, "fanuc", "sinumerik-840d");
  EXPECT_FALSE(text::has_error(own.diagnostics)) << complaints(own);
  EXPECT_NE(own.text.find("DEF REAL LOCAL_1\n"), std::string::npos) << own.text;
  EXPECT_EQ(own.text.find("R1"), std::string::npos) << own.text;
  // A subprogram has those of its caller: both would be needed.
  const std::string both = "O0001\nG97 G99\n#1=2.\nG65 P9100\nM98 P9200\nG00 X#1\nM30\n";
  EXPECT_TRUE(text::has_error(turned(both, "fanuc", "sinumerik-840d").diagnostics));
  const std::string common = "O0001\nG97 G99\n#101=2.\nG65 P9100\nG00 X#101\nM30\n";
  EXPECT_FALSE(text::has_error(turned(common, "fanuc", "sinumerik-840d").diagnostics));
}

TEST(Subprograms, ThatEndTheWholeProgramAreRefused) {
  const std::string text = "O0001\nG21 G97 G99\nM98 P0100\nG00 X1.\nM30\nO0100\nG21 G00 X5.\nM30\n";
  EXPECT_TRUE(text::has_error(turned(text, "fanuc", "sinumerik-840d").diagnostics));
  EXPECT_FALSE(text::has_error(turned(text, "fanuc", "mazak").diagnostics));
}

// L9001(5) would be one argument too many (12340) for a program without PROC.
TEST(Subprograms, ThatReadNoArgumentsGetNone) {
  const std::string text =
      "%\nO0001\nG21 G17 G90 G94 G40\nG00 X0. Y0. Z5.\nG65 P9001 A5. B2.\nG65 P9002 A5.\nM30\nO9001\nG01 X7. "
      "F200.\nM99\n"
      "O9002\nG01 X#1 F200.\nM99\n%\n";
  const ConvertResult made = translated(text, "fanuc", "sinumerik-840d");
  ASSERT_FALSE(text::has_error(made.diagnostics)) << complaints(made);
  EXPECT_NE(made.text.find("\nL9001\n"), std::string::npos) << made.text;
  EXPECT_NE(made.text.find("L9002(5"), std::string::npos) << made.text;
  const auto original = moves_of(run_text(text, control("fanuc", ir::MachineKind::mill)).motions);
  const auto moves = moves_of(run_text(made.text, control("sinumerik-840d", ir::MachineKind::mill)).motions);
  expect_same(original, moves, 1e-9, made.text);
}

// Each call with arguments is a macro's there, and of these the control takes few inside one another.
TEST(Subprograms, DeeperThanMacrosGoAreReported) {
  const auto nested = [](char last) {
    std::string text = "%_N_MAIN_MPF\nG17 G90 G94 G71\nG0 X0\nAA(1)\nM30\n";
    for (char name = 'A'; name <= last; ++name) {
      text += "%_N_" + std::string(2, name) + "_SPF\nPROC " + std::string(2, name) + "(REAL PP)\nG0 X=PP\n";
      if (name != last) text += std::string(2, static_cast<char>(name + 1)) + "(PP+1)\n";
      text += "RET\n";
    }
    return text;
  };
  const ConvertResult fits = translated(nested('D'), "sinumerik-840d", "mazak");
  EXPECT_FALSE(text::has_error(fits.diagnostics)) << complaints(fits);
  const ConvertResult deep = translated(nested('E'), "sinumerik-840d", "mazak");
  EXPECT_NE(complaints(deep).find("calls are nested 5 deep, the control takes 4"), std::string::npos)
      << complaints(deep);
  EXPECT_FALSE(text::has_error(translated(nested('E'), "sinumerik-840d", "fanuc").diagnostics));
}

// 40 variables of its own, all of them alive until their sum is driven to.
std::string many_names(const std::string& letter, int step, const std::string& before, const std::string& between) {
  std::string definitions;
  std::string values;
  std::string sum = "0";
  for (int i = 1; i <= 40; ++i) {
    const std::string name = letter + "_" + std::to_string(i);
    definitions += "DEF REAL " + name + "\n";
    values += name + "=R5+" + std::to_string(i * step) + "\n";
    sum = i % 10 == 0 ? sum + "+" + name + "\nR7=R7" : sum + "+" + name;
  }
  return definitions + before + "R7=0\n" + values + between + "R7=R7+" + sum + "\nG0 X=R7\n";
}
std::string with_many_names(const std::string& called_by_sub) {
  return "%_N_MAIN_MPF\n;$PATH=/_N_MPF_DIR\n" + many_names("AA", 1, "G17 G710 G90 G94\nR5=1\n", "CUT\nR7=0\n") +
         "M30\n%_N_CUT_SPF\n;$PATH=/_N_SPF_DIR\n" + many_names("BB", 2, "", called_by_sub) + "M17\n";
}

// More names than local variables: what is left over goes to common ones that nothing alive at that time has.
TEST(Subprograms, NamesBeyondTheLocalVariablesStayApart) {
  const std::string text = with_many_names("");
  const std::vector<ir::Motion> original =
      real_moves(run_text(text, control("sinumerik-840d", ir::MachineKind::mill)).motions);
  ASSERT_EQ(original.size(), 2U);
  for (const std::string& to : dialect_names()) {
    if (to == "sinumerik-840d") continue;
    const ConvertResult result = translated(text, "sinumerik-840d", to);
    ASSERT_FALSE(text::has_error(result.diagnostics)) << to << complaints(result);
    const Played there = run_text(result.text, control(to, ir::MachineKind::mill));
    expect_same(original, real_moves(there.motions), 1e-6, to + "\n" + result.text);
  }
}

TEST(Subprograms, NamesBeyondTheLocalVariablesNeedAllCallersAndCalls) {
  const auto refused = [](const std::string& text) {
    const ConvertResult result = translated(text, "sinumerik-840d", "fanuc");
    EXPECT_TRUE(result.text.empty()) << result.text;
    return complaints(result);
  };
  const std::string needs = "variables, the control has 33";
  const std::string text = with_many_names("");
  EXPECT_NE(refused(text.substr(text.find("%_N_CUT_SPF"))).find(needs), std::string::npos) << "callers may be anywhere";
  EXPECT_NE(refused(with_many_names("NOWHERE\n")).find(needs), std::string::npos) << "it may use the same";
  EXPECT_NE(refused(with_many_names("IF R5>9\nCUT\nENDIF\n")).find(needs), std::string::npos) << "it calls itself";
}

// What its caller has in effect stays, also where a program returns only to a block of the caller (M99 P).
TEST(Subprograms, OneThatReturnsToABlockHasNoStartOfItsOwn) {
  const std::string text =
      "%\nO1\nG21 G17 G90 G94 G40 G49 G80\nG54\nG0 X0 Y0 Z50.\nG1 F100\nG91\nM98 P3\nX9.\nN10 X10.\nM30\nO3\nY3.\nM99 "
      "P10\n%\n";
  for (const std::string to : {"mazak", "sinumerik-840d"}) {
    const ConvertResult made = translated(text, "fanuc", to);
    ASSERT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, text::Source("p", text));
    expect_same(moves_of(run_text(text, control("fanuc", ir::MachineKind::mill)).motions),
                moves_of(run_text(made.text, control(to, ir::MachineKind::mill)).motions), 1e-9, made.text);
  }
}

// Parameters that are not given are their defaults at each call.
TEST(Subprograms, ParametersStartAgainAtEachCall) {
  const std::string text =
      "%_N_MAIN_MPF\nG17 G90 G71 G54 G94\nG1 X0 Y0 F100\nINNER P3\nOTHER\nM30\n%_N_INNER_SPF\nPROC INNER(REAL "
      "TT=5)\nX=TT\nTT=TT+1\nRET\n"
      "%_N_OTHER_SPF\nPROC OTHER(REAL Q=9)\nY=Q\nRET\n";
  const ConvertResult made = translated(text, "sinumerik-840d", "fanuc");
  ASSERT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, text::Source("p", text));
  EXPECT_TRUE(made.text.contains("G65 <INNER> L3\nG65 <OTHER>\n")) << made.text;
  expect_same(moves_of(run_text(text, control("sinumerik-840d", ir::MachineKind::mill)).motions),
              moves_of(run_text(made.text, control("fanuc", ir::MachineKind::mill)).motions), 1e-9, made.text);
}

}  // namespace
}  // namespace dripfeed::compile::test
