// ISO parts of a SINUMERIK program on the controls whose language they are in: their blocks stand there as they do
// here. Oracle: the run of the source, and translations written down by hand.
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

using ir::MachineKind;

const std::vector<std::string> kNumbered = {"fanuc", "mazak", "mitsubishi-m80"};

ir::Control sinumerik(MachineKind kind, ir::GSystem g_system = ir::GSystem::a) {
  return find_dialect("sinumerik-840d")->control(kind, g_system);
}

ConvertResult converted(const std::string& text, const std::string& to, const ir::Control& from) {
  ConvertRequest request;
  request.source = text::Source("program", text);
  request.from = from;
  request.to = find_dialect(to)->control(from.kind, ir::GSystem::a);
  return convert(request);
}

// The same moves there; gives the translation.
std::string expect_same_there(const std::string& text, const std::string& to, const ir::Control& from) {
  SCOPED_TRACE(to);
  const ConvertResult made = converted(text, to, from);
  EXPECT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, text::Source("program", text));
  const auto a = real_moves(run_text(text, from).motions);
  const auto b = real_moves(run_text(made.text, control(to, from.kind)).motions);
  EXPECT_GE(a.size(), 3U);
  expect_same(a, b, 1.1e-3, made.text);
  return made.text;
}
std::string on_mill(const std::string& text, const std::string& to) {
  return expect_same_there(text, to, sinumerik(MachineKind::mill));
}

std::string refusal(const std::string& text, const std::string& to = "fanuc",
                    const ir::Control& from = sinumerik(MachineKind::mill)) {
  const ConvertResult made = converted(text, to, from);
  EXPECT_TRUE(text::has_error(made.diagnostics)) << made.text;
  EXPECT_EQ(made.text, "");
  return messages_of(made.diagnostics, text::Source("program", text));
}

constexpr std::string_view kHead = "G17 G90 G71 G94 F200 S1000 M3\nG0 X0 Y0 Z5\n";
std::string program(std::string_view part) { return std::string(kHead) + "G291\n" + std::string(part) + "M30\n"; }

TEST(IsoTranslation, BlocksStayWhatTheyAre) {
  const std::string text = program(
      "N100 G0 X10. Y5. (TO THE HOLES)\nG81 Z-5. R2. F100. ; drill\nX20.\nG80\n/G1 Z1.\nG02 X30. Y15. R10. F200.\n"
      "G04 P500\nG04 X1.5\nG290\nG2 X40 Y25 CR=10\n");
  for (const std::string& to : kNumbered) {
    const std::string made = on_mill(text, to);
    for (const std::string_view line :
         {"X10. Y5. (TO THE HOLES)\n", "G81 Z-5. R2. F100. (DRILL)\n", "\nX20.\n", "\nG80\n", "/G01 Z1.\n",
          "G02 X30. Y15. R10. F200.\n", "G04 P500\n", "G04 P1500\n", "G02 X40. Y25. R10."})
      EXPECT_NE(made.find(line), std::string::npos) << line << made;
  }
}

// A block that block skip may leave out is refused where it switches, and not where a part only begins or ends at it.
TEST(IsoTranslation, ABlockThatMayBeLeftOutIsNoSwitch) {
  ir::Control from = sinumerik(MachineKind::mill);
  from.semantics.starts_in_iso_mode = true;
  const std::string head = "G17 G21 G90 G94 F200. S1000 M3\n";
  expect_same_there("/M8\n" + head + "G0 X0. Y0. Z5.\nG1 X10.\nX20.\nM30\n", "fanuc", from);
  const std::string_view refused = "a switch of the language that block skip may leave out";
  EXPECT_NE(refusal(program("G1 X1.\n/G290\nX3\n")).find(refused), std::string::npos);
  const ConvertResult called =
      converted(program("G1 X1.\n/SUBP\nX2.\nG290\nX3\n"), "fanuc", sinumerik(MachineKind::mill));
  EXPECT_FALSE(text::has_error(called.diagnostics));
  EXPECT_EQ(messages_of(called.diagnostics, {"", ""}).find(refused), std::string::npos);
}

