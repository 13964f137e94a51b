// Rows at the edge of what a pass of the translator takes and refuses, each with a near miss: one word decides.
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "dialects/compile/dialect/dialect.h"
#include "dialects/compile/dialect/shared_definitions.h"
#include "dialects/passes/explicit_modes.h"
#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

using ir::MachineKind;

const std::string kSinumerik = "G710 G17 G90 G94 G40 G54\nT1 D1 M6\nS500 M3 F150\nG0 X0 Y0 Z30\n";
const std::string kFanuc = "O1\nG21 G17 G90 G94 G40 G80\nG54\nT1 M06\nS900 M03\nF300.\nG00 X0. Y0. Z30.\n";
const std::string kSinumerikLathe = "G18 G90 G95 G71 DIAMON G40\nT1 D1\nS500 M3\nG0 X60 Z5\nG1 F0.3\n";
const std::string kFanucLathe = "O1\nG21 G18 G99 G97 G40\nS500 M03\nG00 X60. Z5.\nG01 F0.3\n";

struct Side {
  std::string dialect;
  MachineKind kind = MachineKind::mill;
};

struct Made {
  bool refused = false;
  std::string text;
  std::string messages;

  [[nodiscard]] bool has(const std::string& line) const { return text.find(line) != std::string::npos; }
  [[nodiscard]] bool states(const std::string& words) const { return messages.find(words) != std::string::npos; }
};

Made make(const std::string& text, const Side& from, const std::string& to, ConvertMode mode = ConvertMode::macro) {
  ConvertRequest request;
  request.source = text::Source("program", text);
  request.from = control(from.dialect, from.kind);
  request.to = control(to, from.kind);
  request.mode = mode;
  const ConvertResult result = convert(request);
  return {text::has_error(result.diagnostics), result.text, messages_of(result.diagnostics, request.source)};
}

const Side kSinumerikMill = {"sinumerik-840d"};
const Side kSinumerikTurning = {"sinumerik-840d", MachineKind::lathe};
const Side kFanucMill = {"fanuc"};
const Side kFanucTurning = {"fanuc", MachineKind::lathe};

// --- taps on lathes

TEST(TranslateEdges, ATapThatIsMadeZeroTimesMovesNothing) {
  const auto tap = [](const std::string& more) {
    return make(kFanucLathe + "G00 X0. Z5.\nM04\nG84 Z-10. R2. F1.5" + more + "\nG80\nG00 Z20.\nM30\n", kFanucTurning,
                "sinumerik-840d");
  };
  EXPECT_FALSE(tap(" K0").refused);
  EXPECT_TRUE(tap("").states("G84 where the spindle does not turn by M3"));
}

TEST(TranslateEdges, ARigidTapMayStateItsSpeed) {
  const auto tap = [](const std::string& word) {
    return make(kFanucLathe + "G00 X0. Z5.\nM29 S500\nG84 Z-10. R-2. F1.5 " + word + "\nG80\nG00 Z20.\nG01 X1.\nM30\n",
                kFanucTurning, "sinumerik-840d");
  };
  EXPECT_TRUE(tap("S500").has("G331 Z-10. K1.5 S500")) << tap("S500").messages;
  EXPECT_TRUE(tap("Q2000").refused);
}

TEST(TranslateEdges, ATapByACallStatesWhatItsSpindleDoesAfterIt) {
  for (const auto& [after, turns] : {std::pair("3", "M03"), std::pair("4", "M04"), std::pair("5", "M05")}) {
    const Made made =
        make(kSinumerikLathe + "G17\nG0 X0 Z20\nCYCLE84(10,0,2,-10,,," + after + ",,1.5,0,500,500)\nG18\nG0 Z30\nM30\n",
             kSinumerikTurning, "fanuc");
    ASSERT_FALSE(made.refused) << made.messages;
    const std::size_t tap = made.text.find("G84");
    ASSERT_NE(tap, std::string::npos) << made.text;
    EXPECT_NE(made.text.find(turns, tap), std::string::npos) << made.text;
  }
  EXPECT_TRUE(make(kSinumerikLathe + "G17\nG0 X0 Z20\nCYCLE84(10,0,2,-10,,,19,,1.5,0,500,500)\nG18\nG0 Z30\nM30\n",
                   kSinumerikTurning, "fanuc")
                  .refused);
}

