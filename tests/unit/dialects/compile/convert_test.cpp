// Conversion between dialects: the same trace on the other control, and back. The programs are the corrected listings
// of two papers: a hyperbolic surface in Fanuc Custom Macro B, a turning cycle for SINUMERIK.
#include "dialects/compile/translate/convert.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

constexpr std::string_view kHyperbola = R"(%
O0002
G21 G18 G40 G97 G99
#100=100.
#101=202.4
#102=0.5
#108=196.
#109=#108/2
#103=ATAN[#109]/[#101]
#104=0
#105=#103
#106=#100*2
#110=#106/COS[#103]
T0606
G55 G00 X[#110+50.] Z[#109+50.]
S500 M03
G00 X#110 Z#109
WHILE[#103GE#104]DO1
#107=SIN[#103]/COS[#103]
G01 X[#106/COS[#103]] Z[#101*#107] F0.15
#103=#103-#102
END1
WHILE[#104LE#105]DO2
#107=SIN[#104]/COS[#104]
G01 X[#106/COS[#104]] Z-[#101*#107] F0.15
#104=#104+#102
END2
G00 X[#110+50.]
Z150.
M30
%
)";

constexpr std::string_view kTurningCycle =
    R"(PROC TURNING_CYCLE(REAL EXTD, REAL INTD, REAL ENDPZ, REAL RALL, REAL FALLX, REAL FALLZ, REAL RFR, REAL FFR, REAL RETR) SAVE
DEF INT LAYER_C, COUNTER=0
DEF REAL DEPTH
LAYER_C=((EXTD/2-INTD/2)-FALLX) DIV RALL
IF (((EXTD/2-INTD/2)-FALLX) MOD RALL) <> 0
LAYER_C=LAYER_C+1
ENDIF
DEPTH=((EXTD/2-INTD/2)-FALLX)/LAYER_C
G90 G0 X=EXTD+1 Z=1 DIAM90
G0 X=EXTD
CYCLE_START:
MSG("**ROUGHING** CURRENT LAYER:"<<COUNTER+1<<" from "<<LAYER_C)
G91 G1 X=-DEPTH F=RFR
G1 Z=(ENDPZ-1+FALLZ)
G1 X=RETR
G0 Z=-(ENDPZ-1+FALLZ)
G0 X=-RETR
GOTOF CYCLE_END
CYCLE_END:
COUNTER=COUNTER+1
IF COUNTER<LAYER_C GOTOB CYCLE_START
G90 X=EXTD+50 Z50
MSG("FINISHING")
T2 D1
G90 G0 X=INTD Z=1
G1 Z=ENDPZ F=FFR
G1 X=EXTD+1
G0 Z=1
MSG()
M17
)";

constexpr std::string_view kTurningMain = R"(EXTERN TURNING_CYCLE(REAL, REAL, REAL, REAL, REAL, REAL, REAL, REAL, REAL)
G71 G95 G40 DIAMON
T1 D1 S2700 M3
G18 G54 G96 S300 LIMS=3200
G90 G0 X50 Z50
TURNING_CYCLE(100.00, 50.00, -100.00, 2.50, 0.25, 0.25, 0.25, 0.1, 1.0)
M30
)";

// Explicit words are rounded as each control prints them.
constexpr double kRounding = 0.0006;

ConvertResult converted(std::string_view text, const std::string& from, const std::string& to, ConvertMode mode,
                        ProgramLibrary* library = nullptr) {
  ConvertRequest request;
  request.source = text::Source("program", std::string(text));
  request.from = control(from, ir::MachineKind::lathe);
  request.to = control(to, ir::MachineKind::lathe);
  request.mode = mode;
  request.library = library;
  ConvertResult out = convert(request);
  EXPECT_FALSE(text::has_error(out.diagnostics)) << messages_of(out.diagnostics, request.source);
  return out;
}

ir::Control lathe(const std::string& dialect) { return control(dialect, ir::MachineKind::lathe); }

// A library that knows the cycle and counts how often it is asked.
struct Cycle {
  int asked = 0;
  ProgramLibrary library{lathe("sinumerik-840d"), [this](std::string_view name) -> std::optional<text::Source> {
                           if (!name.contains("GUD") && !name.contains("MAC")) ++asked;  // definition files: once a run
                           if (name != "TURNING_CYCLE") return std::nullopt;
                           return text::Source("TURNING_CYCLE.SPF", std::string(kTurningCycle));
                         }};
};

TEST(Convert, SameDialectGivesTheBytes) {
  for (const std::string& dialect : dialect_names()) {
    const std::string odd = "% \r\nO12(\xD0\x9C)\n\r\rX1Y#\t??;\xFF N10 g1x-.5";
    ConvertRequest request;
    request.source = text::Source("odd", odd);
    request.from = request.to = lathe(dialect);
    EXPECT_EQ(convert(request).text, odd) << dialect;
  }
}

TEST(Convert, HyperbolaGoesToSinumerikAndBack) {
  const std::vector<ir::Motion> original = moves_of(run_text(std::string(kHyperbola), lathe("fanuc")).motions);
  ASSERT_GT(original.size(), 100U);
  const ConvertResult there = converted(kHyperbola, "fanuc", "sinumerik-840d", ConvertMode::explicit_blocks);
  const std::vector<ir::Motion> on_sinumerik = moves_of(run_text(there.text, lathe("sinumerik-840d")).motions);
  expect_same(original, on_sinumerik, kRounding, "on sinumerik");
  const ConvertResult back = converted(there.text, "sinumerik-840d", "fanuc", ConvertMode::explicit_blocks);
  expect_same(on_sinumerik, moves_of(run_text(back.text, lathe("fanuc")).motions), kRounding, "back on fanuc");
}

TEST(Convert, HyperbolaGoesAsMacroAndBack) {
  const std::vector<ir::Motion> original = moves_of(run_text(std::string(kHyperbola), lathe("fanuc")).motions);
  const ConvertResult there = converted(kHyperbola, "fanuc", "sinumerik-840d", ConvertMode::macro);
  EXPECT_LT(there.text.size(), 2000U);
  expect_same(original, moves_of(run_text(there.text, lathe("sinumerik-840d")).motions), 1e-6, there.text);
  const ConvertResult back = converted(there.text, "sinumerik-840d", "fanuc", ConvertMode::macro);
  expect_same(original, moves_of(run_text(back.text, lathe("fanuc")).motions), 1e-6, back.text);
}

TEST(Convert, ExplicitLinesKnowTheirOrigin) {
  const ConvertResult there = converted(kHyperbola, "fanuc", "sinumerik-840d", ConvertMode::explicit_blocks);
  EXPECT_EQ(std::ranges::count(there.text, '\n'), static_cast<std::ptrdiff_t>(there.origin_lines.size()));
  EXPECT_GT(std::ranges::count(there.origin_lines, 20U), 40);  // the G01 of the first flank
  EXPECT_GT(std::ranges::count(there.origin_lines, 25U), 40);
}

TEST(Convert, TurningCycleGoesToFanucAndBack) {
  Cycle cycle;
  const Played original = run_text(std::string(kTurningMain), lathe("sinumerik-840d"), &cycle.library);
  EXPECT_EQ(cycle.asked, 1);
  const std::vector<ir::Motion> moves = moves_of(original.motions);
  ASSERT_GT(moves.size(), 50U);
  const ConvertResult there =
      converted(kTurningMain, "sinumerik-840d", "fanuc", ConvertMode::explicit_blocks, &cycle.library);
  const std::vector<ir::Motion> on_fanuc = moves_of(run_text(there.text, lathe("fanuc")).motions);
  expect_same(moves, on_fanuc, kRounding, there.text);
  const ConvertResult back = converted(there.text, "fanuc", "sinumerik-840d", ConvertMode::explicit_blocks);
  expect_same(on_fanuc, moves_of(run_text(back.text, lathe("sinumerik-840d")).motions), kRounding, back.text);
  // All of the cycle comes from the line of the call.
  EXPECT_GT(std::ranges::count(there.origin_lines, 6U), 50);
}

// Whether explicit mode would do is found out by trying it.
TEST(Convert, ARefusalStatesWhetherExplicitModeDoes) {
  const auto note_of = [](const std::string& text) {
    const auto mill = [](std::string_view dialect) {
      return find_dialect(dialect)->control(ir::MachineKind::mill, ir::GSystem::a);
    };
    const ConvertResult result =
        convert({.source = text::Source("p", text), .from = mill("sinumerik-840d"), .to = mill("fanuc")});
    EXPECT_TRUE(result.text.empty());
    const auto refusal = std::ranges::find(result.diagnostics, text::Severity::error, &text::Diagnostic::severity);
    return refusal == result.diagnostics.end() || refusal->notes.empty() ? std::string() : refusal->notes.back().text;
  };
  const std::string head = "G17 G90 G71 G94\nG0 X0 Y0 Z5\nG1 Z-1 F100\n";
  EXPECT_TRUE(note_of(head + "X20 CHF=2\nY20\nM30\n").starts_with("in explicit mode the whole program can be"));
  EXPECT_TRUE(note_of(head + "T=\"FINISHING_T35 A\"\nM30\n").ends_with("cannot be translated either"));
}

// H is an increment of C on lathes of G-code system A, and a tool length on an Integrex.
TEST(Convert, AnIncrementOfCIsNoToolLength) {
  const auto turned = [](const std::string& text, std::string_view from, std::string_view to) {
    const auto mill_turn = [](std::string_view dialect) {
      return find_dialect(dialect)->control(ir::MachineKind::mill_turn, ir::GSystem::a);
    };
    return convert({.source = text::Source("p", text), .from = mill_turn(from), .to = mill_turn(to)});
  };
  const std::string fanuc = "%\nO1\nG21 G18 G98 G97 G40\nT0101\nG00 X60. Z5. C0.\nG01 W-1. H-20. F80.\nM30\n%\n";
  const ConvertResult refused = turned(fanuc, "fanuc", "mazak");
  EXPECT_TRUE(text::has_error(refused.diagnostics)) << refused.text;
  const std::string integrex = "%\nO1\nG21 G18 G94 G97 G40\nT1 M6\nG43 H1.\nG00 X60. Z5.\nM30\n%\n";
  EXPECT_TRUE(text::has_error(turned(integrex, "mazak", "fanuc").diagnostics));
}

TEST(Convert, AToolByNameHasNoCounterpartOnFanuc) {
  ConvertRequest request;
  request.source = text::Source("x", "G710 G18 G90 G95\nT=\"FINISHING_T35 A\" D1\nG0 X50 Z2\nM30\n");
  request.from = lathe("sinumerik-840d");
  request.to = lathe("fanuc");
  for (const ConvertMode mode : {ConvertMode::macro, ConvertMode::explicit_blocks}) {
    request.mode = mode;
    const ConvertResult result = convert(request);
    EXPECT_TRUE(text::has_error(result.diagnostics));
    EXPECT_TRUE(result.text.empty());
  }
}

TEST(Convert, AFaultOfTheRunIsAnError) {
  ConvertRequest request;
  request.source = text::Source("bad", "%\nO1\nG21 G99\n#1=0\nG00 X[1./#1]\nM30\n%\n");
  request.from = lathe("fanuc");
  request.to = lathe("sinumerik-840d");
  request.mode = ConvertMode::explicit_blocks;
  const ConvertResult result = convert(request);
  EXPECT_TRUE(text::has_error(result.diagnostics));
  EXPECT_TRUE(result.text.empty());
}

TEST(Convert, UnknownDialectsAreRefused) {
  ConvertRequest request;
  request.source = text::Source("x", "M30\n");
  request.from = lathe("fanuc");
  request.to.dialect = "klartext";
  EXPECT_TRUE(text::has_error(convert(request).diagnostics));
}

// Tool length offsets and compensation numbers are in no motion, and still reach the text.
TEST(Convert, OffsetsThatMotionsDoNotCarryAreKept) {
  ConvertRequest request;
  request.source =
      text::Source("mill",
                   "%\nO1\nG21 G17 G90 G94 G40 G54\nT3 M06\nG43 H3 G00 Z50.\nX0 Y0\nG41 D13 G01 X10. F200.\n"
                   "Y20.\nG40 X0\nG49 Z100.\nM30\n%\n");
  request.from = request.to = control("fanuc", ir::MachineKind::mill);
  request.mode = ConvertMode::explicit_blocks;
  const ConvertResult result = convert(request);
  EXPECT_FALSE(text::has_error(result.diagnostics)) << messages_of(result.diagnostics, request.source);
  for (const char* word : {"G43", "H3", "G41", "D13", "G40", "G49"}) {
    EXPECT_NE(result.text.find(word), std::string::npos) << word << "\n" << result.text;
  }
  const Played before = run_text(std::string(request.source.text()), request.from);
  const Played after = run_text(result.text, request.to);
  expect_same(moves_of(before.motions), moves_of(after.motions), 1e-9, result.text);
}

TEST(Convert, MachineFunctionsAndReferenceReturnsAreKept) {
  ConvertRequest request;
  request.source = text::Source("mill",
                                "%\nO1\nG21 G17 G90 G94 G40 G54\nM68\nG00 X5. Y5. Z50.\nG01 X10. F100. M77\n"
                                "G91 G28 Z0\nG90 G28 X0 Y0\nM30\n%\n");
  request.from = request.to = control("fanuc", ir::MachineKind::mill);
  request.mode = ConvertMode::explicit_blocks;
  const ConvertResult result = convert(request);
  EXPECT_FALSE(text::has_error(result.diagnostics)) << messages_of(result.diagnostics, request.source);
  const std::string& text = result.text;
  EXPECT_LT(text.find("M68"), text.find("X5."));
  EXPECT_NE(text.find("M77"), std::string::npos);
  const std::size_t first = text.find("G28 Z0");
  ASSERT_NE(first, std::string::npos) << text;
  EXPECT_LT(text.rfind("G91", first), first) << text;
  const std::size_t intermediate = text.find("X0. Y0.", first);
  ASSERT_NE(intermediate, std::string::npos) << text;
  EXPECT_NE(text.find("G28 X0. Y0.", intermediate), std::string::npos) << text;
  const Played before = run_text(std::string(request.source.text()), request.from);
  expect_same(moves_of(before.motions), moves_of(run_text(text, request.to).motions), 1e-9, text);
}

// What is not carried out would be left out of the plain blocks.
TEST(Convert, WhatWouldBeLostIsAnError) {
  ConvertRequest request;
  request.source = text::Source("mill",
                                "%\nO1\nG21 G17 G90 G94 G40 G54\nG00 X5. Y5. Z50.\n"
                                "G06.2 P4 X20. Y5. K0 R1.\nX25.\nG01 X30. F100.\nM30\n%\n");
  request.from = request.to = control("fanuc", ir::MachineKind::mill);
  request.mode = ConvertMode::explicit_blocks;
  const ConvertResult result = convert(request);
  EXPECT_TRUE(text::has_error(result.diagnostics));
  EXPECT_TRUE(result.text.empty());
}

TEST(Convert, CyclesBecomeTheirMoves) {
  ConvertRequest request;
  request.source = text::Source("mill",
                                "%\nO1\nG21 G17 G90 G94 G40 G54\nG00 X5. Y5. Z50.\n"
                                "G83 G99 Z-10. R2. Q5. F100.\nX20.\nG80\nM30\n%\n");
  request.from = request.to = control("fanuc", ir::MachineKind::mill);
  request.mode = ConvertMode::explicit_blocks;
  const ConvertResult result = convert(request);
  EXPECT_FALSE(text::has_error(result.diagnostics)) << messages_of(result.diagnostics, request.source);
  EXPECT_EQ(result.text.find("G83"), std::string::npos) << result.text;
  expect_same(moves_of(run_text(std::string(request.source.text()), request.from).motions),
              moves_of(run_text(result.text, request.to).motions), 1e-9, result.text);
}

TEST(Library, AsksOnceAndRemembersWhatIsMissing) {
  Cycle cycle;
  const ir::Program* found = cycle.library.find("TURNING_CYCLE");
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(cycle.library.find("TURNING_CYCLE"), found);
  EXPECT_EQ(cycle.library.find("L100"), nullptr);
  EXPECT_EQ(cycle.library.find("L100"), nullptr);
  EXPECT_EQ(cycle.asked, 2);
  ASSERT_EQ(cycle.library.loaded().size(), 1U);
  EXPECT_EQ(cycle.library.loaded()[0]->name, "TURNING_CYCLE");
}

// G68 is about a point and besides the shift; ROT replaces and AROT adds to it: one is never printed for the other, and
// what is printed moves the same.
TEST(Convert, AFrameMovesTheSameWhateverItIsPrintedAs) {
  for (const std::string& to : dialect_names()) {
    if (to == "sinumerik-840d") continue;
    for (const std::string code : {"AROT Z30", "ROT Z30", "ROT", "MIRROR X0", "AMIRROR X0", "SCALE X2 Y2 Z2"}) {
      ConvertRequest request;
      request.source = text::Source("frames", "G710 G17 G90 G94 G40\nTRANS X1\n" + code + "\nG0 X10 Y5 Z5\nM30\n");
      request.from = control("sinumerik-840d", ir::MachineKind::mill);
      request.to = control(to, ir::MachineKind::mill);
      request.mode = ConvertMode::macro;
      const ConvertResult result = convert(request);
      ASSERT_FALSE(text::has_error(result.diagnostics)) << code << "\n"
                                                        << messages_of(result.diagnostics, request.source);
      expect_same(moves_of(run_text(std::string(request.source.text()), request.from).motions),
                  moves_of(run_text(result.text, request.to).motions), 1e-9, result.text);
    }
  }
}

// X1000 without a point is a tenth of an inch, or one millimetre, where increments are counted.
TEST(Convert, LeastIncrementsCountInTheUnitInEffect) {
  ConvertRequest request;
  request.source = text::Source("program", "%\nO1\nG20 G17 G90 G94\nG00 X1000\nG21\nX1000\nM30\n%\n");
  request.from = control("fanuc", ir::MachineKind::mill);
  request.from.semantics.decimal_mode = ir::DecimalMode::least_increment;
  request.to = control("sinumerik-840d", ir::MachineKind::mill);
  const ConvertResult result = convert(request);
  EXPECT_TRUE(result.text.contains("X0.1\n")) << result.text;
  EXPECT_TRUE(result.text.contains("X1.\n")) << result.text;
}

// No control has words for half a structure: it is refused in both modes, and the whole one is not.
TEST(Convert, RefusesHalfAStructure) {
  const ir::Control from = control("sinumerik-840d", ir::MachineKind::mill);
  const std::string head = "DEF INT NR\nG17 G90 G94 G710\n";
  for (const ConvertMode mode : {ConvertMode::macro, ConvertMode::explicit_blocks}) {
    const auto refused = [&](const std::string& body) {
      ConvertRequest request;
      request.source = text::Source("program", head + body);
      request.from = from;
      request.to = control("fanuc", ir::MachineKind::mill);
      request.mode = mode;
      const ConvertResult result = convert(request);
      return text::has_error(result.diagnostics) && result.text.empty();
    };
    EXPECT_TRUE(refused("FOR NR=1 TO 3\nG1 X=NR F100\nM30\n"));
    EXPECT_TRUE(refused("G1 X1 F100\nENDWHILE\nM30\n"));
    EXPECT_TRUE(refused("ELSE\nG1 X1 F100\nM30\n"));
    EXPECT_FALSE(refused("FOR NR=1 TO 3\nG1 X=NR F100\nENDFOR\nM30\n"));
  }
}

// A comment is the nearest to a message; the values in it are reported as left out.
TEST(Convert, MessagesBecomeCommentsOfTheirWrittenParts) {
  const std::string text = "DEF INT NR=3\nG17 G710 G90 G94\nMSG(\"layer \"<<NR<<\" of \"<<NR+1)\nMSG(\"done\")\nM30\n";
  const ConvertResult result = translated(text, "sinumerik-840d", "fanuc");
  EXPECT_TRUE(result.text.contains("(LAYER ... OF ...)\n(DONE)\n")) << result.text;
  ASSERT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(result.diagnostics[0].severity, text::Severity::warning);
  EXPECT_EQ(messages_of(result.diagnostics, text::Source("program", text))
                .rfind("program:3:1: warning[translation-value]", 0),
            0U);
}

// An index that is a text: a fault that only the validator of its own control shows.
TEST(Convert, RefusesWhatItsOwnControlRefuses) {
  const std::string text = "DEF REAL ROW[3]\nG17 G710 G90 G94\nROW[\"two\"]=1\nM30\n";
  for (const std::string& to : dialect_names()) {
    if (to == "sinumerik-840d") continue;
    const ConvertResult result = translated(text, "sinumerik-840d", to);
    EXPECT_TRUE(result.text.empty()) << result.text;
    EXPECT_NE(messages_of(result.diagnostics, text::Source("program", text)).find("program:3:5: error[wrong-type]"),
              std::string::npos);
  }
}

TEST(Dialects, AreFoundByNameAndText) {
  EXPECT_EQ(find_dialect("klartext"), nullptr);
  EXPECT_EQ(find_dialect("Fanuc"), nullptr);
  for (const Dialect& dialect : dialects()) EXPECT_EQ(find_dialect(dialect.name), &dialect);
  const auto inferred = [](std::string_view text) { return infer_dialect(text::Source("x", std::string(text))).name; };
  EXPECT_EQ(inferred(kHyperbola), "fanuc");
  EXPECT_EQ(inferred(kTurningCycle), "sinumerik-840d");
  EXPECT_EQ(inferred(kTurningMain), "sinumerik-840d");
  EXPECT_EQ(inferred("N10 R5=3\n"), "sinumerik-840d");
  EXPECT_EQ(inferred("N10 G0 X1\n; a comment\n"), "sinumerik-840d");
  EXPECT_EQ(inferred("%\nN10 G0 X1\n(a comment)\n"), "fanuc");
  EXPECT_EQ(inferred(""), "fanuc");
}

// The alarm of what was written is the other control's.
TEST(Convert, AFaultOfTheTranslationNamesTheControlThatHasIt) {
  const std::string text = "%\nO1\nG17 G21 G90 G94 G54\nS1000 M3\nG0 X0 Y0 Z50.\nG83 Z-5. R2. F100\nG80\nM30\n%\n";
  const ConvertResult made = translated(text, "mitsubishi-m80", "fanuc");
  ASSERT_TRUE(text::has_error(made.diagnostics));
  const text::Diagnostic& one = made.diagnostics.back();
  EXPECT_EQ(text::Source("p", text).position(one.span.begin).line, 6U);
  EXPECT_EQ(one.alarm, "");
  ASSERT_EQ(one.notes.size(), 1U);
  EXPECT_EQ(one.notes[0].text, "translated to \"G83 Z-5. R2. F100\", which is PS0045 on Fanuc 0i-MF");
}

// A code without effect on the path keeps its name and words where the other control has it, and goes with them where
// it does not have, which is reported; a cycle in effect takes none of the words.
TEST(Convert, CodesWithoutEffectGoWithTheirWords) {
  const std::string head = "%\nO1\nG21 G17 G90 G94 G54\nS500 M3\nG0 X0. Y0. Z50.\n";
  const std::string text = head + "G98 G83 X10. Y0. Z-20. R2. Q5. F100.\nG05.1 Q1\nX20.\nG80\nM30\n%\n";
  const ConvertResult kept = translated(text, "fanuc", "mitsubishi-m80");
  EXPECT_TRUE(kept.text.contains("\nG05.1 Q1\nX20.")) << kept.text;
  const ConvertResult dropped = translated(text, "fanuc", "sinumerik-840d");
  EXPECT_TRUE(dropped.text.contains("G0 X10. Y0.\nG0 X20.\nMCALL")) << dropped.text;
  EXPECT_TRUE(
      messages_of(dropped.diagnostics, text::Source("p", text)).contains("7:1: warning[cannot-translate]: G05.1"));
  const auto before = moves_of(run_text(text, control("fanuc", ir::MachineKind::mill)).motions);
  const std::string plain = head + "G98 G83 X10. Y0. Z-20. R2. Q5. F100.\n\nX20.\nG80\nM30\n%\n";
  expect_same(before, moves_of(run_text(plain, control("fanuc", ir::MachineKind::mill)).motions), 1e-9, "Q of G83");
  const ConvertResult none = translated(head + "G109 L1\nG0 X1.\nM30\n%\n", "mazak", "fanuc");
  EXPECT_FALSE(none.text.contains("L1")) << none.text;
  // High precision is not G64.
  EXPECT_TRUE(translated(head + "G61.1\nG1 X1. F100.\nM30\n%\n", "mazak", "mitsubishi-m80").text.contains("G61.1\n"));
  const ConvertResult to_fanuc = translated(head + "G61.1\nG1 X1. F100.\nM30\n%\n", "mazak", "fanuc");
  EXPECT_TRUE(to_fanuc.text.contains("G64\n")) << to_fanuc.text;
  ASSERT_FALSE(to_fanuc.diagnostics.empty());
}

// Straight on by a parameter there (3403#5), an alarm here.
TEST(Convert, AnArcWithoutACentreIsNotPassedOn) {
  const std::string text = "G17 G71 G90 G94 G54\nG0 X0 Y0\nG2 X20 Y20 CR=20 F100\nX30\nM30\n";
  const ConvertResult made = translated(text, "sinumerik-840d", "fanuc");
  EXPECT_TRUE(
      messages_of(made.diagnostics, text::Source("p", text)).contains("4:1: error[translation-shape]: an arc without"));
}

}  // namespace
}  // namespace dripfeed::compile::test
