// The explicit form of programs with what families do not have: arcs in every plane, threads, dwells, compensation,
// machine coordinates, increments, inches, shifts, surface speed, calls. Run as they are and run as plain blocks of the
// same control, they must move alike.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dialects/compile/plain/explicit_program.h"
#include "tests/unit/dialects/compile/harness.h"

namespace dripfeed::compile::test {
namespace {

std::vector<text::Diagnostic> faults_of(const ExplicitProgram& made, const ir::Program& program,
                                        const ir::Control& on) {
  return run_faults(made, RunTexts(program, ProgramLibrary(on, {})));
}

std::string explicit_text(const std::string& text, const ir::Control& from) {
  ConvertRequest request;
  request.source = text::Source("program", text);
  request.from = request.to = from;
  request.mode = ConvertMode::explicit_blocks;
  const ConvertResult result = convert(request);
  EXPECT_FALSE(text::has_error(result.diagnostics)) << messages_of(result.diagnostics, request.source);
  return result.text;
}

void expect_kept(const std::string& text, const ir::Control& on) {
  const Played before = run_text(text, on);
  const std::string plain = explicit_text(text, on);
  const Played after = run_text(plain, on);
  ASSERT_FALSE(before.motions.empty());
  expect_same(before.motions, after.motions, 0.0006, plain);
}

TEST(Explicit, SinumerikMillKeepsItsMotions) {
  expect_kept(
      "G17 G90 G94 G710 G40\nG54\nT4 D1 M6\nS1000 M3 M8\nG0 X0 Y0\nZ5\nG1 Z-1 F100\nG2 X10 Y0 I5 J0\nG3 X0 Y0 CR=-5\n"
      "G91 G1 X3 Y2\nG90 X=IC(2)\nTRANS X10 Y5\nG1 X0 Y0\nTRANS\nX0 Y0\nG18 G2 X4 Z-1 I2 K0\nG19 G3 Y4 Z-1 J2 K0\nG17\n"
      "G4 F1.5\nG1 G41 X20 Y20\nX30\nG40 X40 Y0\nG700 G1 X1 Y1 F10\nG710\nM0\nM1\nSUPA G0 Z0 D0\nG55 G0 X0 Y0 Z5\n"
      "MSG(\"TEXT\")\nMSG()\nM9\nM5\nM30\n",
      control("sinumerik-840d", ir::MachineKind::mill));
}

TEST(Explicit, SinumerikLatheKeepsItsMotions) {
  expect_kept(
      "G18 G90 G95 G710 G40 DIAMON\nG54\nT2 D1\nG96 S200 LIMS=3000 M4\nG0 X50 Z2\nG1 Z-10 F0.2\nG2 X60 Z-15 I5 K0\n"
      "G3 X70 Z-20 CR=5\nG91 G1 X2 Z-1\nG90\nDIAM90\nG91 X1\nG90 DIAMOF\nX40\nDIAMON\nG97 S500\nG0 X100\n"
      "G33 Z-30 K1.5\nG0 Z2\nT3 D2\nX20\nT3 D1\nX30\nM5\nM30\n",
      control("sinumerik-840d", ir::MachineKind::lathe));
}

// S in a block of its own, moves, and M03 only then.
TEST(Explicit, ASpeedMayStandBeforeTheSpindleStarts) {
  ConvertRequest request;
  request.from = control("haas", ir::MachineKind::mill);
  request.to = control("fanuc", ir::MachineKind::mill);
  request.mode = ConvertMode::explicit_blocks;
  request.source = text::Source("program",
                                "%\nO1\nG17 G21 G40 G80 G90 G94\nG54\nT1 M6\nS800\nG00 X1. Y2.\n"
                                "G43 H1 Z5.\nM03\nG01 Z-1. F100.\nX9.\nG00 Z5.\nM30\n%\n");
  const ConvertResult result = convert(request);
  EXPECT_FALSE(text::has_error(result.diagnostics)) << messages_of(result.diagnostics, request.source);
  EXPECT_THAT(result.text, testing::HasSubstr("S800"));
}

// The spindle goes in with one direction and out with the other; a thread of plain blocks would go on turning it (PG,
// "Rigid tapping").
TEST(Explicit, ATapThatTurnsTheSpindleIsRefused) {
  ConvertRequest request;
  request.from = control("sinumerik-840d", ir::MachineKind::mill);
  request.to = control("fanuc", ir::MachineKind::mill);
  request.mode = ConvertMode::explicit_blocks;
  const std::string head = "G17 G90 G94 G710 G40 G54\nT4 D1 M6\nS400 M3\nG0 X0 Y0 Z5\n";
  for (const std::string tap : {"G331 Z-10 K1\nG332 Z5 K1\n", "CYCLE84(20,0,3,-12,,0,3,,1.5,0,400,400)\n"}) {
    request.source = text::Source("program", head + tap + "M30\n");
    const ConvertResult refused = convert(request);
    EXPECT_TRUE(text::has_error(refused.diagnostics)) << tap;
    EXPECT_EQ(refused.diagnostics.front().span.begin, head.size()) << tap;
  }
  request.source = text::Source("program", head + "G33 Z-10 K1\nM4\nG33 Z5 K1\nM30\n");
  EXPECT_FALSE(text::has_error(convert(request).diagnostics));
}

TEST(Explicit, FanucMillKeepsItsMotions) {
  expect_kept(
      "%\nO1\nG21 G17 G90 G94 G40\nG54\nT4 M06\nS1000 M03\nM08\nG00 X0 Y0\nG43 H4 Z5.\nG01 Z-1. F100.\n"
      "G02 X10. Y0 I5. J0\nG03 X0 Y0 R-5.\nG91 G01 X3. Y2.\nG90\nG52 X10. Y5.\nX0 Y0\nG52 X0 Y0\nX0 Y0\n"
      "G18 G02 X4. Z-1. I2. K0\nG19 G03 Y4. Z-1. J2. K0\nG17\nG04 P1500\nG01 G41 D4 X20. Y20.\nX30.\nG40 X40. Y0\n"
      "G20 G01 X1. Y1. F10.\nG21\nM00\nM01\nG53 G00 Z0\nG55 G00 X0 Y0 Z5.\nM09\nM05\nM30\n%\n",
      control("fanuc", ir::MachineKind::mill));
}

TEST(Explicit, FanucLatheKeepsItsMotions) {
  expect_kept(
      "%\nO1\nG21 G18 G40 G99\nG54\nT0202\nG50 S3000\nG96 S200 M04\nG00 X50. Z2.\nG01 Z-10. F0.2\n"
      "G02 X60. Z-15. I5. K0\nG03 X70. Z-20. R5.\nG01 U2. W-1.\nG97 S500\nG00 X100.\nG32 Z-30. F1.5\nG00 Z2.\nT0303\n"
      "X20.\nT0300\nX30.\nM05\nM30\n%\n",
      control("fanuc", ir::MachineKind::lathe));
}

// H and D stay in effect from wherever they stand; one with a computed value would be lost, and so would the number of
// a computed code that is carried. That is reported, not done.
TEST(Explicit, CarriesNumbersOfOffsetsOrSaysThatItCannot) {
  const ir::Control on = control("fanuc", ir::MachineKind::mill);
  const std::string head = "%\nO1\nG21 G17 G90 G94\n#1=7.\n";
  const std::string tail = "\nG01 X1. F100.\nM30\n%\n";
  EXPECT_THAT(explicit_text(head + "D12\nG41" + tail, on), ::testing::HasSubstr("D12"));
  EXPECT_THAT(explicit_text(head + "G43 H3" + tail, on), ::testing::HasSubstr("H3"));
  for (const char* lost : {"G43 H#1", "G41 D#1", "H[#1+1]", "M[#1+143]", "G[#1+36]"}) {
    const text::Source source("program", head + lost + tail);
    const ir::ReadResult read = find_dialect(on.dialect)->read(source, on);
    const ExplicitProgram made = explicit_program(read.program, on, interpreter::no_programs(), {});
    EXPECT_EQ(made.run.ended, interpreter::Ended::end) << lost;
    EXPECT_TRUE(text::has_error(faults_of(made, read.program, on))) << lost;
  }
}

// The text without its frame of % and program number, a line a block.
std::string blocks_of(const std::string& text) {
  const std::size_t first = text.find('\n', text.find("O0001"));
  return text.substr(first + 1, text.rfind('%') - first - 1);
}

// The machine's own program hears of each M6, M8 and M9, whether or not it changes what is modelled.
TEST(Explicit, KeepsOrdersThatChangeNothing) {
  const ir::Control mill = control("fanuc", ir::MachineKind::mill);
  const std::string made = explicit_text(
      "%\nO1\nG21 G17 G90 G94\nM6 T0\nT1 M6\nT1 M6\nM9\nM7 M8\nM8\nS500\nM3\nM3\nS600\nM19\nM5\nM9\nM9\nM30\n%\n",
      mill);
  EXPECT_EQ(blocks_of(made),
            "G21 G17 G90 G94 G40\nT0 M06\nT1 M06\nT1 M06\nM09\nM07\nM08\nM08\nS500\nS500 M03\nS500 M03\nS600\nM19\n"
            "M05\nM09\nM09\nM30\n");
}

TEST(Explicit, KeepsTheOrdersOfALathe) {
  const ir::Control lathe = control("fanuc", ir::MachineKind::lathe);
  const std::string made = explicit_text(
      "%\nO1\nG21 G18 G99\nT0200 M6\nT0202\nT0202\nG50 S2000\nG97 S300\nM3\nG0 X50. Z5.\nT0200\nM30\n%\n", lathe);
  EXPECT_EQ(blocks_of(made),
            "G21 G18 G99 G40\nT0200 M06\nT0202\nT0202\nG50 S2000\nG97 S300\nG97 S300 M03\nG00 X50. Z5.\nT0200\nM30\n");
}

// What an M function of the builder's is given goes with it; where it may be a cycle's, that is reported.
TEST(Explicit, KeepsTheWordsOfMFunctions) {
  const ir::Control mill = control("fanuc", ir::MachineKind::mill);
  const std::string head = "%\nO1\nG21 G17 G90 G94\n";
  const std::string made = explicit_text(head + "M150 P3 Q2.\nM19 R90.\nM151 R5.\nM30\n%\n", mill);
  EXPECT_EQ(blocks_of(made), "G21 G17 G90 G94 G40\nP3 Q2. M150\nR90. M19\nR5. M151\nM30\n");
  for (const char* unclear : {"G0 X1. P3 M150", "Q2 M150"}) {
    const text::Source source("program", head + unclear + "\nM30\n%\n");
    const ir::ReadResult read = find_dialect(mill.dialect)->read(source, mill);
    const ExplicitProgram plain = explicit_program(read.program, mill, interpreter::no_programs(), {});
    EXPECT_TRUE(text::has_error(faults_of(plain, read.program, mill))) << unclear;
  }
}

// Where an operator enters at a tool, no mode from before is needed: with the first move, not with one to the machine's
// zero. The spindle turns with a tool where the program orders it, and not otherwise: T2 may be a probe.
TEST(Explicit, StatesTheModesAgainAfterAToolChange) {
  const ir::Control mill = control("fanuc", ir::MachineKind::mill);
  const std::string made = explicit_text(
      "%\nO1\nG21 G17 G90 G94\nT1 M6\nG55 G0 X0 Y0 S1000 M3\nG43 H1 Z5.\nT2 M6\nG0 G53 Z0\nX5.\nG1 X6. F100.\nT3 M6\n"
      "M3\nX7.\nM5\nT4 M6\nX8.\nM30\n%\n",
      mill);
  EXPECT_EQ(blocks_of(made),
            "G21 G17 G90 G94 G40\nT1 M06\nG55\nS1000 M03\nG00 X0. Y0.\nG43 Z5. H1\nT2 M06\nG53 Z0.\n"
            "G90 G17 G94 G55 G00 X5.\nG01 X6. F100.\nT3 M06\nS1000 M03\nG90 G17 G94 G55 G01 X7. F100.\nM05\nT4 M06\n"
            "G90 G17 G94 G55 G01 X8. F100.\nM30\n");
}

// A turret leaves the spindle turning.
TEST(Explicit, StatesTheSpindleAgainAfterATurret) {
  const ir::Control lathe = control("fanuc", ir::MachineKind::lathe);
  const std::string made = explicit_text(
      "%\nO1\nG21 G18 G99\nT0101\nG97 S300 M3\nG0 X50. Z5.\nT0202\nX40.\nT0303 M6\nX30.\nM30\n%\n", lathe);
  EXPECT_THAT(made, ::testing::HasSubstr("T0202\nG97 S300 M03\n"));
  EXPECT_THAT(made, ::testing::Not(::testing::HasSubstr("T0303 M06\nG97")));
}

// D0 would leave the length out, which a tool change without D turns on; a D0 of the program does so.
TEST(Explicit, WritesNoEdgeThatTheProgramDoesNotState) {
  const ir::Control mill = control("sinumerik-840d", ir::MachineKind::mill);
  const std::string source = "G17 G90 G94 G710 G40\nG54\nT1 M6\nG0 Z5\nD0\nZ6\nT1 M6\nZ7\nT2 D2 M6\nZ8\nD2\nM30\n";
  EXPECT_EQ(explicit_text(source, mill),
            "G710 G17 G90 G94 G40\nG54\nT1 M6\nG0 Z5.\nD0\nZ6.\nT1 M6\nG90 G17 G94 G54 G0 Z7.\nT2 D2 M6\n"
            "G90 G17 G94 G54 G0 Z8.\nD2\nM30\n");
  ConvertRequest request;
  request.from = mill;
  request.to = control("fanuc", ir::MachineKind::mill);
  request.mode = ConvertMode::explicit_blocks;
  request.source = text::Source("program", "G17 G90 G94 G710 G40\nG54\nT1 M6\nG0 Z5\nM30\n");
  const ConvertResult made = convert(request);
  EXPECT_THAT(made.text, ::testing::HasSubstr("G43 H1"));
  EXPECT_THAT(made.text, ::testing::Not(::testing::HasSubstr("G49")));
}

// X100 counts least increments, X[100] is calculated like X#1 and counts millimetres; so do arguments of macros.
TEST(Explicit, BracketsCountWholeUnits) {
  const ir::Control on = control("fanuc", ir::MachineKind::mill);
  ASSERT_EQ(on.semantics.decimal_mode, ir::DecimalMode::least_increment);
  ProgramLibrary library(on, [](std::string_view name) -> std::optional<text::Source> {
    if (name == "O9001") return text::Source("O9001", "%\nO9001\nG00 Y#24\nM99\n%\n");
    return std::nullopt;
  });
  const std::string text =
      "%\nO0001\nG21 G17 G90 G94\nG00 X100\nX[100]\nX-[100]\nX[50*2]\nG65 P[9001] X[7]\nGOTO[20]\nX1.\nN20 M30\n%\n";
  const std::vector<ir::Motion> moves = moves_of(run_text(text, on, &library).motions);
  ASSERT_EQ(moves.size(), 5U);
  EXPECT_DOUBLE_EQ(moves[0].end[0], 0.1);
  EXPECT_DOUBLE_EQ(moves[1].end[0], 100.0);
  EXPECT_DOUBLE_EQ(moves[2].end[0], -100.0);
  EXPECT_DOUBLE_EQ(moves[3].end[0], 100.0);
  EXPECT_DOUBLE_EQ(moves[4].end[1], 7.0);
}

// M99 of a called program goes on after the call, M99 P at a block of the caller, written or computed.
TEST(Explicit, ReturnsOfSubprogramsGoOnWhereTheySay) {
  const ir::Control on = control("fanuc", ir::MachineKind::mill);
  ProgramLibrary library(on, [](std::string_view name) -> std::optional<text::Source> {
    if (name == "O0002") return text::Source("O0002", "%\nO0002\nG01 X1. F100.\nM99\n%\n");
    if (name == "O0003") return text::Source("O0003", "%\nO0003\nM99 P50\n%\n");
    if (name == "O0004") return text::Source("O0004", "%\nO0004\n#1=70.\nM99 P#1\n%\n");
    return std::nullopt;
  });
  const std::string text = "%\nO0001\nG21 G17 G90 G94\nM98 P2\nM98 P3\nX2.\nN50 X3.\nM98 P4\nX4.\nN70 X5.\nM30\n%\n";
  const std::vector<ir::Motion> moves = moves_of(run_text(text, on, &library).motions);
  ASSERT_EQ(moves.size(), 3U);
  EXPECT_DOUBLE_EQ(moves[0].end[0], 1.0);
  EXPECT_DOUBLE_EQ(moves[1].end[0], 3.0);
  EXPECT_DOUBLE_EQ(moves[2].end[0], 5.0);
}

// A loop a thousand blocks long stays one block a motion, in the order of execution, each with its own line.
TEST(Explicit, BlocksKnowLineAndOrdinal) {
  const ir::Control on = control("sinumerik-840d", ir::MachineKind::mill);
  const text::Source source("p", "G17 G90 G94 G710\nR1=0\nWHILE R1<1000\nR1=R1+1\nG1 X=R1 F100\nENDWHILE\nM30\n");
  const ir::ReadResult read = find_dialect(on.dialect)->read(source, on);
  const ExplicitProgram made = explicit_program(read.program, on, interpreter::no_programs(),
                                                {.limits = {}, .initial_values = {}, .want_changes = true});
  ASSERT_EQ(made.origins.size(), 1001U);
  for (std::size_t i = 0; i < 1000; ++i) ASSERT_EQ(made.origins[i].line, 5U);
  for (std::size_t i = 1; i < 1000; ++i) ASSERT_GT(made.origins[i].ordinal, made.origins[i - 1].ordinal);
  ASSERT_EQ(made.changes.size(), 1001U);
  EXPECT_DOUBLE_EQ(made.changes.back().change.value, 1000.0);
  EXPECT_EQ(made.variable_names[made.changes.back().change.variable], "R1");
}

TEST(Explicit, LimitsEndTheRunWithAnError) {
  const ir::Control on = control("sinumerik-840d", ir::MachineKind::mill);
  const text::Source source("p", "AGAIN:\nG1 X1 F100\nGOTOB AGAIN\nM30\n");
  const ir::ReadResult read = find_dialect(on.dialect)->read(source, on);
  ExplicitOptions options;
  options.limits.blocks = 1000;
  const ExplicitProgram made = explicit_program(read.program, on, interpreter::no_programs(), options);
  EXPECT_EQ(made.run.ended, interpreter::Ended::limit);
  EXPECT_TRUE(text::has_error(faults_of(made, read.program, on)));
  // What is held whole has a closer one than what is only run.
  EXPECT_LT(ConvertRequest().limits.blocks, interpreter::Limits().blocks);
}

}  // namespace
}  // namespace dripfeed::compile::test