TEST(TranslateEdges, AnOrientationBelongsToItsTap) {
  const auto oriented = [](const std::string& label, const std::string& between) {
    return make(kSinumerikLathe + "G0 X0 Z20\n" + label + "SPOS=0\n" + between +
                    "G331 Z-10 K1 S500\nG332 Z20 K1\nG0 Z30 M3\nM30\n",
                kSinumerikTurning, "fanuc");
  };
  EXPECT_FALSE(oriented("", "").refused) << oriented("", "").messages;
  EXPECT_FALSE(oriented("", "G0 X0\n").refused);
  // A jump may lead to it without what comes before; a speed in between is one of another spindle's state.
  EXPECT_TRUE(oriented("AGAIN: ", "").states("SPOS=0"));
  EXPECT_TRUE(oriented("", "S600\n").states("SPOS=0"));
}

// G84.2 takes its speed from its own block: where it cuts nothing, that speed is stated nevertheless.
TEST(TranslateEdges, ATapOfNoDepthLeavesItsSpeed) {
  const Made made = make(kFanucLathe + "G00 X0. Z5.\nG84.2 Z2. R-3. F1.5 S200\nG80\nG00 Z20.\nG01 X1.\nM30\n",
                         {"mazak", MachineKind::lathe}, "sinumerik-840d");
  EXPECT_FALSE(made.refused) << made.messages;
  EXPECT_TRUE(made.has("S200 M3")) << made.text;
}

TEST(TranslateEdges, AStopInTheBlockOfADrillingCycleIsRefused) {
  const auto drill = [](const std::string& word) {
    return make(kFanucLathe + "G00 X0. Z5.\nG83 Z-20. R-3. F0.1 " + word + "\nG80\nG00 X60.\nM30\n", kFanucTurning,
                "sinumerik-840d");
  };
  EXPECT_TRUE(drill("M00").states("an event within it"));
  EXPECT_FALSE(drill("M08").refused) << drill("M08").messages;
}

// --- turning cycles

TEST(TranslateEdges, AWordThatATurningCycleKeepsMustBeANumber) {
  const auto cycle = [](const std::string& x) {
    return make(kFanucLathe + "#1=55.\nG00 X60. Z5.\nG92 X" + x + " Z-10. F1.5\nZ-12.\nG00 X62.\nM30\n", kFanucTurning,
                "sinumerik-840d");
  };
  EXPECT_FALSE(cycle("55.").refused) << cycle("55.").messages;
  EXPECT_TRUE(cycle("#1").states("a word that a turning cycle keeps, not known here,"));
}

TEST(TranslateEdges, DOfAThreadCycleIsItsCut) {
  const std::string text = kFanucLathe + "G00 X34. Z4.\nG76 X27. Z-20. K1. D300 A60 F1.5\nG00 X60.\nM30\n";
  const Made made = make(text, {"mazak", MachineKind::lathe}, "sinumerik-840d", ConvertMode::explicit_blocks);
  EXPECT_TRUE(made.has("G33 Z-20. K1.5")) << made.messages;
}

TEST(TranslateEdges, AStopWaitsForTheEndOfATurningCycle) {
  const auto turned = [](const std::string& cycle) {
    return make(kFanucLathe + "G00 X50. Z5.\n" + cycle + "\nG00 X60.\nM30\n", kFanucTurning, "sinumerik-840d");
  };
  EXPECT_TRUE(turned("G90 X40. Z-20. F0.2 M00").has("G0 Z5.\nM0\n")) << turned("G90 X40. Z-20. F0.2 M00").text;
  EXPECT_TRUE(turned("G92 X40. Z-20. F2. M01").has("G0 Z5.\nM1\n")) << turned("G92 X40. Z-20. F2. M01").text;
}