// On lathes R counts from the initial level in ISO mode, and is a level for Haas.
TEST(IsoTranslation, ROfADrillingCycleMeansTheSameLevel) {
  const std::string head = "G18 G90 G71 G95 DIAMON F0.1 S1000 M3\nG0 X0 Z20\nG291\n";
  const std::string drilled = head + "G83 Z-10. R-15. F0.1\nG80\nG290\nG0 Z50\nM30\n";
  const std::string made = expect_same_there(drilled, "haas", sinumerik(MachineKind::lathe));
  EXPECT_NE(made.find("G83 Z-10. R5. F0.1\n"), std::string::npos) << made;
  EXPECT_NE(expect_same_there(drilled, "fanuc", sinumerik(MachineKind::lathe)).find("R-15."), std::string::npos);
  const std::string open = "G18 G90 G71 G95 DIAMON F0.1 S1000 M3\nG0 X0 Z=R1\nG291\nG83 Z-10. R-15. F0.1\nG80\nM30\n";
  EXPECT_NE(refusal(open, "haas", sinumerik(MachineKind::lathe)).find("where that level is not known"),
            std::string::npos);
}

TEST(IsoTranslation, ModesGoThroughTheSwitch) {
  for (const std::string& to : kNumbered) {
    on_mill(program("G91 G1 X5.\nG290\nX5\nG291\nG90 X20.\nG290\nX25\nY5\n"), to);
    on_mill(program("G20\nG1 X1.\nG290\nX2\nG291\nG21\nX3.\nG290\nX4\n"), to);
  }
}

TEST(IsoTranslation, IncrementsOfTheControlAreReported) {
  ir::Control from = sinumerik(MachineKind::mill);
  from.semantics.iso_decimal_mode = ir::DecimalMode::least_increment;
  from.semantics.iso_decimal_mode_confirmed = true;
  const std::string made = expect_same_there(
      program("G1 X10000 Y-5000\nG83 X20000 Z-5000 R2000 Q1500\nG80\nG20 G0 X10000\nG21 G04 X2500\nG290\nG0 X3\n"),
      "fanuc", from);
  EXPECT_NE(made.find("G01 X10. Y-5."), std::string::npos) << made;
  EXPECT_NE(made.find("Z-5. R2. Q1.5"), std::string::npos) << made;
  EXPECT_NE(made.find("X1."), std::string::npos) << made;  // inch, ten times finer
  EXPECT_NE(made.find("G04 P2500"), std::string::npos) << made;
}

// T, D and H are those of the other control; where Siemens mode needs the number of the tool, it is the one in the
// spindle.
TEST(IsoTranslation, ToolsAndTheirOffsets) {
  const std::string head = "G17 G90 G71 G94 F200 S1000 M3\nT5 M6\nD1\nG0 X0 Y0 Z50\nG291\n";
  const std::string made =
      on_mill(head +
                  "G43 H5 Z10.\nG41 D5 X10.\nG1 Y10.\nX20.\nG40 X30.\nT6\nG41 X10. Y20.\nG40 Y30.\n"
                  "G49\nG290\nG41 X50\nX60\nG40 X70\nG0 Z100\nM30\n",
              "fanuc");
  for (const std::string_view line : {"G43 H5 Z10.\n", "G41 D5 X10.\n", "T6\nG41 X10. Y20.\n", "G41 X50. D5\n"})
    EXPECT_NE(made.find(line), std::string::npos) << line << made;
  const std::string other = "G290\nG41 G1 X50\nX60\nG40 X70\nM30\n";
  EXPECT_NE(refusal(head + "/T7 M6\n" + other).find("a tool that is not known here"), std::string::npos);
  const std::string either = "G17 G90 G71 G94 F200\nT5 M6\nIF R1==1\nG291\nT7 M6\nG290\nENDIF\nD1\nG0 Z10\nM30\n";
  EXPECT_NE(refusal(either).find("a tool that is not known here"), std::string::npos);
  const ConvertResult called = converted(head + "M98 P93\n" + other, "fanuc", sinumerik(MachineKind::mill));
  EXPECT_NE(messages_of(called.diagnostics, {"", ""}).find("which what line 6 calls may have changed"),
            std::string::npos);
}

