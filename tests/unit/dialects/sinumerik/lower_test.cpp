// What the statements of a text become in the program model.
#include <algorithm>
#include <string>

#include "dialects/ir/other_spindle.h"
#include "tests/unit/dialects/sinumerik/reading.h"

namespace dripfeed::sinumerik {
namespace {

using ir::Function;
using ir::StatementKind;

std::string kinds(const ir::Program& p) {
  static constexpr std::string_view kNames[] = {
      "empty",      "block",          "assign", "goto",      "if",      "else",   "endif",
      "while",      "endwhile",       "repeat", "until",     "for",     "endfor", "loop",
      "endloop",    "define",         "call",   "procedure", "declare", "return", "return to",
      "modal call", "modal call end", "output", "end",       "message", "alarm",  "native"};
  std::string out;
  for (const ir::Statement& s : p.statements) {
    if (!out.empty()) out += ' ';
    out += kNames[static_cast<std::size_t>(s.kind)];
  }
  return out;
}

const ir::Word& word(const ir::Program& p, std::size_t i) { return p.words.at(i); }

TEST(Lower, OneLineGivesItsAssignmentsThenItsBlockThenItsJump) {
  EXPECT_EQ(kinds(good("N10 R1=1 R2=R1 G0 X5")), "assign assign block");
  EXPECT_EQ(kinds(good("G0 X5 R1=1")), "assign block");
  EXPECT_EQ(kinds(good("G0 X=R1 R1=1")), "block assign");
  EXPECT_EQ(kinds(good("AA: G0 X5 GOTOB AA")), "block goto");
  EXPECT_EQ(kinds(good("G0 X5 M30")), "block end");
}

// Whatever stands in its brackets, the block comes to its end.
TEST(Lower, TransformationsWithAnythingInTheirBrackets) {
  EXPECT_EQ(kinds(good("TRANSMIT(1)")), "block");
  EXPECT_EQ(kinds(good("TRACYL(40,,1)")), "block");
  EXPECT_NE(faults_of("TRANSMIT(1,0,.,-1)"), "");
  EXPECT_NE(faults_of("TRACYL(=)"), "");
}

TEST(Lower, AnAssignmentBetweenWordsThatUseVariablesIsNotGuessed) {
  EXPECT_EQ(kinds(good("G0 X=R1 R1=1 Y=R1")), "native");
}

TEST(Lower, TokensOfALineBelongToItsFirstStatement) {
  const ir::Program p = good("R1=1 R2=2 ; two\nM30");
  ASSERT_EQ(p.statements.size(), 3U);
  EXPECT_EQ(p.statements[0].tokens.first, 0U);
  EXPECT_EQ(p.statements[1].tokens.first, p.statements[1].tokens.last);
  EXPECT_EQ(p.statements[2].tokens.first, p.statements[0].tokens.last);
  EXPECT_EQ(p.statements[2].tokens.last, p.tokens.size());
}

TEST(Lower, WordsKeepTheirModes) {
  const ir::Program p = good("G2 X=AC(1) Y=IC(R1) I=AC(5) CR=3 C=DC(90) S2=500 T=\"DRILL\" POS[U]=4");
  EXPECT_EQ(word(p, 0).mode, ir::WordMode::absolute);
  EXPECT_EQ(word(p, 1).mode, ir::WordMode::incremental);
  EXPECT_EQ(word(p, 2).mode, ir::WordMode::absolute);
  EXPECT_EQ(word(p, 3).address, ir::Address::arc_radius);
  EXPECT_EQ(p.strings.at(word(p, 4).name), "DC");
  EXPECT_EQ(word(p, 5).extension, 2);
  EXPECT_EQ(p.at(word(p, 6).value).op, ir::Operator::string);
  EXPECT_EQ(word(p, 7).address, ir::Address::other);
  EXPECT_EQ(p.strings.at(word(p, 7).name), "POS[U]");
}

TEST(Lower, SurfaceSpeedChoosesTheFeedModeToo) {
  const ir::Program p = good("G96 S200 LIMS=3000\nG961\nG97", ir::MachineKind::lathe);
  ASSERT_EQ(p.codes.size(), 6U);
  EXPECT_EQ(p.codes[0].function, Function::feed_per_rev);
  EXPECT_EQ(p.codes[1].function, Function::surface_speed_on);
  EXPECT_EQ(p.codes[2].function, Function::feed_per_min);
  EXPECT_EQ(p.codes[4].function, Function::feed_per_rev);
  EXPECT_EQ(p.codes[5].function, Function::surface_speed_off);
}

TEST(Lower, WorkOffsetsAndMFunctions) {
  const ir::Program p = good("G54\nG57\nG505\nG599\nG500\nM2=3 M1=3 M8 M25");
  const std::int16_t offsets[] = {1, 4, 5, 99, 0};
  for (std::size_t i = 0; i < std::size(offsets); ++i) {
    EXPECT_EQ(p.codes[i].function, Function::work_offset);
    EXPECT_EQ(p.codes[i].argument, offsets[i]);
  }
  EXPECT_EQ(p.codes[5].function, Function::other_spindle);
  EXPECT_EQ(p.codes[5].argument, ir::spindle_order(2, 3));
  EXPECT_EQ(p.codes[6].function, Function::spindle_cw);
  EXPECT_EQ(p.codes[7].function, Function::coolant_flood);
  EXPECT_EQ(p.codes[8].function, Function::machine_function);
  EXPECT_EQ(p.codes[8].argument, 25);
}

TEST(Lower, CaseBecomesJumpsThatShareTheSelector) {
  const ir::Program p = good("CASE(R1) OF 1 GOTOF AA 2 GOTOB BB DEFAULT GOTO CC\nAA: BB: CC: M30");
  EXPECT_EQ(kinds(p), "goto goto goto end");
  EXPECT_EQ(p.at(p.jumps[0].condition).a, p.at(p.jumps[1].condition).a);
  EXPECT_EQ(p.jumps[1].search, ir::JumpSearch::backward);
  EXPECT_EQ(p.jumps[2].condition, ir::ExpressionId::none);
}

TEST(Lower, JumpTargetsAreLabelsNumbersOrStrings) {
  const ir::Program p = good(
      "DEF STRING[20] WHERE\nGOTOF end1\nGOTOB N100\nGOTO :20\nGOTOC \"end1\"\nGOTOF \"N\"<<R1\nGOTOF WHERE\nend1: "
      "M30");
  EXPECT_EQ(p.strings.at(p.jumps[0].label), "END1");
  EXPECT_EQ(p.jumps[1].number, 100U);
  EXPECT_EQ(p.jumps[2].number, 20U);
  EXPECT_TRUE(p.jumps[3].tolerant);
  EXPECT_EQ(p.jumps[3].label, p.jumps[0].label);
  EXPECT_NE(p.jumps[4].computed, ir::ExpressionId::none);
  EXPECT_NE(p.jumps[5].computed, ir::ExpressionId::none);
}

TEST(Lower, StructuresKnowTheirPartners) {
  const ir::Program p =
      good("IF R1\nR2=1\nELSE\nR2=2\nENDIF\nFOR R3=1 TO 5\nENDFOR\nREPEAT\nUNTIL R1>5\nLOOP\nENDLOOP");
  EXPECT_EQ(kinds(p), "if assign else assign endif for endfor repeat until loop endloop");
  EXPECT_EQ(p.structures[p.statements[0].payload].partner, 2U);
  EXPECT_EQ(p.structures[p.statements[2].payload].partner, 4U);
  EXPECT_EQ(p.structures[p.statements[6].payload].partner, 5U);
}

TEST(Lower, ProceduresAndDefinitions) {
  const ir::Program p = good(
      "PROC PART(REAL A, VAR INT B, STRING[20] C, REAL DD=1.5) SAVE DISPLOF\nDEF INT N1X=3, LIST[2,3]\nDEF BOOL "
      "FLAG=TRUE\nRET");
  EXPECT_EQ(p.name, "PART");
  ASSERT_EQ(p.symbols.size(), 7U);
  EXPECT_TRUE(p.structures[0].saves_modal);
  EXPECT_EQ(p.structures[0].symbol_count, 4U);
  EXPECT_TRUE(p.symbols[1].by_reference);
  EXPECT_EQ(p.symbols[2].string_length, 20);
  EXPECT_EQ(p.at(p.symbols[3].initial).value, 1.5);
  EXPECT_EQ(p.symbols[5].dimension1, 2);
  EXPECT_EQ(p.symbols[5].dimension2, 3);
  EXPECT_EQ(p.symbols[6].type, ir::ValueType::boolean);
}

TEST(Lower, ListsOfArraysBecomeAssignments) {
  const ir::Program p = good("DEF REAL A[2,2]=SET(1,2,3,4)\nDEF INT B[3]=REP(7)\nA[1,0]=SET(8,9)");
  EXPECT_EQ(kinds(p), "define assign assign assign assign define assign assign assign assign assign");
  const ir::Variable& third = p.at(p.assigns[2].target);
  EXPECT_EQ(p.at(third.index).value, 1.0);
  EXPECT_EQ(p.at(third.index2).value, 0.0);
  EXPECT_EQ(p.at(p.assigns[8].value).value, 9.0);
}

TEST(Lower, NamesOfOneLetterAndDigitsWorkOnceDefined) {
  const ir::Program p = good("DEF REAL L1,G1X\nL1=5 G1X=L1*2\nG1 X=L1+G1X\nG1 X5");
  EXPECT_EQ(kinds(p), "define assign assign block block");
  EXPECT_EQ(ir::print_same(p), "DEF REAL L1,G1X\nL1=5 G1X=L1*2\nG1 X=L1+G1X\nG1 X5");
}

TEST(Lower, CallsByNameAndNumber) {
  const ir::Program p = good("TURN_IT(1,,R3)\nL0100 P5\nP=R2 TURN_IT\nCALL \"_N_OTHER_SPF\"");
  ASSERT_EQ(p.calls.size(), 4U);
  EXPECT_EQ(p.calls[0].argument_count, 3U);
  EXPECT_EQ(p.arguments[1].value, ir::ExpressionId::none);
  EXPECT_EQ(p.strings.at(p.calls[1].name), "L0100");
  EXPECT_EQ(p.at(p.calls[1].repeats).value, 5.0);
  EXPECT_NE(p.calls[2].repeats, ir::ExpressionId::none);
  EXPECT_EQ(p.strings.at(p.calls[3].name), "OTHER");
}

TEST(Lower, PolynomialsAreWordsOfTheirAxes) {
  const ir::Program p = good("POLY PO[X]=(10,2,-3) Z=PO(IC(5))");
  ASSERT_EQ(kinds(p), "block");
  const auto words = p.words_of(p.blocks[0]);
  ASSERT_EQ(words.size(), 5U);
  EXPECT_EQ(p.codes_of(p.blocks[0])[0].function, ir::Function::polynomial);
  const ir::Address wanted[] = {ir::Address::x, ir::Address::poly_x2, ir::Address::poly_x3, ir::Address::z,
                                ir::Address::poly_z2};
  const double values[] = {10.0, 2.0, -3.0, 5.0, 0.0};
  for (std::size_t i = 0; i < words.size(); ++i) {
    EXPECT_EQ(words[i].address, wanted[i]);
    EXPECT_EQ(p.at(words[i].value).value, values[i]);
  }
  EXPECT_EQ(words[3].mode, ir::WordMode::incremental);
}

TEST(Lower, WhatIsNotReadNamesItself) {
  const ir::Program p =
      good("ID=1 WHENEVER $A_IN[1]==1 DO $A_OUT[1]=0\nWORKPIECE(,,,\"BOX\")\nPO[]=(1,2,3)\nG25 S100\n$A_OUT[2]=1");
  EXPECT_EQ(kinds(p), "native native native native assign");
  EXPECT_FALSE(p.natives[0].effects_known);
  EXPECT_TRUE(p.natives[1].effects_known);
  EXPECT_EQ(p.strings.at(p.natives[1].name), "WORKPIECE");
  EXPECT_EQ(p.strings.at(p.natives[3].name), "G25");
  EXPECT_EQ(p.strings.at(p.at(p.assigns[0].target).name), "$A_OUT");
}

TEST(Lower, HeadsNameTheProgram) {
  EXPECT_EQ(good("%_N_SHAFT123_MPF\n;$PATH=/_N_MPF_DIR\nM30").name, "SHAFT123");
  EXPECT_EQ(good("M30").name, "TEST");
}

TEST(Lower, SystemVariablesTakeAxesAsNumbers) {
  const ir::Program p = good("R1=$P_EP[Z] R2=$AA_IM[C]");
  const ir::Variable& end = p.at(p.at(p.assigns.at(0).value).variable);
  const ir::Variable& machine = p.at(p.at(p.assigns.at(1).value).variable);
  EXPECT_EQ(end.bank, ir::Bank::system);
  EXPECT_EQ(control(ir::MachineKind::mill).system_variables[end.number].name, "$P_EP");
  EXPECT_EQ(p.at(end.index).value, 2.0);
  EXPECT_EQ(p.at(machine.index).value, 5.0);
}

TEST(Lower, SkipLevels) {
  const ir::Program p = good("/X1\n/0 X1\n/9 X1\nX1");
  EXPECT_EQ(p.statements[0].skip_level, 1);
  EXPECT_EQ(p.statements[1].skip_level, 1);
  EXPECT_EQ(p.statements[2].skip_level, 10);
  EXPECT_EQ(p.statements[3].skip_level, 0);
}

TEST(Lower, OneFaultIsReportedOnce) {
  EXPECT_EQ(faults_of("G1 X=- F=R1"), "missing-operand");
  EXPECT_EQ(faults_of("=(R1-R2)/R3"), "missing-target");
  EXPECT_EQ(faults_of("R1=R2 DIV ()"), "missing-operand");
  EXPECT_EQ(faults_of("R1 5"), "missing-equals");
  EXPECT_EQ(faults_of("UNTIL R1=1000"), "syntax-error");
  EXPECT_EQ(faults_of("\xD0\x9C"
                      "30"),
            "homoglyph");
}

TEST(Infer, DecidesMillOrLatheByALine) {
  const ir::Control lathe = infer_control(text::Source("a", "T1 D1\nG96 S200 LIMS=3000\n"));
  EXPECT_EQ(lathe.kind, ir::MachineKind::lathe);
  EXPECT_EQ(lathe.because_line, 2U);
  EXPECT_EQ(lathe.axes, "XZ");
  const ir::Control mill = infer_control(text::Source("a", "R1=1\nG0 Y5 C90\nG18\n"));
  EXPECT_EQ(mill.kind, ir::MachineKind::mill);
  EXPECT_EQ(mill.because_line, 2U);
  EXPECT_EQ(mill.axes, "XYZC");
  EXPECT_EQ(infer_control(text::Source("a", "; G96 in a comment\nX1\n")).because_line, 0U);
}

// How many elements a list fills may be computed, missing or beyond all arrays: then it is kept as written, and nothing
// is claimed of it.
TEST(Lower, ListsOfValuesWithoutACertainCountAreKeptAsWritten) {
  const std::string array = "DEF REAL A[3]\n";
  EXPECT_EQ(read_text("R[10]=REP(5,3)").program.assigns.size(), 3U);
  EXPECT_EQ(read_text(array + "A[0]=REP(5,2)").program.assigns.size(), 2U);
  for (const char* fill : {"R[10]=REP(5)", "R[10]=REP(5,R1)", "R[10]=REP(5,-1)", "R[10]=REP(5,)", "R[10]=REP()",
                           "R[10]=REP(5,4000000000)", "R[10]=REP(5,1000000)", "A[0]=REP(1,R1)"}) {
    const ir::ReadResult read = read_text(array + fill + "\nM30");
    EXPECT_EQ(read.program.assigns.size(), 0U) << fill;
    EXPECT_TRUE(!read.program.natives.empty() || text::has_error(read.diagnostics)) << fill;
  }
}

TEST(Lower, ListsOfValuesOfAllBlocksTogetherAreLimited) {
  std::string text;
  for (int i = 0; i < 100; ++i) text += "R[0]=REP(1,20000)\n";
  EXPECT_LE(read_text(text).program.assigns.size(), 200'000U);
}

}  // namespace
}  // namespace dripfeed::sinumerik