// --- arcs and polar positions

TEST(TranslateEdges, AnArcByItsOpeningAngleHasAForm) {
  const Made made = make(kSinumerik + "G1 X0 Y0\nG3 X10 Y0 AR=180\nM30\n", kSinumerikMill, "fanuc");
  EXPECT_FALSE(made.states("an arc without a centre or radius")) << made.messages;
}

TEST(TranslateEdges, AFeedIsNotACentre) {
  const auto arc = [](const std::string& more) {
    return make(kSinumerik + "G111 X0 Y0\nG1 AP=0 RP=10\nG3 AP=90 RP=10" + more + "\nM30\n", kSinumerikMill, "fanuc");
  };
  for (const std::string more : {"", " F120", " S600"}) {
    const Made made = arc(more);
    EXPECT_FALSE(made.refused) << made.messages;
    EXPECT_TRUE(made.has("I-10.") || made.has("R10.")) << made.text;
  }
}

TEST(TranslateEdges, RTakesTheCentreOnlyWhereItDoesOnTheControl) {
  EXPECT_TRUE(make(kSinumerik + "G291\nG01 X0. Y0. F100.\nG03 X10. Y0. I5. J0. R5.\nG290\nG1 X1\nM30\n", kSinumerikMill,
                   "fanuc")
                  .has("I5. J0. R5."));
  EXPECT_FALSE(make(kFanuc + "G01 X0. Y0.\nG03 X10. Y0. I5. J0. R5.\nM30\n", kFanucMill, "sinumerik-840d").has("I5."));
}

TEST(TranslateEdges, APositionIsInTheUnitInEffect) {
  const Made made =
      make(kSinumerik + "G1 X10 Y0 Z0\nG700\nG3 X0.8937 Y-0.5 I=AC(0.8937) J=AC(0)\nM30\n", kSinumerikMill, "fanuc");
  EXPECT_FALSE(made.refused) << made.messages;
  EXPECT_FALSE(made.has("I-9.")) << made.text;  // 10 mm are not 10 inch
}

TEST(TranslateEdges, HolesByAngleAreWrittenOutUpToAThousand) {
  const auto holes = [](const std::string& count) {
    return make(kFanuc + "G16\nG99 G81 X10. Y0. Z-3. R2. F100.\nG91 Y0.5 K" + count + "\nG80 G90 G15\nM30\n",
                kFanucMill, "sinumerik-840d");
  };
  EXPECT_FALSE(holes("1000").refused);
  EXPECT_TRUE(holes("1001").states("a number of holes by angle that is not known here"));
}

// --- frames

// By its setting data (SD42440, which is usually 1) a SINUMERIK goes by the change of the frame as well: the position
// stands in the place of such an increment where it is known, elsewhere the translation is refused.
struct Shifted {
  std::string source = kFanuc;
  ConvertMode mode = ConvertMode::macro;

  [[nodiscard]] Made operator()(const std::string& frame, const std::string& moves) const {
    return make(source + frame + "\n" + moves + "\nG90\nG00 Z60.\nM30\n", kFanucMill, "sinumerik-840d", mode);
  }
};
constexpr std::string_view kShiftedIncrement = "an increment along an axis whose frame has changed (SD42440";

TEST(TranslateEdges, AnIncrementAfterAChangeOfTheFrameIsRefusedByItsReason) {
  const Shifted shifted;
  for (const std::string frame : {"G51.1 X0.", "G68 X0. Y0. R30.", "#1=5.\nG52 X#1"}) {
    const Made made = shifted(frame, "G91\nG01 X1. Y1.\nX2.");
    EXPECT_TRUE(made.refused) << frame << made.text;
    EXPECT_TRUE(made.states(std::string(kShiftedIncrement))) << frame << made.messages;
    EXPECT_FALSE(shifted(frame, "G01 X1. Y1.\nG91\nX2. Y3.").refused) << frame;
  }
  for (const std::string moves :
       {"G91\n#1=1.\nG01 X#1", "G91\n#1=1.\nG01 X1.", "G91\n#1=1.\nIF[#1EQ2.]GOTO5\nN5 G01 X1."})
    EXPECT_TRUE(shifted("G52 X5.", moves).states(std::string(kShiftedIncrement))) << moves;
  EXPECT_FALSE(Shifted{.mode = ConvertMode::explicit_blocks}("G52 X5.", "G91\nG01 X1. Y1.\nX2.").refused);
}