// Units and kinds of feed are those on the paths that lead there; K counts holes, F hundredths per revolution.
TEST(IsoTranslation, WhatNumbersCountFollowsThePaths) {
  ir::Control from = sinumerik(MachineKind::mill);
  from.semantics.iso_decimal_mode = ir::DecimalMode::least_increment;
  from.semantics.iso_decimal_mode_confirmed = true;
  const std::string made = expect_same_there(
      program("G1 X1000 F100\nG81 X2000 Z-5000 R2000 F120\nG91 X1000 K2\nG80\nG90 G95 G1 X2000 F5\nG94 F100\n"
              "G2 X4000 Y2000 R2000\nG3 X2000 I-1000\n"),
      "fanuc", from);
  for (const std::string_view line : {"X1. F100", "F120", "X1. K2\n", "X2. F0.05", "X4. Y2. R2.", "X2. I-1."})
    EXPECT_NE(made.find(line), std::string::npos) << line << made;
  const std::string either = std::string(kHead) + "IF R1==1\nG291\nG20\nG290\nENDIF\nG291\nG1 X1000\nG290\nM30\n";
  EXPECT_NE(refusal(either, "fanuc", from).find("the unit of lengths"), std::string::npos);
  from = sinumerik(MachineKind::lathe);
  from.semantics.iso_decimal_mode = ir::DecimalMode::least_increment;
  from.semantics.iso_decimal_mode_confirmed = true;
  const std::string turned = expect_same_there(
      "G18 G90 G71 G95 DIAMON F0.2\nT5 D1\nG97 S1000 M3\nG0 X50 Z5\nG291\nG0 X42000 Z2000\nG71 U1. R0.5\n"
      "G71 P100 Q110 U400 W100 F25\nN100 G0 X20000\nG1 Z-10000\nN110 X42000\nG32 Z-20000 F200\nG290\nG0 X60\nM30\n",
      "fanuc", from);
  EXPECT_NE(turned.find("G71 P100 Q110 U0.4 W0.1 F0.25"), std::string::npos) << turned;
  EXPECT_NE(turned.find("F2."), std::string::npos) << turned;
}

// Where the tool comes after what ISO mode does is known or not taken for known.
TEST(IsoTranslation, InitialLevelsAfterIt) {
  const std::string head = "G17 G90 G94 G54 G71\nT5 M6\nD1\nG0 X0 Y0 Z50 F500 S1000 M3\n";
  const std::string holes = "MCALL CYCLE81(50,0,2,-5)\nX30\nX40\nMCALL\nX50\nR100=R101\nM30\n";
  const auto with = [&](const std::string& what) { return head + "G291\n" + what + "\nG290\n" + holes; };
  for (const std::string what : {"G92 Z10.", "G52 Z5.", "G31 Z20. F100.\nG0", "G10 L2 P1 Z5.", "G43 H5"}) {
    const ConvertResult made = converted(with(what), "fanuc", sinumerik(MachineKind::mill));
    EXPECT_EQ(made.text.find("G98"), std::string::npos) << what << made.text;
  }
  const ConvertResult skipped = converted(head + "/G0 Z60\n" + holes, "fanuc", sinumerik(MachineKind::mill));
  EXPECT_EQ(skipped.text.find("G98"), std::string::npos) << skipped.text;
  const std::string either =
      head + "IF R1==1\nG291\nG91\nG290\nENDIF\nG0 Z50\nMCALL CYCLE81(50,0,2,-5)\nX30\nMCALL\nM30\n";
  EXPECT_NE(refusal(either).find("absolute or incremental"), std::string::npos);
}

TEST(IsoTranslation, ProgramsOfOneTextDoNotMixTheirStates) {
  const std::string text =
      "%_N_MAIN_MPF\nG17 G90 G71 G94 F100\nTRANS X5\nN10 G0 X0 Y0 Z5\nMCALL CYCLE81(5,0,2,-5)\nX5\nSUB\nM30\n"
      "%_N_SUB_SPF\nG291\nG52 X1.\nN10 G1 X1.\nG52 X0\nG290\nM17\n";
  const ConvertResult made = converted(text, "fanuc", sinumerik(MachineKind::mill));
  EXPECT_EQ(messages_of(made.diagnostics, {"", ""}).find("ISO mode"), std::string::npos)
      << messages_of(made.diagnostics, {"", text});
}

TEST(IsoTranslation, CallsGoByName) {
  const std::string text = program("M98 P21 L2\nG65 P9010 X5 K1.5\nG290\nISOCALL \"O0022\"\n");
  for (const std::string& to : kNumbered) {
    const ConvertResult made = converted(text, to, sinumerik(MachineKind::mill));
    EXPECT_FALSE(text::has_error(made.diagnostics)) << messages_of(made.diagnostics, text::Source("program", text));
    EXPECT_NE(made.text.find("G65 P9010 X5. K1.5"), std::string::npos) << made.text;
    EXPECT_NE(made.text.find("M98 P0022"), std::string::npos) << made.text;
  }
}