TEST(TranslateEdges, AnIncrementAfterAShiftBecomesThePositionThatItLeadsTo) {
  struct Row {
    std::string frame;
    std::string moves;
    std::string written;
  };
  const std::string place = kFanuc + "G00 X10. Y20.\n";
  for (const Row& row :
       {Row{"G52 X5.", "G91\nG01 X1. Y1.\nX2.", "X=AC(6.) Y1."}, Row{"G52 X5.\nG52 X2.", "G91\nG01 X1.", "X=AC(9.)"},
        Row{"G52 X5.\nG01 X1.\nG52 X0.", "G91\nG01 X1.", "X=AC(7.)"},
        Row{"G52 X5. Y-1.5", "G91\nG01 X1.\nM8\nG94 Y0.5", "Y=AC(22.)"},
        Row{"G52 X5.", "G91\nG03 X1. Y1. J1.", "X=AC(6.) Y1."},
        Row{"G52 X5.", "G91\nG01 X1.\nG52 X0.\nX1.", "X=AC(12.)"}}) {
    const Made made = Shifted{.source = place}(row.frame, row.moves);
    EXPECT_FALSE(made.refused) << row.frame << made.messages;
    EXPECT_TRUE(made.has(row.written)) << row.frame << "\n" << made.text;
  }
  // Where the shift is that of before, an increment stays one.
  EXPECT_FALSE(Shifted{.source = place}("G52 X0.", "G91\nG01 X1.").has("AC("));
  EXPECT_FALSE(Shifted{.source = place}("G52 X5.", "G91\nG01 Y1.").has("AC("));
  EXPECT_FALSE(Shifted{.source = place}("G52 X5.", "G01 X1.\nG91\nX1.").has("AC("));
}

// --- modes

// X1000 counts increments, which are 1 mm or 0.1 inch.
TEST(TranslateEdges, AModeThatPathsDisagreeAboutIsReportedOnceAndNotStated) {
  const ir::Control from = control("fanuc", MachineKind::mill);
  const text::Source source("program",
                            kFanuc + "IF[#1EQ1.]GOTO5\nG21\nGOTO6\nN5 G20\nN6 G01 X1000\nX2000\nG21\nX3000\nM30\n");
  ir::Program program = find_dialect("fanuc")->read(source, from).program;
  const std::vector<text::Diagnostic> found =
      passes::make_modes_explicit(program, from, control("sinumerik-840d", MachineKind::mill));
  EXPECT_EQ(std::ranges::count(found, text::DiagnosticId::unknown_modal_state, &text::Diagnostic::id), 1);
  for (const ir::Statement& s : program.statements) {
    const std::string_view written = s.span.in(source.text());
    if (s.kind != ir::StatementKind::block || !written.contains("000")) continue;
    for (const ir::Code& code : program.codes_of(program.blocks[s.payload]))
      EXPECT_NE(code.group, ir::ModalGroup::unit) << written;
  }
}

// --- values

TEST(TranslateEdges, OnlyValuesFromOutsideAreReported) {
  const auto reads = [](const std::string& variable) {
    return make(kFanuc + variable + "=" + variable + "+1.\nG01 X" + variable + "\nM30\n", kFanucMill, "sinumerik-840d");
  };
  EXPECT_TRUE(reads("#101").states("which nothing here sets before it is read")) << reads("#101").messages;
  EXPECT_FALSE(reads("#1").states("which nothing here sets before it is read"));
}