// $C_X is what G65 passed, and 0 without it; $C_X_PROG whether it did.
TEST(IsoTranslation, MacrosReadWhatTheyWerePassed) {
  const std::string macro =
      "PROC O0010\nDEF REAL XA\nXA=$C_X\nIF $C_Z_PROG==0\nG1 X=XA Y=$C_Y\nENDIF\nIF NOT $C_A_PROG AND (0<>$C_B_PROG)\n"
      "G1 X=XA+$C_B\nENDIF\nIF $C_Z_PROG GOTOF LAST\nG1 Y=$C_Y*2 F=$C_F\nLAST: G1 Z=$C_Z[0]\nM17\n";
  const std::string main =
      program("G65 P10 X55. Y44. F100.\nG65 P10 A1. B3. Z4. F150.\nG65 P10 X-5. B3. F60.\nG65 P10 X0. F70.\n");
  const auto library_of = [](const ir::Control& control, const std::string& text) {
    return ProgramLibrary(control, [text](std::string_view name) -> std::optional<text::Source> {
      return name == "O0010" ? std::optional(text::Source("O0010.SPF", text)) : std::nullopt;
    });
  };
  const ir::Control from = sinumerik(MachineKind::mill);
  ProgramLibrary here = library_of(from, macro);
  const auto wanted = real_moves(run_text(main, from, &here).motions);
  EXPECT_EQ(wanted.size(), 9U);
  for (const std::string& to : kNumbered) {
    const ConvertResult called = converted(macro, to, from);
    EXPECT_FALSE(text::has_error(called.diagnostics))
        << messages_of(called.diagnostics, text::Source("program", macro));
    const ConvertResult calls = converted(main, to, from);
    ProgramLibrary there = library_of(control(to, MachineKind::mill), called.text);
    expect_same(wanted, real_moves(run_text(calls.text, control(to, MachineKind::mill), &there).motions), 1.1e-3,
                called.text);
  }
  // As a number it has no equal, nor has it in a program that no one calls.
  EXPECT_NE(refusal("PROC O0010\nR1=5+$C_X_PROG\nM17\n").find("$C_X_PROG"), std::string::npos);
  EXPECT_NE(refusal("G17 G90 G71 G94\nG1 X=$C_X F100\nM30\n").find("$C_X"), std::string::npos);
}

TEST(IsoTranslation, ProgramsOfIsoModeAlone) {
  ir::Control from = sinumerik(MachineKind::mill);
  from.semantics.starts_in_iso_mode = true;
  const std::string made = expect_same_there(
      "%\nO7\nG17 G90 G21 G94\nG0 X1. Y1.\nG1 X5. F100.\nG3 X5. Y5. I0. J2.\nM30\n%\n", "mazak", from);
  EXPECT_NE(made.find("G03 X5. Y5. I0. J2."), std::string::npos) << made;
}

TEST(IsoTranslation, LathesHaveTheirLettersAndTools) {
  const std::string text =
      "G18 G90 G71 G95 DIAMON F0.2\nT5 D1\nG97 S1000 M3\nG0 X50 Z5\nG291\nT0505\nG0 X40. Z2.\nG1 W-10. F0.15\nU2. "
      "W-1.\n"
      "G04 U0.5\nG290\nG0 X60\nM30\n";
  for (const std::string& to : kNumbered) {
    const std::string made = expect_same_there(text, to, sinumerik(MachineKind::lathe));
    EXPECT_NE(made.find("T0505"), std::string::npos) << made;
    EXPECT_NE(made.find("U2. W-1."), std::string::npos) << made;
  }
}

TEST(IsoTranslation, TurningCyclesOfALathe) {
  const std::string text =
      "G18 G90 G71 G95 DIAMON F0.2\nT5 D1\nG97 S1000 M3\nG0 X50 Z5\nG291\nG0 X42. Z2.\nG90 X38. Z-20. F0.2\nX36.\n"
      "G0 X42.\nG71 U1. R0.5\nG71 P100 Q110 U0.4 W0.1 F0.25\nN100 G0 X20.\nG1 Z-10.\nX40. Z-15.\nN110 X42.\n"
      "G70 P100 Q110\nG290\nG0 X60\nM30\n";
  const std::string made = expect_same_there(text, "fanuc", sinumerik(MachineKind::lathe));
  EXPECT_NE(made.find("G71 P100 Q110 U0.4 W0.1"), std::string::npos) << made;
}

// What changes its lead, and a shape whose numbers stand in two parts.
TEST(IsoTranslation, ThreadsAndShapesOfALathe) {
  const std::string head = "G18 G90 G71 G95 DIAMON F0.2\nT5 D1\nG97 S1000 M3\nG0 X50 Z5\nG291\n";
  const std::string made = expect_same_there(
      head + "G0 X40. Z5.\nG34 Z-20. F2. K0.1\nG0 X60.\nZ5.\nG32 X40. Z-10. F1.5\nG290\nG0 X60\nM30\n", "fanuc",
      sinumerik(MachineKind::lathe));
  EXPECT_NE(made.find("G34 Z-20. F2. K0.1"), std::string::npos) << made;
  // After a cycle the feed is that of its block, whatever its shape says.
  const std::string after = expect_same_there(
      head +
          "G0 X42. Z2.\nG71 U2. R0.5\nG71 P10 Q20 U0.4 W0.1 F0.3\nN10 G0 X20.\nG1 Z-10. F0.1\nN20 X42.\nG0 X60.\nZ5.\n"
          "G290\nG33 Z-10 K2\nG1 X70\nR100=R101\nM30\n",
      "fanuc", sinumerik(MachineKind::lathe));
  EXPECT_NE(after.find("F0.3\nG01 X70."), std::string::npos) << after;
  const std::string shape = "G73 U2. W2. R3\nG73 P10 Q20 U0.4 W0.1 F0.3\nN10 G0 X20.\nG1 Z-10. F0.1\nN20 X42.\n";
  EXPECT_NE(
      refusal(head + shape + "G290\nG0 X60\nG291\n" + shape + "G290\nM30\n", "fanuc", sinumerik(MachineKind::lathe))
          .find("stands in another part of the program, too,"),
      std::string::npos);
  EXPECT_NE(refusal(head + "G71 U2. R1.\nG71 P10 Q20 U0.4 W0.1 F0.3\nN10 G0 X20.\nG290\nG1 Z-10\nG291\nN20 X42.\nM30\n",
                    "fanuc", sinumerik(MachineKind::lathe))
                .find("do not all stand in its part"),
            std::string::npos);
}

// A user's macro in the block of a drilling cycle; what starts the coolant does so before the cut.
TEST(IsoTranslation, ModalMacrosAndSwitchingFunctions) {
  const ConvertResult made =
      converted(program("G66 P9010 A1.\nX5.\nG67\nG290\nG0 Z5\nMCALL CYCLE81(5,0,2,-5)\nX9\nMCALL\n"), "fanuc",
                sinumerik(MachineKind::mill));
  EXPECT_NE(made.text.find("G66 P9010 A1."), std::string::npos) << messages_of(made.diagnostics, {"", ""}) << made.text;
  const std::string cuts = on_mill(program("G1 X5. M8 M3 S200 F100.\nX6. M5 M9\nX7.\n"), "fanuc");
  EXPECT_NE(cuts.find("M08\nG01 X5. S200 F100. M03\nX6. M05\nM09\n"), std::string::npos) << cuts;
}

TEST(IsoTranslation, WhatActsAcrossTheSwitchIsRefused) {
  EXPECT_NE(refusal(program("G81 X5. Z-5. R2. F100.\nG290\nX20\n")).find("a cycle of ISO mode that is in effect"),
            std::string::npos);
  EXPECT_NE(refusal(program("G66 P9010 X5.\nG290\nG0 X20\n")).find("G66 of ISO mode, which is in effect,"),
            std::string::npos);
  EXPECT_NE(refusal(program("G16\nG290\nG0 X20\n")).find("G16 of ISO mode"), std::string::npos);
  EXPECT_NE(refusal(std::string(kHead) + "MCALL CYCLE81(5,0,2,-5)\nG291\nX5.\nG290\nMCALL\nM30\n")
                .find("a block of ISO mode after MCALL"),
            std::string::npos);
  EXPECT_NE(refusal(std::string(kHead) + "TRANS X5\nG291\nG52 X5.\nG0 X5.\nG290\nM30\n")
                .find("a frame of ISO mode together with one of Siemens mode"),
            std::string::npos);
  EXPECT_NE(refusal(program("G81 X5. Z-5. R2. F100.\n/G80\nG290\nX20\n")).find("a cycle of ISO mode that is in effect"),
            std::string::npos);
  EXPECT_NE(refusal(program("X5.\n/G290\nX20\n")).find("block skip may leave out"), std::string::npos);
  EXPECT_NE(refusal(std::string(kHead) + "/G291\nX5.\nG290\nM30\n").find("block skip may leave out"),
            std::string::npos);
  EXPECT_NE(refusal(program("G4 P1000 X2.\nG290\n")).find("a dwell with two times"), std::string::npos);
  EXPECT_NE(refusal(std::string(kHead) + "G111 X5 Y5\nG0 AP=30 RP=10\nG291\nG16\nX10. Y30.\nG15\nG290\nM30\n")
                .find("G16 of ISO mode together with poles"),
            std::string::npos);
  EXPECT_NE(refusal(program("#1=5\nG0 X#1\nG290\n")).find("Custom Macro B in ISO mode"), std::string::npos);
}

}  // namespace
}  // namespace dripfeed::compile::test