TEST(TranslateEdges, AJumpToTheNextBlockSettlesNothing) {
  const auto jump = [](const std::string& over) {
    return make(kFanuc + "IF[#101EQ#0]GOTO1\n" + over + "N1 G01 X5. F100.\nM30\n", kFanucMill, "sinumerik-840d");
  };
  EXPECT_TRUE(jump("X#101\n").messages.find("a word that is left out while #101 is empty") == std::string::npos);
  EXPECT_TRUE(make(kFanuc + "IF[#101EQ#0]GOTO1\nN1 G01 X#101 F100.\nM30\n", kFanucMill, "sinumerik-840d")
                  .states("a word that is left out while #101 is empty"));
}

TEST(TranslateEdges, AQuotientOfPositiveValuesIsPositive) {
  const auto rounded = [](const std::string& value) {
    return make(kSinumerik + "G1 X=ROUND(" + value + ")\nM30\n", kSinumerikMill, "fanuc").text;
  };
  EXPECT_EQ(rounded("ABS(R2)/2").find("IF["), std::string::npos) << rounded("ABS(R2)/2");
  EXPECT_NE(rounded("ABS(R2)/2"), rounded("R2/2"));
}

TEST(TranslateEdges, AnArrayOfTwoGetsItsNumbersFirst) {
  const Made made = make("DEF REAL V0=3, V1=4\nDEF REAL A[2]\nDEF INT I=1\n" + kSinumerik +
                             "G1 X=V0 Y=V1\nA[0]=1\nA[I]=2\nG1 X=A[0] Y=A[I]\nM30\n",
                         kSinumerikMill, "fanuc");
  EXPECT_TRUE(made.has("#100=1\n")) << made.text << made.messages;
}

// An array is given up after its last use as any variable is: 183 numbers are left next to its 450.
TEST(TranslateEdges, TheNumbersOfAnArrayAreTakenAgain) {
  std::string text = "DEF REAL A[450]\n" + kSinumerik + "A[0]=1\nG1 X=A[0]\n";
  for (int n = 1; n <= 200; ++n) text += "R" + std::to_string(n) + "=" + std::to_string(n) + "\n";
  for (int n = 1; n <= 200; n += 10) {
    text += "G1 X=R" + std::to_string(n);
    for (int m = n + 1; m < n + 10; ++m) text += "+R" + std::to_string(m);
    text += "\n";
  }
  const Made made = make(text + "M30\n", kSinumerikMill, "fanuc");
  EXPECT_FALSE(made.refused) << made.messages;
}

// --- blocks

TEST(TranslateEdges, AMachinePositionWithoutAnAxisIsNoMove) {
  EXPECT_FALSE(make(kFanuc + "G01 G53\nG91 G53\nG90\nG00 X1.\nM30\n", kFanucMill, "sinumerik-840d").refused);
  EXPECT_TRUE(make(kFanuc + "G01 G53 X1.\nM30\n", kFanucMill, "sinumerik-840d").refused);
}

TEST(TranslateEdges, AToolThatIsPreparedTakesNoOtherWordAlong) {
  const Made made =
      make(kFanuc + "G01 X10.\nX11. T2 M08\nM30\n", kFanucMill, "sinumerik-840d", ConvertMode::explicit_blocks);
  EXPECT_TRUE(made.has("\nT2 M8\n")) << made.text;
}

TEST(TranslateEdges, AShopsOwnCycleIsReportedOnce) {
  const Made made = make("%_N_MAIN_MPF\n" + kSinumerik +
                             "CYCLE81(1)\nCYCLE81(2)\nM30\n%_N_CYCLE81_SPF\nPROC CYCLE81(REAL A)\nG1 X=A\nRET\n",
                         kSinumerikMill, "fanuc");
  const std::string own = "the shop's own program with the name CYCLE81";
  const std::size_t first = made.messages.find(own);
  ASSERT_NE(first, std::string::npos) << made.messages;
  EXPECT_EQ(made.messages.find(own, first + 1), std::string::npos) << made.messages;
}

// D takes the offsets of another edge: where the arc begins, the control then has.
TEST(TranslateEdges, AnArcAfterAnotherEdgeBeginsWhereTheControlSays) {
  const auto arc = [](const std::string& between) {
    return make(kSinumerik + "G1 X10 Y0\n" + between + "G2 X0 Y10 I=AC(0) J=AC(0)\nM30\n", kSinumerikMill, "fanuc");
  };
  EXPECT_TRUE(arc("").has("G02 X0. Y10. I-10. J0.")) << arc("").text;
  EXPECT_TRUE(arc("D0\n").has("G02 X0. Y10. I[0-#5001] J[0-#5002]")) << arc("D0\n").text;
}

// F of a block that may be left out does not take the place of the lead, which is the feed there.
TEST(TranslateEdges, TheFeedAfterAThreadIsItsLeadWhereABlockMayBeLeftOut) {
  const auto after = [](const std::string& sign) {
    return make(kFanucLathe + "G32 Z-10. F1.5\n" + sign + "G01 X61. F0.1\nG01 Z-12.\nM30\n", kFanucTurning,
                "sinumerik-840d");
  };
  EXPECT_TRUE(after("/").has("G33 Z-10. K1.5\nF1.5\n/ G1 X61. F0.1\n")) << after("/").text;
  EXPECT_TRUE(after("").has("G33 Z-10. K1.5\nG1 X61. F0.1\n")) << after("").text;
}

TEST(TranslateEdges, ACornerIsRoundedToTheTargetsIncrement) {
  const auto corner = [](bool is_named) {
    ConvertRequest request;
    request.source = text::Source("program", kSinumerik + "G1 X10 RND=2.00049\nY10 CHR=1.00051\nX0\nM30\n");
    request.from = control("sinumerik-840d", MachineKind::mill);
    request.to = control("fanuc", MachineKind::mill);
    request.to.from_profile = is_named;
    return convert(request).text;
  };
  EXPECT_NE(corner(true).find(",R2.\n"), std::string::npos) << corner(true);
  EXPECT_NE(corner(true).find(",C1.001\n"), std::string::npos) << corner(true);
}

// What the definition files declare, the control keeps: moves that are found by a run do not come from it.
TEST(TranslateEdges, DataOfADefinitionFileIsFromOutside) {
  const auto arc_after = [](const std::string& definition, const std::string& first) {
    ConvertRequest request;
    request.source =
        text::Source("program", first + kSinumerik + "G1 X=HOLE\nG1 X0 Y0\nCIP X10 Y0 Z35 I1=5 J1=5 K1=31\nM30\n");
    request.from = with_definitions(control("sinumerik-840d", MachineKind::mill),
                                    [&](std::string_view name) -> std::optional<text::Source> {
                                      if (name != "SGUD" || definition.empty()) return std::nullopt;
                                      return text::Source("SGUD.DEF", definition);
                                    });
    request.to = control("fanuc", MachineKind::mill);
    return messages_of(convert(request).diagnostics, request.source);
  };
  const std::string reason = "CIP together with the variable HOLE, which the control keeps,";
  const std::string kept = arc_after("DEF NCK REAL HOLE\nM30\n", "");
  EXPECT_NE(kept.find(reason), std::string::npos) << kept;
  EXPECT_EQ(arc_after("", "DEF REAL HOLE\n").find(reason), std::string::npos);
}

TEST(TranslateEdges, TheLastCommentStays) {
  EXPECT_TRUE(make(kFanuc + "G01 X1.\nM30\n(LAST)\n", kFanucMill, "sinumerik-840d").has("; LAST"));
  EXPECT_TRUE(make(kSinumerik + "G1 X1\nM30\n; LAST\n", kSinumerikMill, "fanuc").has("(LAST)"));
}

}  // namespace
}  // namespace dripfeed::compile::test
